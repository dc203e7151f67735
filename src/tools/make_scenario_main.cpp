// make_scenario: writes a bag whose collision is known exactly, and the answers beside it.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "exit_status.hpp"
#include "misspelt_option.hpp"
#include "scenario_writer.hpp"
#include "suggestion.hpp"

namespace {

using namespace footprint_collision_predictor::tools;

constexpr const char* kExamples =
    "Examples:\n"
    "  make_scenario --list\n"
    "  make_scenario crossing -o crossing.bag\n"
    "  make_scenario crowd --count 50 --seed 7 --duration 60\n"
    "  roslaunch footprint_collision_predictor demo.launch \\\n"
    "    bag:=$PWD/crossing.bag expect:=$PWD/crossing.json\n"
    "\n"
    "Exit status: 0 written, 2 wrong command line, 5 cannot write.\n";

void list() {
  for (const auto& s : scenarioKinds())
    std::printf("%-16s %s\n", s.name.c_str(), s.summary.c_str());
}

int unknownScenario(const std::string& name) {
  std::vector<std::string> names;
  for (const auto& s : scenarioKinds()) names.push_back(s.name);
  const std::string similar = footprint_collision_predictor::nearestName(name, names);
  std::fprintf(stderr, "make_scenario: there is no scenario \"%s\".", name.c_str());
  if (!similar.empty()) std::fprintf(stderr, " Did you mean \"%s\"?", similar.c_str());
  std::fprintf(stderr, " Known are:");
  for (const auto& known : names) std::fprintf(stderr, " %s", known.c_str());
  std::fprintf(stderr, "\n");
  return kUsage;
}

int usageError(const std::string& text) {
  std::fprintf(stderr, "make_scenario: %s (see make_scenario --help)\n", text.c_str());
  return kUsage;
}

int write(const ScenarioKind& kind, const ScenarioOptions& options, const std::string& bag) {
  const std::string json = std::filesystem::path(bag).replace_extension(".json").string();
  Scenario scenario = kind.make(options);
  scenario.name = kind.name;
  scenario.summary = kind.summary;
  try {
    writeBag(scenario, options, bag);
    writeJson(expectedAnswers(scenario, options), json);
  } catch (const WriteError& error) {
    std::fprintf(stderr, "make_scenario: %s. Choose another place with -o FILE.bag\n",
                 error.what());
    return kCannotWrite;
  }
  std::printf("%s: %s\n%s: the exact answers\n", bag.c_str(), scenario.summary.c_str(),
              json.c_str());
  return kSuccess;
}

void addChoices(CLI::App& app, ScenarioOptions& options) {
  const auto number = [&](const char* name, auto& target, const char* help, double low,
                          double high) {
    app.add_option(name, target, help)->check(CLI::Range(low, high));
  };
  number("--speed", options.speed, "of the robot [m/s], 0 to 10 (default: the scenario's)", 0, 10);
  number("--radius", options.radius, "of the obstacles that matter [m], 0.05 to 5", 0.05, 5);
  number("--rate", options.rate, "obstacles messages per second, 1 to 100 (default: 10)", 1, 100);
  number("--duration", options.duration, "length [s], 0.1 to 86400 (default: 8)", 0.1, 86400);
  number("--noise", options.noise,
         "standard deviation of measured positions [m], 0 to 1 (default: 0); the answers are those "
         "to what was measured",
         0, 1);
  app.add_option("--seed", options.seed, "of crowd and noise (default: 1)");
  app.add_option("--count", options.count, "pedestrians of a crowd, 0 to 1000 (default: 20)")
      ->check(CLI::Range(0, 1000));
}

}  // namespace

int main(int argc, char** argv) {
  std::string name;
  std::string bag;
  ScenarioOptions options;
  bool only_list = false;
  CLI::App app(
      "Writes a bag (topics obstacles, odom, /tf) of a robot for which the time to collision is "
      "known\nexactly, and the answers beside it as JSON.",
      "make_scenario");
  app.footer(kExamples);
  app.allow_extras();
  app.add_option("name", name, "the scenario; --list shows them");
  app.add_option("-o,--output", bag, "bag to write, overwritten if there (default: NAME.bag)");
  addChoices(app, options);
  app.add_flag("--list", only_list, "list the scenarios and end");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kSuccess : kUsage;
  }
  if (const auto misspelt = misspeltOption(app)) return usageError(*misspelt);
  if (only_list) return list(), kSuccess;
  if (name.empty()) return usageError("which scenario? --list shows them");
  const ScenarioKind* kind = findScenario(name);
  if (kind == nullptr) return unknownScenario(name);
  if (options.speed && !kind->has_speed)
    return usageError("the robot of " + name + " turns on the spot and has no --speed");
  if (bag.empty()) bag = name + ".bag";
  if (std::filesystem::path(bag).extension() != ".bag") {
    return usageError("the output must end in .bag, and \"" + bag + "\" does not");
  }
  return write(*kind, options, bag);
}
