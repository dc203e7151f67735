#include "bag_analysis.hpp"

#include "../exit_status.hpp"
#include "analysis_status.hpp"
#include "bag_problem.hpp"
#include "interruption.hpp"
#include "report_page.hpp"

namespace footprint_collision_predictor::tools {
namespace {

double seconds(const Window& window) { return (window.end - window.begin).toSec(); }

}  // namespace

BagReport BagAnalysis::begun(std::size_t index) const {
  BagReport report;
  report.bag = options_.bags.at(index / bodies_.size());
  if (bodies_.size() > 1) report.footprint = bodyAt(index).name;
  report.page = pageName(report, index, count());
  return report;
}

BagReport BagAnalysis::analyze(std::size_t index, OutputFolder* output, Progress& progress) const {
  BagReport report = begun(index);
  std::optional<Film> film;
  if (output != nullptr && !options_.no_report) film.emplace(parameters_.thresholds.warn_time);
  try {
    run(index, output, film ? &*film : nullptr, progress, report);
    progress.set(index, 1);
  } catch (const BagProblem& problem) {
    report.status = problem.status();
    report.problem = problem.what();
    report.partial = report.statistics.evaluations() > 0;
  }
  if (film)
    output->writePage(index, report.page, [&](std::ostream& out) {
      writeReport(report, *film, options_, parameters_, out);
    });
  return report;
}

BagReport BagAnalysis::look(std::size_t index) const {
  BagReport report = begun(index);
  try {
    const Recording recording(report.bag);
    report.window = windowOf(recording.span(), report.bag);
    report.topics =
        chooseTopics(report.bag, recording.topics(), options_, parameters_, bodyAt(index));
  } catch (const BagProblem& problem) {
    report.status = problem.status();
    report.problem = problem.what();
  }
  return report;
}

void BagAnalysis::run(std::size_t index, OutputFolder* output, Film* film, Progress& progress,
                      BagReport& report) const {
  if (isInterrupted()) {
    report.partial = true;
    return;
  }
  const Recording recording(report.bag);
  report.window = windowOf(recording.span(), report.bag);
  report.topics =
      chooseTopics(report.bag, recording.topics(), options_, parameters_, bodyAt(index));
  EventFinder events(parameters_.thresholds.warn_time, parameters_.max_data_age);
  const auto take = [&](const Evaluation& evaluation) {
    report.statistics.take(evaluation);
    events.take(evaluation);
    if (output != nullptr) output->rows(index).take(evaluation);
    if (film != nullptr) film->take(evaluation);
  };
  Replay replay(parameters_, bodyAt(index), report.topics.names, report.window, take);
  ros::Time reached = report.window.begin;
  const auto finish = [&](const ros::Time& end) {
    replay.finish(end);
    report.statistics.finish((end - report.window.begin).toSec());
    report.events = events.finish();
    report.refused_transforms = replay.refusedTransforms();
  };
  try {
    recording.read(
        report.window, report.topics.inputs, [] { return !isInterrupted(); },
        [&](const RecordedMessage& message) {
          reached = std::max(reached, message.recorded);
          replay.take(message);
          progress.set(index, (reached - report.window.begin).toSec() /
                                  std::max(seconds(report.window), 1e-9));
        });
  } catch (const BagProblem&) {
    finish(reached);
    throw;
  }
  report.partial = isInterrupted() && reached < report.window.end;
  finish(report.partial ? reached : report.window.end);
}

Window BagAnalysis::windowOf(const Window& span, const std::string& bag) const {
  Window window = span;
  if (options_.start > seconds(span))
    throw BagProblem(kUsage, bag + ": --start " + std::to_string(options_.start) +
                                 " is beyond its end: it is " + std::to_string(seconds(span)) +
                                 " s long");
  window.begin += ros::Duration(options_.start);
  if (options_.duration && *options_.duration < seconds(window))
    window.end = window.begin + ros::Duration(*options_.duration);
  return window;
}

}  // namespace footprint_collision_predictor::tools
