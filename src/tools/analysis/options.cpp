#include "options.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "../exit_status.hpp"
#include "../misspelt_option.hpp"

namespace footprint_collision_predictor::tools {
namespace {

constexpr const char* kDescription =
    "Analyses recordings with the evaluation of the live node: when was it close, with what, and "
    "for how\nlong could it not be told. Needs no master. Results go to stdout, everything else to "
    "stderr.";

constexpr const char* kExamples =
    "Examples:\n"
    "  analyze_bag drive.bag --footprint-polygon \"[[0.3, 0.2], [-0.3, 0.2], [-0.3, -0.2], "
    "[0.3, -0.2]]\"\n"
    "  analyze_bag drive.bag --params predictor.yaml -o analysis\n"
    "  analyze_bag hall.bag --params predictor.yaml --ego-motion static --base-frame laser\n"
    "  analyze_bag *.bag --params predictor.yaml --jobs 4 -o analysis\n"
    "  analyze_bag drive.bag --params predictor.yaml --fail-under 0.5 --quiet    (a CI gate)\n"
    "\n"
    "Exit status: 0 done, 1 a time to collision is under --fail-under, 2 wrong command line or no\n"
    "fitting topic, 3 a bag cannot be read, 4 nothing could be evaluated or, with --fail-under, "
    "more\nthan --max-unknown percent is UNKNOWN, 5 cannot write, 130 interrupted. Of several, the "
    "first of\n130, 5, 1, 2, 3, 4.\n";

constexpr double kLongest = 1e9;  // [s] of a recording

/// Options that set one of the node's parameters, which are validated with the others.
class Changes {
 public:
  Changes(CLI::App& app, XmlRpc::XmlRpcValue& values) : app_(app), values_(values) {}

  void number(const std::string& option, const std::string& parameter, const std::string& help) {
    app_.add_option_function<double>(
        option, [this, parameter](double value) { values_[parameter] = value; }, help);
  }
  void text(const std::string& option, const std::string& parameter, const std::string& help) {
    app_.add_option_function<std::string>(
        option, [this, parameter](const std::string& value) { values_[parameter] = value; }, help);
  }

 private:
  CLI::App& app_;
  XmlRpc::XmlRpcValue& values_;
};

void addInputs(CLI::App& app, Options& options) {
  app.add_option("BAG", options.bags, "recordings")->expected(0, -1);
  app.add_option("--obstacles", options.obstacles, "topic of the obstacles (default: by type)");
  app.add_option("--footprint", options.footprint,
                 "topic of a single footprint (default: by type)");
  app.add_option("--odom", options.odom, "topic of the odometry (default: by type)");
  app.add_option("--start", options.start, "begin so many seconds after the bag's begin")
      ->check(CLI::Range(0.0, kLongest));
  app.add_option("--duration", options.duration, "analyse so many seconds (default: to the end)")
      ->check(CLI::Range(0.0, kLongest));
}

void addParameters(CLI::App& app, Options& options, Changes& changes) {
  app.add_option("--params", options.params, "YAML file of the node's parameters");
  changes.text("--footprint-polygon", "footprint", "[[x, y], ...] in the base frame [m]");
  changes.number("--horizon", "horizon", "how far ahead contacts are looked for [s]");
  changes.number("--warn", "warn_time", "WARN at or below this time to collision [s]");
  changes.number("--critical", "critical_time", "CRITICAL likewise [s]");
  changes.text("--base-frame", "base_frame", "the footprint's body frame");
  changes.text("--fixed-frame", "fixed_frame", "a frame that stands still on the ground");
  changes.text("--ego-motion", "ego_motion", "odom, or static for what stands still");
  changes.text("--obstacle-velocity", "obstacle_velocity", "over_ground or relative");
  changes.text("--obstacle-detector-radius", "obstacle_detector_radius", "true_radius or radius");
}

void addOutputs(CLI::App& app, Options& options) {
  app.add_option("-o,--output", options.output,
                 "folder for report.html, frames.csv, events.csv and summary.json (default: write "
                 "nothing)");
  app.add_flag("--no-report", options.no_report, "with -o: leave out report.html");
  app.add_option("--fail-under", options.fail_under,
                 "exit status 1 when a time to collision is under this [s]")
      ->check(CLI::Range(0.0, kLongest));
  app.add_option("--max-unknown", options.max_unknown,
                 "how much of the time [%] may be UNKNOWN for \"no contact\" to be said, and for\n"
                 "status 0 with --fail-under (default: 5)")
      ->check(CLI::Range(0.0, 100.0));
  app.add_option("--jobs", options.jobs, "bags to analyse side by side (default: 1)")
      ->check(CLI::Range(1u, 256u));
  app.add_flag("--dry-run", options.dry_run, "say what would be analysed, and end");
  app.add_flag("--quiet", options.quiet, "no progress");
}

int mistake(const std::string& text) {
  std::fprintf(stderr, "analyze_bag: %s (see analyze_bag --help)\n", text.c_str());
  return kUsage;
}

}  // namespace

std::variant<Options, int> parseCommandLine(int argc, const char* const* argv) {
  Options options;
  CLI::App app(kDescription, "analyze_bag");
  app.footer(kExamples);
  app.set_version_flag("--version", "analyze_bag " PACKAGE_VERSION);
  app.allow_extras();  // so that a misspelt one can be told from a missing one
  Changes changes(app, options.changes);
  addInputs(app, options);
  addParameters(app, options, changes);
  addOutputs(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked_for) {
    return app.exit(asked_for);
  } catch (const CLI::ParseError& error) {
    return mistake(error.what());
  }
  if (const auto misspelt = misspeltOption(app)) return mistake(*misspelt);
  if (options.bags.empty()) return mistake("which bag?");
  return options;
}

}  // namespace footprint_collision_predictor::tools
