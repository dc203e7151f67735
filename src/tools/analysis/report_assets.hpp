// The pages of ../report with everything they need, as CMake puts them together.
#pragma once

#include <string_view>

namespace footprint_collision_predictor::tools {

/// A page with a gap for the JSON that it shows.
struct PageText {
  std::string_view before_data;
  std::string_view after_data;
};

PageText reportPage();
PageText reportListPage();

}  // namespace footprint_collision_predictor::tools
