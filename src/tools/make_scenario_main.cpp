// make_scenario: writes a bag whose collision is known exactly, and the answers beside it.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "exit_status.hpp"
#include "scenario_writer.hpp"
#include "suggestion.hpp"

namespace {

using namespace footprint_collision_predictor::tools;

constexpr const char* kExamples =
    "Examples:\n"
    "  make_scenario --list\n"
    "  make_scenario crossing -o crossing.bag\n"
    "  roslaunch footprint_collision_predictor demo.launch \\\n"
    "    bag:=$PWD/crossing.bag expect:=$PWD/crossing.json\n"
    "\n"
    "Exit status: 0 written, 2 wrong command line, 5 cannot write.\n";

constexpr double kLongest = 3600;  // [s]

void list() {
  for (const auto& s : scenarios()) std::printf("%-10s %s\n", s.name.c_str(), s.summary.c_str());
}

int unknownScenario(const std::string& name) {
  std::vector<std::string> names;
  for (const auto& s : scenarios()) names.push_back(s.name);
  const std::string similar = footprint_collision_predictor::nearestName(name, names);
  std::fprintf(stderr, "make_scenario: there is no scenario \"%s\".", name.c_str());
  if (!similar.empty()) std::fprintf(stderr, " Did you mean \"%s\"?", similar.c_str());
  std::fprintf(stderr, " Known are:");
  for (const auto& known : names) std::fprintf(stderr, " %s", known.c_str());
  std::fprintf(stderr, "\n");
  return kUsage;
}

int usageError(const std::string& text) {
  std::fprintf(stderr, "make_scenario: %s. See make_scenario --help\n", text.c_str());
  return kUsage;
}

int write(const Scenario& scenario, double duration, const std::string& bag) {
  const std::string json = std::filesystem::path(bag).replace_extension(".json").string();
  try {
    writeBag(scenario, duration, bag);
    writeJson(expectedAnswers(scenario, duration), json);
  } catch (const WriteError& error) {
    std::fprintf(stderr, "make_scenario: %s. Choose another place with -o FILE.bag\n",
                 error.what());
    return kCannotWrite;
  }
  std::printf("%s: %s\n%s: the exact answers\n", bag.c_str(), scenario.summary.c_str(),
              json.c_str());
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  std::string name;
  std::string bag;
  double duration = 8;
  bool only_list = false;
  CLI::App app(
      "Writes a bag (topics obstacles, odom, /tf) of a robot that drives straight, for "
      "which the time to\ncollision is known exactly, and the answers beside it as JSON.",
      "make_scenario");
  app.footer(kExamples);
  app.add_option("name", name, "the scenario; --list shows them");
  app.add_option("-o,--output", bag, "bag to write, overwritten if there (default: NAME.bag)");
  app.add_option("--duration", duration, "length [s], 0.1 to 3600 (default: 8)");
  app.add_flag("--list", only_list, "list the scenarios and end");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kSuccess : kUsage;
  }
  if (only_list) return list(), kSuccess;
  if (name.empty()) return usageError("which scenario? --list shows them");
  const Scenario* scenario = findScenario(name);
  if (scenario == nullptr) return unknownScenario(name);
  if (!(duration >= 0.1 && duration <= kLongest)) {
    return usageError("--duration must be from 0.1 to 3600 s");
  }
  if (bag.empty()) bag = name + ".bag";
  if (std::filesystem::path(bag).extension() != ".bag") {
    return usageError("the output must end in .bag, and \"" + bag + "\" does not");
  }
  return write(*scenario, duration, bag);
}
