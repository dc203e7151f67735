// The command line of analyze_bag.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace footprint_collision_predictor::tools {

struct Options {
  std::vector<std::string> bags;

  // Topics; empty: found by their types.
  std::string obstacles;
  std::string footprint;
  std::string odom;

  double start = 0;                ///< [s] since the bag's begin
  std::optional<double> duration;  ///< [s] nothing: to the end

  std::string params;           ///< YAML file of the node's parameters; empty: none
  XmlRpc::XmlRpcValue changes;  ///< the node's parameters that have options of their own; these win

  std::string output;                ///< folder; empty: nothing is written
  bool no_report = false;            ///< report.html is left out
  std::optional<double> fail_under;  ///< [s]
  double max_unknown = 5;            ///< [%]
  unsigned jobs = 1;
  bool dry_run = false;
  bool quiet = false;
};

/// \return the options, or the exit status when there is nothing more to do: help or version asked
///     for, or a mistake, which has been named on stderr
std::variant<Options, int> parseCommandLine(int argc, const char* const* argv);

}  // namespace footprint_collision_predictor::tools
