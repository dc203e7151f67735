// From an ObstacleArray to the core's obstacles: every value is looked at, and nothing is left out
// without a finding that names it.
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

void requireFinite(const char* field, double value) {
  if (std::isfinite(value)) return;
  std::ostringstream text;
  text << field << " is " << value << "; it must be finite";
  throw core::InvalidObstacle(text.str());
}

void requireUsable(const Obstacle& o) {
  core::Obstacle(motionOf(o), o.radius);  // the core's own rules, in the message's own frame
  requireFinite("position.z", o.position.z);
  requireFinite("velocity.z", o.velocity.z);
  requireFinite("acceleration.z", o.acceleration.z);
  if (o.outline.size() == 1)
    throw core::InvalidObstacle(
        "outline has 1 vertex; allowed are none for a circle, 2 for a line, "
        "or more");
  for (const auto& vertex : o.outline) {
    core::Obstacle({{vertex.x, vertex.y}, {0, 0}, {0, 0}}, 0);
    requireFinite("outline z", vertex.z);
  }
  if (!(o.radius_rate >= 0 && o.radius_rate <= core::kMaxRate)) {
    std::ostringstream text;
    text << "radius_rate is " << o.radius_rate << "; allowed is a finite number from 0 to "
         << core::kMaxRate;
    throw core::InvalidObstacle(text.str());
  }
}

core::Obstacle inBody(const Obstacle& o, const PlanarPose& body, const core::Twist& header_motion) {
  core::Motion motion = motionOf(o);
  motion.position = body.pointToLocal(motion.position);
  motion.velocity = body.vectorToLocal(motion.velocity) + header_motion.linear +
                    header_motion.angular * core::leftNormal(motion.position);
  motion.acceleration = body.vectorToLocal(motion.acceleration);
  return {motion, o.radius};
}

/// Names the first few of a kind and counts the rest.
class Listing {
 public:
  void add(std::int64_t id, std::size_t index, const std::string& words) {
    if (++count_ > kMostNamed) return;
    text_ << (count_ > 1 ? ", " : "") << "obstacle id " << id << " (index " << index << ")"
          << words;
  }
  void report(std::uint32_t reason, const std::string& advice, Findings& findings) const {
    if (count_ == 0) return;
    const std::string more =
        count_ > kMostNamed ? " and " + std::to_string(count_ - kMostNamed) + " more" : "";
    findings.add(reason, text_.str() + more + advice);
  }

 private:
  std::size_t count_ = 0;
  std::ostringstream text_;
};

}  // namespace

Circles toCore(const ObstacleArray& message, const PlanarPose& body,
               const core::Twist& header_motion) {
  Circles circles;
  Listing invalid, growing, duplicate;
  std::size_t outlines = 0;
  std::set<std::int64_t> ids;
  for (std::size_t i = 0; i < message.obstacles.size(); ++i) {
    const Obstacle& o = message.obstacles[i];
    if (o.id != -1 && !ids.insert(o.id).second) duplicate.add(o.id, i, "");
    try {
      requireUsable(o);
      if (!o.outline.empty()) {
        ++outlines;
      } else if (o.radius_rate > 0) {
        growing.add(o.id, i, " has a radius_rate");
      } else {
        circles.obstacles.push_back(inBody(o, body, header_motion));
        circles.keys.push_back({o.id, static_cast<std::int32_t>(i)});
      }
    } catch (const core::InvalidObstacle& error) {
      invalid.add(o.id, i, ": " + std::string(error.what()));
    }
  }
  invalid.report(CollisionWarning::REASON_OBSTACLES_INVALID, "; mend the source", circles.findings);
  growing.report(CollisionWarning::REASON_NOT_SUPPORTED,
                 ", which this version cannot predict; send radius_rate 0", circles.findings);
  duplicate.report(CollisionWarning::REASON_DUPLICATE_ID,
                   " shares its id with another; both are predicted", circles.findings);
  if (outlines > 0)
    circles.findings.add(CollisionWarning::REASON_NOT_PREDICTED,
                         std::to_string(outlines) +
                             " lines or polygons are not predicted by this version: the level "
                             "speaks of the circles only");
  return circles;
}

}  // namespace footprint_collision_predictor
