// report.html: the page of one report, and the list of several.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "bag_analysis.hpp"
#include "film.hpp"

namespace footprint_collision_predictor::tools {

/// Where the page of a report goes, relative to the output folder: report.html, and of several
/// reports/0001_NAME.html, ...
/// \param index of the report, of `count`
std::string pageName(const BagReport& report, std::size_t index, std::size_t count);

/// One file that needs no other and no network. The text of a bag (names, messages) is data there,
/// never markup.
void writeReport(const BagReport& report, const Film& film, const Options& options,
                 const Parameters& parameters, std::ostream& out);

/// The reports, the nearest to a contact first.
void writeReportList(const std::vector<BagReport>& reports, const Options& options,
                     std::ostream& out);

}  // namespace footprint_collision_predictor::tools
