// analyze_bag: a whole recording through the evaluation of the live node.
#include <console_bridge/console.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <memory>
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
  std::vector<BagReport> reports(options.bags.size());
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
  output.writeFrames(options.bags);
  std::string events = eventsHeader() + "\n";
  for (const BagReport& report : reports)
    for (const Event& event : report.events) events += eventsRow(event, report.bag) + "\n";
  output.write("events.csv", events);
  output.write("summary.json", jsonText(summaryJson(reports, options, parameters), 1) + "\n");
  if (options.no_report) return;
  output.finishPages();
  if (reports.size() > 1)
    output.write("report.html", [&](std::ostream& out) { writeReportList(reports, options, out); });
}

int plan(const Options& options, const Parameters& parameters, const BagAnalysis& analysis) {
  int status = kDone;
  for (std::size_t i = 0; i < options.bags.size(); ++i) {
    const BagReport report = analysis.look(i);
    std::printf("%s", planText(report, parameters).c_str());
    if (report.problem.empty()) continue;
    complain(report.problem);
    status = status == kUsage ? kUsage : report.status;
  }
  return status;
}

int run(const Options& options) {
  const Parameters parameters = parametersOf(options);
  std::unique_ptr<OutputFolder> output;
  if (!options.output.empty())
    output = std::make_unique<OutputFolder>(options.output, options.bags.size());
  const BagAnalysis analysis(options, parameters);
  if (options.dry_run) return plan(options, parameters, analysis);
  watchForInterruption();
  const auto reports = analyzeAll(options, analysis, output.get());
  if (output) write(reports, options, parameters, *output);
  for (const BagReport& report : reports) {
    if (!report.problem.empty()) complain(report.problem);
    std::printf("%s", summaryText(report, options).c_str());
  }
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
