#include <cmath>
#include <cstdio>

#include "../warning_line.hpp"
#include "outcome.hpp"
#include "summary.hpp"

namespace footprint_collision_predictor::tools {
namespace {

constexpr std::size_t kMostEvents = 5;

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

std::string with(const WorstMoment& worst) {
  std::string text = format("segment %d", worst.segment);
  if (worst.obstacle_id >= 0)
    return text + format(", obstacle %lld", static_cast<long long>(worst.obstacle_id));
  if (worst.obstacle_index >= 0) text += format(", obstacle [%d]", worst.obstacle_index);
  return text;
}

std::string levels(const Statistics& s) {
  std::string text;
  for (const auto level : {CollisionWarning::CLEAR, CollisionWarning::WARN,
                           CollisionWarning::CRITICAL, CollisionWarning::UNKNOWN}) {
    const double seconds = s.secondsAt().at(level);
    text += format("%s%s %.1f s (%.1f %%)", text.empty() ? "" : ", ", levelName(level).c_str(),
                   seconds, s.seconds() > 0 ? 100 * seconds / s.seconds() : 0.0);
  }
  return text;
}

std::string eventLine(const Event& event) {
  return format("    %8.2f to %8.2f s  %-8s  %s at %.2f s, ", event.begin, event.end,
                levelName(event.level).c_str(),
                event.contact
                    ? "contact"
                    : format("time to collision %.2f s", event.worst.time_to_collision).c_str(),
                event.worst.elapsed) +
         with(event.worst) + "\n";
}

std::string eventLines(const std::vector<Event>& events) {
  std::string text;
  for (std::size_t i = 0; i < events.size() && i < kMostEvents; ++i) text += eventLine(events[i]);
  if (events.size() > kMostEvents)
    text += format("    and %zu more: see events.csv of -o DIR\n", events.size() - kMostEvents);
  return text;
}

std::string reasonLines(const Statistics& s) {
  std::string text;
  for (const auto& [bit, count] : s.reasons())
    text += format("    %s in %zu of %zu (%.1f %%), first: ", reasonName(bit).c_str(),
                   count.evaluations, s.evaluations(),
                   100.0 * static_cast<double>(count.evaluations) /
                       static_cast<double>(s.evaluations())) +
            count.first_message + "\n";
  return text;
}

std::string nameOf(const BagReport& report) {
  return report.bag + (report.footprint.empty() ? "" : " [" + report.footprint + "]");
}

}  // namespace

std::string verdictText(const BagReport& report, const Options& options) {
  const Statistics& s = report.statistics;
  switch (s.verdict(options.max_unknown)) {
    case Verdict::kContact:
      return format("CONTACT at %.2f s: ", s.worst()->elapsed) + with(*s.worst());
    case Verdict::kPredicted:
      return format("no contact; nearest to one at %.2f s: time to collision %.2f s, ",
                    s.worst()->elapsed, s.worst()->time_to_collision) +
             with(*s.worst());
    case Verdict::kNone:
      return "no contact was ever predicted";
    default:
      return "CANNOT TELL: too little of the recording could be evaluated";
  }
}

std::string summaryText(const BagReport& report, const Options& options) {
  const Statistics& s = report.statistics;
  if (s.evaluations() == 0)
    return nameOf(report) + ": " +
           (report.partial ? "partial: interrupted before its begin" : "no result") + "\n";
  std::string text = nameOf(report) + ": " + verdictText(report, options) + "\n";
  if (report.partial)
    text += format("  partial: only %.2f of %.2f s were analysed\n", s.seconds(),
                   (report.window.end - report.window.begin).toSec());
  text += format("  %zu evaluations in %.1f s of %s (%s)\n", s.evaluations(), s.seconds(),
                 report.topics.names.obstacles.c_str(), report.topics.obstacles_type.c_str());
  text += "  levels: " + levels(s) + "\n";
  if (std::isfinite(s.smallestClearance()))
    text += format("  smallest clearance: %.3f m\n", s.smallestClearance());
  text += format("  approaches: %zu\n", report.events.size()) + eventLines(report.events);
  if (!s.reasons().empty())
    text += format("  data: %.1f %% of the time UNKNOWN\n", s.unknownPercent()) + reasonLines(s);
  if (breaksLimit(report, options))
    text += format("  LIMIT BROKEN: a time to collision is under %g s\n", *options.fail_under);
  else if (options.fail_under && isUnusable(report, options))
    text +=
        format("  LIMIT NOT PROVEN: more than %g %% of the time is UNKNOWN\n", options.max_unknown);
  return text;
}

std::string planText(const BagReport& report, const Parameters& parameters, const Body& body) {
  if (!report.problem.empty()) return "";
  const auto named = [](const std::string& name, const char* none) {
    return name.empty() ? std::string(none) : name;
  };
  const char* without = body.motion == BodyMotion::kTf ? "none: the motion is taken from tf"
                                                       : "none: the robot stands still";
  return nameOf(report) +
         format(": %.1f s from ", (report.window.end - report.window.begin).toSec()) +
         format("%u.%09u", report.window.begin.sec, report.window.begin.nsec) +
         "\n  obstacles: " + report.topics.names.obstacles + " (" + report.topics.obstacles_type +
         ")\n  odometry:  " + named(report.topics.names.odom, without) +
         "\n  footprint: " + named(report.topics.names.footprint, "given as a polygon") +
         "\n  frames:    " + body.frame + " on " + parameters.fixed_frame + "\n";
}

}  // namespace footprint_collision_predictor::tools
