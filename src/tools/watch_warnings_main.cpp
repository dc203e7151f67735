// watch_warnings: prints collision warnings for a person, and compares them with a scenario's
// answers.
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>

#include "exit_status.hpp"
#include "expectation.hpp"
#include "warning_line.hpp"

namespace {

using footprint_collision_predictor::CollisionWarning;
using namespace footprint_collision_predictor::tools;

struct Options {
  double rate = 5;      // [Hz]
  double timeout = 15;  // [s]
  std::string expect;
};

class Watcher {
 public:
  Watcher(const Options& options, const std::optional<Answers>& answers)
      : options_(options), coloured_(isatty(STDOUT_FILENO) && std::getenv("NO_COLOR") == nullptr) {
    if (answers) expectation_.emplace(*answers);
    ros::NodeHandle node;
    subscriber_ = node.subscribe("collision_warning", 1000, &Watcher::take, this);
  }

  /// Until the scenario is over, time stands still for too long, or somebody ends it.
  int run() {
    while (ros::ok() && !isOver()) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
      remarkSilence();
    }
    if (!expectation_) return kSuccess;
    std::printf("\n%s", expectation_->summary().c_str());
    std::fflush(stdout);
    return expectation_->exitStatus();
  }

 private:
  struct Printed {
    CollisionWarning warning;
    ros::SteadyTime at;
  };

  bool isOver() const {
    if (!expectation_) return false;
    return expectation_->isOver() ||
           ros::SteadyTime::now() - progress_ > ros::WallDuration(options_.timeout);
  }

  void take(const CollisionWarning& warning) {
    last_ = ros::SteadyTime::now();
    remarked_ = false;
    if (expectation_) {
      const double before = expectation_->newest();
      if (expectation_->isOver()) return;
      expectation_->take(warning);
      if (expectation_->newest() > before) progress_ = last_;
    }
    const auto found = printed_.find(warning.footprint);
    const bool due = found == printed_.end() || saysSomethingElse(found->second.warning, warning) ||
                     (last_ - found->second.at).toSec() * options_.rate >= 1;
    if (!due) return;
    print(warningLine(warning, timeOf(warning.header.stamp), coloured_));
    printed_[warning.footprint] = {warning, last_};
  }

  std::optional<double> timeOf(const ros::Time& stamp) {
    if (expectation_) return expectation_->timeOf(stamp);
    if (stamp.isZero()) return std::nullopt;
    if (!first_) first_ = stamp;
    return (stamp - *first_).toSec();
  }

  /// The predictor sends heartbeats, so silence is news.
  void remarkSilence() {
    if (remarked_ || ros::SteadyTime::now() - last_ < ros::WallDuration(2)) return;
    print("no warning on " + subscriber_.getTopic() + " for 2 s: is predictor_node running?");
    remarked_ = true;
  }

  static void print(const std::string& line) {
    std::printf("%s\n", line.c_str());
    // It may be read through a pipe, as it comes, by somebody who has seen enough.
    if (std::fflush(stdout) != 0) ros::requestShutdown();
  }

  Options options_;
  bool coloured_;
  std::optional<Expectation> expectation_;
  ros::Subscriber subscriber_;
  std::map<std::string, Printed> printed_;  // by footprint
  std::optional<ros::Time> first_;
  ros::SteadyTime last_ = ros::SteadyTime::now();
  ros::SteadyTime progress_ = ros::SteadyTime::now();
  bool remarked_ = false;
};

constexpr const char* kFooter =
    "Examples:\n"
    "  watch_warnings\n"
    "  watch_warnings collision_warning:=/robot1/collision_warning\n"
    "  watch_warnings --expect crossing.json    (as written by make_scenario)\n"
    "\n"
    "Exit status: 0 ended or agrees, 1 disagrees, 2 wrong command line, 3 no warning came,\n"
    "4 cannot read the answers.\n";

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Prints a line for each change of the collision warnings, and some in between.",
               "watch_warnings");
  app.footer(kFooter);
  app.add_option("--rate", options.rate,
                 "lines per second without a change, 0 for none (default: 5)")
      ->check(CLI::Range(0.0, 1000.0));
  app.add_option("--expect", options.expect, "compare with these answers and end with them");
  app.add_option("--timeout", options.timeout,
                 "with --expect: end when time stands still for this long [s] (default: 15)")
      ->check(CLI::Range(0.1, 3600.0));
  ros::V_string arguments;
  ros::removeROSArgs(argc, argv, arguments);
  std::vector<char*> pointers;
  for (auto& argument : arguments) pointers.push_back(argument.data());
  try {
    app.parse(static_cast<int>(pointers.size()), pointers.data());
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kSuccess : kUsage;
  }
  std::optional<Answers> answers;
  try {
    if (!options.expect.empty()) answers = readAnswers(options.expect);
  } catch (const ReadError& error) {
    std::fprintf(stderr, "watch_warnings: %s\n", error.what());
    return kCannotRead;
  }
  ros::init(argc, argv, "watch_warnings", ros::init_options::AnonymousName);
  return Watcher(options, answers).run();
}
