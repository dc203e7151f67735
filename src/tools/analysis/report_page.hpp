// report.html: the page of one bag, and the list of several.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "bag_analysis.hpp"
#include "film.hpp"

namespace footprint_collision_predictor::tools {

/// Where a page goes, relative to the output folder: report.html, and of several
/// reports/0001_NAME.html, ..., which report.html lists then.
/// \param index of the report among `count`
std::string pageName(const BagReport& report, std::size_t index, std::size_t count);

/// One file that needs no other and no network. The text of a bag (names, messages) is data there,
/// never markup.
/// \param listed whether report.html lists this one among others
void writeReport(const BagReport& report, const Film& film, const Options& options,
                 const Parameters& parameters, bool listed, std::ostream& out);

/// The bags, the nearest to a contact first.
void writeReportList(const std::vector<BagReport>& reports, const Options& options,
                     std::ostream& out);

}  // namespace footprint_collision_predictor::tools
