#include "clock_monitor.hpp"

#include <sstream>

namespace footprint_collision_predictor {
namespace {

// [s] A wall clock that is being disciplined may step back by a little; nothing depends on so
// little.
constexpr double kHarmlessStep = 0.05;

}  // namespace

ClockMonitor::ClockMonitor(bool simulated, double longest_stop)
    : simulated_(simulated), longest_stop_(longest_stop) {}

bool ClockMonitor::jumpedBack(const Moment& now) {
  const bool back = secondsBetween(now.ros, last_advance_.ros) > kHarmlessStep;
  if (back || now.ros > last_advance_.ros || last_advance_.steady.isZero()) last_advance_ = now;
  if (back) ++jumps_back_;
  return back;
}

ClockReport ClockMonitor::report(const Moment& now) const {
  return {simulated_, now.ros, secondsBetween(last_advance_.steady, now.steady), jumps_back_,
          findings(now)};
}

Findings ClockMonitor::findings(const Moment& now) const {
  Findings findings;
  if (!simulated_) return findings;
  if (now.ros.isZero()) {
    findings.add(CollisionWarning::REASON_CLOCK,
                 "use_sim_time is set but nothing has come on /clock yet: start the simulator, or "
                 "play the recording with --clock");
    return findings;
  }
  const double stopped = secondsBetween(last_advance_.steady, now.steady);
  if (stopped <= longest_stop_) return findings;
  std::ostringstream text;
  text.precision(2);
  text << "the simulated clock has stood still at " << now.ros << " for " << stopped
       << " s: is the simulator or player paused or finished?";
  findings.add(CollisionWarning::REASON_CLOCK, text.str());
  return findings;
}

}  // namespace footprint_collision_predictor
