// "Did you mean ...?" for the options of the command-line tools.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "suggestion.hpp"

namespace footprint_collision_predictor::tools {

/// Names the first argument that is no option of the app, which must allow extras.
inline std::optional<std::string> misspeltOption(const CLI::App& app) {
  const std::vector<std::string> extras = app.remaining();
  if (extras.empty()) return std::nullopt;
  const std::string written = extras.front().substr(0, extras.front().find('='));
  std::vector<std::string> known;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  const std::string meant = nearestName(written, known);
  return "unknown option " + written + (meant.empty() ? "" : "; did you mean " + meant + "?");
}

}  // namespace footprint_collision_predictor::tools
