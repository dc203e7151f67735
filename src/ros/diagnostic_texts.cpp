#include "diagnostic_texts.hpp"

#include "findings.hpp"

namespace footprint_collision_predictor {
namespace {

using diagnostic_msgs::DiagnosticStatus;

void summarize(const Findings& findings, const std::string& when_good, Status& status) {
  if (findings.makeUnknown())
    status.summary(DiagnosticStatus::ERROR, findings.text());
  else if (!findings.empty())
    status.summary(DiagnosticStatus::WARN, findings.text());
  else
    status.summary(DiagnosticStatus::OK, when_good);
}

std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : " ") + name;
  return all;
}

void summarizeLevel(const CollisionWarning& warning, Status& status) {
  switch (warning.level) {
    case CollisionWarning::CLEAR:
      return status.summary(DiagnosticStatus::OK, "clear");
    case CollisionWarning::WARN:
      return status.summary(DiagnosticStatus::WARN, "contact ahead");
    case CollisionWarning::CRITICAL:
      return status.summary(DiagnosticStatus::ERROR, "contact imminent");
    default:
      return status.summary(DiagnosticStatus::ERROR, "unknown: " + warning.message);
  }
}

}  // namespace

void describe(const CollisionWarning& warning, Status& status) {
  summarizeLevel(warning, status);
  // A level that may rest on more or less than was meant is not simply OK.
  if (warning.level == CollisionWarning::CLEAR && warning.reason != 0)
    status.summary(DiagnosticStatus::WARN, "clear, but: " + warning.message);
  status.add("level", static_cast<int>(warning.level));
  status.add("time to collision [s]", warning.time_to_collision);
  status.add("contact free time [s]", warning.contact_free_time);
  status.add("horizon [s]", warning.horizon);
  status.add("clearance [m]", warning.clearance);
  status.add("closing speed [m/s]", warning.closing_speed);
  status.add("segment", warning.segment);
  status.add("obstacle id", warning.obstacle_id);
  status.add("obstacles", warning.obstacle_count);
  status.add("data age [s]", warning.data_age);
  status.add("reason", warning.reason);
  status.add("sequence", warning.sequence);
  status.add("message", warning.message);
}

void describe(const InputReport& input, Status& status) {
  summarize(input.findings, "fresh and valid", status);
  status.add("topic", input.topic);
  status.add("rate [Hz]", input.rate);
  status.add("age [s]", input.age);
  status.add("received", input.counts.received);
  status.add("accepted", input.counts.accepted);
  status.add("rejected", input.counts.refused);
  status.add("ignored as older than the newest", input.counts.ignored);
  status.add("last rejection", input.last_refusal);
  if (!input.last_refusal.empty()) status.add("since last rejection [s]", input.since_last_refusal);
  status.add("type", input.type);
  status.add("md5", input.md5);
  status.add("publishers", listed(input.publishers));
}

void describe(const TransformReport& transforms, const InputReport& obstacles, Status& status) {
  summarize(transforms.findings, "found for the newest obstacles", status);
  if (transforms.findings.empty() && obstacles.findings.makeUnknown())
    status.summary(DiagnosticStatus::WARN, "no fresh obstacles that would need a transform");
  status.add("from", transforms.frame);
  status.add("to", transforms.body_frame);
  if (transforms.delay) status.add("delay [s]", *transforms.delay);
  status.add("waited for by the last message [s]", transforms.waited);
}

void describe(const ComputationReport& computation, double max_data_age, Status& status) {
  if (computation.since_last > max_data_age)
    status.summary(DiagnosticStatus::WARN, "nothing is being evaluated: see the inputs");
  else if (computation.p99 > computation.period)
    status.summary(DiagnosticStatus::ERROR,
                   "evaluations take longer than the period: send fewer obstacles, simplify the "
                   "footprint, or lower ~heartbeat_rate");
  else if (computation.p99 > computation.period / 2)
    status.summary(DiagnosticStatus::WARN, "evaluations take more than half of the period");
  else
    status.summary(DiagnosticStatus::OK, "in time");
  status.add("period [s]", computation.period);
  status.add("p50 [s]", computation.p50);
  status.add("p99 [s]", computation.p99);
  status.add("longest [s]", computation.longest);
  status.add("evaluations", computation.evaluations);
  status.add("late evaluations", computation.late);
}

void describe(const ClockReport& clock, Status& status) {
  summarize(clock.findings, clock.simulated ? "the simulated clock runs" : "wall clock", status);
  status.add("simulated", clock.simulated ? 1 : 0);
  status.add("time [s]", clock.time);
  status.add("standing still for [s]", clock.standing_still);
  status.add("jumps back", clock.jumps_back);
}

void describe(const MasterView& master, Status& status) {
  if (master.answers)
    status.summary(DiagnosticStatus::OK, "answers");
  else
    status.summary(DiagnosticStatus::ERROR,
                   "the ROS master does not answer: connections that exist go on, but nothing new "
                   "can connect until it is back and the nodes are started again");
  status.add("since last answer [s]", master.since_answer);
}

void describe(const ConfigurationReport& configuration, Status& status) {
  if (configuration.refusal.empty())
    status.summary(DiagnosticStatus::OK, "valid");
  else
    status.summary(DiagnosticStatus::WARN,
                   "the last change was refused, the old values stay: " + configuration.refusal);
  const PredictorConfig& config = configuration.config;
  status.add("horizon [s]", config.horizon);
  status.add("warn time [s]", config.warn_time);
  status.add("critical time [s]", config.critical_time);
  status.add("clear after", config.clear_after);
  status.add("max data age [s]", config.max_data_age);
  status.add("transform tolerance [s]", config.transform_tolerance);
  status.add("heartbeat rate [Hz]", config.heartbeat_rate);
  status.add("max obstacles", config.max_obstacles);
  status.add("changes refused", configuration.refused);
}

}  // namespace footprint_collision_predictor
