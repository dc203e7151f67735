// report.html: the page of one bag, and the list of several.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "bag_analysis.hpp"
#include "film.hpp"

namespace footprint_collision_predictor::tools {

/// Where the page of a bag goes, relative to the output folder: report.html, and for several bags
/// reports/0001_NAME.html, ...
std::string pageName(const Options& options, std::size_t bag);

/// One file that needs no other and no network. The text of a bag (names, messages) is data there,
/// never markup.
void writeReport(const BagReport& report, const Film& film, const Options& options,
                 const Parameters& parameters, std::ostream& out);

/// The bags, the nearest to a contact first.
void writeReportList(const std::vector<BagReport>& reports, const Options& options,
                     std::ostream& out);

}  // namespace footprint_collision_predictor::tools
