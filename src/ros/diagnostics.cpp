#include "diagnostics.hpp"

#include <ros/console.h>

#include "diagnostic_texts.hpp"
#include "footprint_collision_predictor/warning.hpp"
#include "moment.hpp"

namespace footprint_collision_predictor {
namespace {

constexpr double kOldReport = 1;  // [s] The worker reports many times as often.

/// Whether the node as a whole is as bad as this.
bool isWorse(const CollisionWarning& a, const CollisionWarning& b) {
  const auto level = [](const CollisionWarning& w) { return static_cast<core::Level>(w.level); };
  if (a.level != b.level) return core::isWorse(level(a), level(b));
  return a.contact_free_time < b.contact_free_time;
}

CollisionWarning worstOf(const std::vector<const WarningPublisher*>& publishers) {
  CollisionWarning worst = publishers.front()->last();
  for (const WarningPublisher* publisher : publishers) {
    CollisionWarning other = publisher->last();
    if (isWorse(other, worst)) worst = std::move(other);
  }
  return worst;
}

/// With several bodies each has its own.
std::string entryOf(const std::string& name, const std::vector<BodyReport>& bodies, std::size_t i) {
  return bodies.size() > 1 ? name + " " + bodies[i].name : name;
}

}  // namespace

Diagnostics::Diagnostics(ros::NodeHandle& node, ros::NodeHandle& private_node,
                         const Sources& sources, const Report& first)
    : sources_(sources), report_(first), updater_(node, private_node, private_node.getNamespace()) {
  updater_.setHardwareID("none");
  addLevels(first.bodies);
  updater_.add("master", [this](Status& status) { describe(sources_.master.view(), status); });
  updater_.add("configuration",
               [this](Status& status) { describe(sources_.reconfiguration.report(), status); });
  add("obstacles", [](const Report& r, Status& status) { describe(r.obstacles, status); });
  addFootprints(first.bodies);
  if (first.odometry)
    add("odom", [](const Report& r, Status& status) { describe(*r.odometry, status); });
  addTransforms(first.bodies);
  add("computation",
      [](const Report& r, Status& status) { describe(r.computation, r.max_data_age, status); });
  add("clock", [](const Report& r, Status& status) { describe(r.clock, status); });
  timer_ = node.createWallTimer(ros::WallDuration(updater_.getPeriod()),
                                [this](const ros::WallTimerEvent&) { publish(); });
}

/// The worst, and with several bodies each.
void Diagnostics::addLevels(const std::vector<BodyReport>& bodies) {
  const bool several = bodies.size() > 1;
  updater_.add("collision", [this, several](Status& status) {
    const CollisionWarning worst = worstOf(sources_.warnings);
    describe(worst, status);
    if (several) status.add("footprint", worst.footprint);
  });
  if (!several) return;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    updater_.add(entryOf("collision", bodies, i),
                 [this, i](Status& status) { describe(sources_.warnings[i]->last(), status); });
}

void Diagnostics::addFootprints(const std::vector<BodyReport>& bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].footprint)
      add(entryOf("footprint", bodies, i),
          [i](const Report& r, Status& status) { describe(*r.bodies[i].footprint, status); });
}

void Diagnostics::addTransforms(const std::vector<BodyReport>& bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    add(entryOf("transforms", bodies, i), [i](const Report& r, Status& status) {
      describe(r.bodies[i].transforms, r.obstacles, status);
    });
}

void Diagnostics::update(const Report& report) {
  const std::lock_guard<std::mutex> lock(mutex_);
  report_ = report;
}

void Diagnostics::add(const std::string& name, const Describe& describe) {
  updater_.add(name, [this, describe](Status& status) {
    const std::lock_guard<std::mutex> lock(mutex_);
    describe(report_, status);
    const double age = secondsBetween(report_.made, ros::SteadyTime::now());
    if (age > kOldReport)
      status.summaryf(diagnostic_msgs::DiagnosticStatus::ERROR,
                      "no evaluation has come round for %.1f s: the machine or node is overloaded",
                      age);
  });
}

/// A ~diagnostic_period that is changed to nonsense at run time makes the updater throw.
void Diagnostics::publish() try { updater_.force_update(); } catch (const std::exception& error) {
  ROS_ERROR_STREAM_THROTTLE(60, "no diagnostics: " << error.what() << " (~diagnostic_period?)");
}

}  // namespace footprint_collision_predictor
