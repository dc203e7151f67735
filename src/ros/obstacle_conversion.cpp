// From an ObstacleArray to the core's obstacles: every value is looked at, and nothing is left out
// without a finding that names it.
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "conversions.hpp"

namespace footprint_collision_predictor {
namespace {

constexpr std::size_t kMostNamed = 3;

core::Motion motionOf(const Obstacle& o) {
  return {{o.position.x, o.position.y},
          {o.velocity.x, o.velocity.y},
          {o.acceleration.x, o.acceleration.y}};
}

[[noreturn]] void refuse(const char* field, double value) {
  std::ostringstream text;
  text << field << " is " << value << "; it must be finite";
  throw core::InvalidObstacle(text.str());
}

void requireFinite(const char* field, double value) {
  if (!std::isfinite(value)) refuse(field, value);
}

std::vector<core::Vec2> outlineOf(const Obstacle& o) {
  std::vector<core::Vec2> outline;
  outline.reserve(o.outline.size());
  for (const auto& vertex : o.outline) outline.emplace_back(vertex.x, vertex.y);
  return outline;
}

/// The obstacle in the message's own frame, by whose numbers the sender knows it.
core::Obstacle asSent(const Obstacle& o) {
  requireFinite("position.z", o.position.z);
  requireFinite("velocity.z", o.velocity.z);
  requireFinite("acceleration.z", o.acceleration.z);
  for (const auto& vertex : o.outline) requireFinite("outline z", vertex.z);
  return {motionOf(o), o.radius, o.radius_rate, outlineOf(o)};
}

core::Obstacle inBody(const core::Obstacle& sent, const PlanarPose& body,
                      const core::Twist& header_motion) {
  core::Motion motion = sent.motion();
  motion.position = body.pointToLocal(motion.position);
  motion.velocity = body.vectorToLocal(motion.velocity) + header_motion.linear +
                    header_motion.angular * core::leftNormal(motion.position);
  motion.acceleration = body.vectorToLocal(motion.acceleration);
  std::vector<core::Vec2> outline = sent.outline();
  for (core::Vec2& vertex : outline) vertex = body.vectorToLocal(vertex);
  return {motion, sent.radius(), sent.disc().radius_rate, std::move(outline)};
}

/// Ids that several obstacles have, in order; -1 is none.
std::vector<std::int64_t> sharedIds(const ObstacleArray& message) {
  std::vector<std::int64_t> ids, shared;
  ids.reserve(message.obstacles.size());
  for (const Obstacle& o : message.obstacles)
    if (o.id != -1) ids.push_back(o.id);
  if (!std::is_sorted(ids.begin(), ids.end())) std::sort(ids.begin(), ids.end());
  for (std::size_t i = 1; i < ids.size(); ++i)
    if (ids[i] == ids[i - 1]) shared.push_back(ids[i]);
  return shared;
}

/// Names the first few of a kind and counts the rest.
class Listing {
 public:
  void add(std::int64_t id, std::size_t index, const std::string& words) {
    if (++count_ > kMostNamed) return;
    text_ += (count_ > 1 ? ", " : "") + std::string("obstacle id ") + std::to_string(id) +
             " (index " + std::to_string(index) + ")" + words;
  }
  void report(std::uint32_t reason, const std::string& advice, Findings& findings) const {
    if (count_ == 0) return;
    const std::string more =
        count_ > kMostNamed ? " and " + std::to_string(count_ - kMostNamed) + " more" : "";
    findings.add(reason, text_ + more + advice);
  }

 private:
  std::size_t count_ = 0;
  std::string text_;
};

}  // namespace

SceneObstacles toCore(const ObstacleArray& message, const PlanarPose& body,
                      const core::Twist& header_motion) {
  SceneObstacles usable;
  Listing invalid, duplicate;
  const std::vector<std::int64_t> shared = sharedIds(message);
  std::set<std::int64_t> seen;  // of those
  usable.in_body.reserve(message.obstacles.size());
  usable.keys.reserve(message.obstacles.size());
  for (std::size_t i = 0; i < message.obstacles.size(); ++i) {
    const Obstacle& o = message.obstacles[i];
    if (std::binary_search(shared.begin(), shared.end(), o.id) && !seen.insert(o.id).second)
      duplicate.add(o.id, i, "");
    try {
      usable.in_body.push_back(inBody(asSent(o), body, header_motion));
      usable.keys.emplace_back(o.id, static_cast<std::int32_t>(i));
    } catch (const core::InvalidObstacle& error) {
      invalid.add(o.id, i, ": " + std::string(error.what()));
    }
  }
  invalid.report(CollisionWarning::REASON_OBSTACLES_INVALID, "; mend the source", usable.findings);
  duplicate.report(CollisionWarning::REASON_DUPLICATE_ID,
                   ": another obstacle has the same id; all are predicted", usable.findings);
  return usable;
}

}  // namespace footprint_collision_predictor
