// analyze_bag: a whole recording through the evaluation of the live node.
#include <console_bridge/console.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <memory>
#include <set>
#include <thread>

#include "../exit_status.hpp"
#include "analysis_status.hpp"
#include "bag_analysis.hpp"
#include "interruption.hpp"
#include "node_parameters.hpp"
#include "outcome.hpp"
#include "report_page.hpp"
#include "summary.hpp"
#include "yaml_parameters.hpp"

namespace {

using namespace footprint_collision_predictor;
using namespace footprint_collision_predictor::tools;

void complain(const std::string& text) { std::fprintf(stderr, "analyze_bag: %s\n", text.c_str()); }

std::vector<BagReport> analyzeAll(const Options& options, const BagAnalysis& analysis,
                                  OutputFolder* output) {
  std::vector<BagReport> reports(analysis.count());
  Progress progress(progressStyle(options.quiet), reports.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < reports.size(); i = next++)
      reports[i] = analysis.analyze(i, output, progress);
  };
  std::vector<std::thread> others(std::min<std::size_t>(options.jobs, reports.size()) - 1);
  for (std::thread& other : others) other = std::thread(work);
  work();
  for (std::thread& other : others) other.join();
  return reports;
}

void write(const std::vector<BagReport>& reports, const Options& options,
           const Parameters& parameters, OutputFolder& output) {
  std::vector<RowOrigin> origins;
  for (const BagReport& report : reports) origins.push_back({report.footprint, report.bag});
  output.writeFrames(origins);
  std::string events = eventsHeader() + originHeader(origins.front()) + "\n";
  for (std::size_t i = 0; i < reports.size(); ++i)
    for (const Event& event : reports[i].events)
      events += eventsRow(event) + originColumns(origins[i]) + "\n";
  output.write("events.csv", events);
  output.write("summary.json", jsonText(summaryJson(reports, options, parameters), 1) + "\n");
  if (options.no_report) return;
  output.finishPages();
  if (reports.size() > 1)
    output.write("report.html", [&](std::ostream& out) { writeReportList(reports, options, out); });
}

/// Each problem once, though it may stop every body's analysis of a bag.
void complainOf(const std::vector<BagReport>& reports) {
  std::set<std::string> told;
  for (const BagReport& report : reports)
    if (!report.problem.empty() && told.insert(report.problem).second) complain(report.problem);
}

int plan(const Parameters& parameters, const BagAnalysis& analysis) {
  std::vector<BagReport> reports;
  int status = kDone;
  for (std::size_t i = 0; i < analysis.count(); ++i) {
    reports.push_back(analysis.look(i));
    std::printf("%s", planText(reports.back(), parameters, analysis.bodyAt(i)).c_str());
    if (reports.back().problem.empty()) continue;
    status = status == kUsage ? kUsage : reports.back().status;
  }
  complainOf(reports);
  return status;
}

int run(const Options& options) {
  const Parameters parameters = parametersOf(options);
  const BagAnalysis analysis(options, parameters);
  std::unique_ptr<OutputFolder> output;
  if (!options.output.empty())
    output = std::make_unique<OutputFolder>(options.output, analysis.count());
  if (options.dry_run) return plan(parameters, analysis);
  watchForInterruption();
  const auto reports = analyzeAll(options, analysis, output.get());
  if (output) write(reports, options, parameters, *output);
  complainOf(reports);
  for (const BagReport& report : reports) std::printf("%s", summaryText(report, options).c_str());
  if (isInterrupted()) complain("interrupted: the results are partial");
  return exitStatus(reports, options, isInterrupted());
}

}  // namespace

int main(int argc, char** argv) try {
  // tf2 would write a line for every transform that it has already or that comes too late; they are
  // counted instead.
  console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  const auto options = parseCommandLine(argc, argv);
  if (const int* status = std::get_if<int>(&options)) return *status;
  return run(std::get<Options>(options));
} catch (const ParameterError& error) {
  complain(error.what());
  return kUsage;
} catch (const ParameterFileError& error) {
  complain(error.what());
  return kUsage;
} catch (const WriteError& error) {
  complain(error.what());
  return kCannotWrite;
}
