// frames.csv: a row for each evaluation; numbers all through, but for where it is from at the end.
#pragma once

#include <string>

#include "replay.hpp"
#include "row_origin.hpp"

namespace footprint_collision_predictor::tools {

/// The first line, up to the last segment, of a file whose rows have up to so many.
std::string framesHeader(std::size_t segments);

/// A row up to its last segment. The footprint may come from a topic, so how many segments there
/// will be, and how much the row has to be filled up, is known at the end only.
std::string framesRow(const Evaluation& evaluation);

/// What the row lacks.
std::string framesRowEnd(std::size_t segments_in_row, std::size_t segments,
                         const RowOrigin& origin);

/// How many segments a row without its end has.
std::size_t segmentsIn(const std::string& row);

}  // namespace footprint_collision_predictor::tools
