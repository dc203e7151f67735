#include "markers.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "findings.hpp"
#include "marker_shapes.hpp"
#include "marker_text.hpp"
#include "moment.hpp"

namespace footprint_collision_predictor {
namespace {

using visualization_msgs::Marker;

// [s] of motion that an arrow shows.
constexpr double kArrowTime = 1;

// The following are multiples of the unit, the footprint's bounding radius.
constexpr double kLeastRadius = 0.05;  // at which a point is drawn
constexpr double kArrowHead = 0.2;
constexpr double kArrowWidth = 0.03;
constexpr double kContactSize = 0.18;
constexpr double kTextHeight = 0.32;
constexpr double kLayer = 0.01;  // height between what lies over each other

constexpr double kUnitWithoutFootprint = 0.5;  // [m]
constexpr double kTurning = 0.1;               // [rad/s]
constexpr double kLeastTextHeight = 0.18;      // [m]

constexpr Outlook kTop = Outlook::kCritical;  // lies over the others
constexpr float kFillOpacity = 0.25f;
constexpr Style kGhost = {0, 0, 0, 0.025, 0.08, 0.06};  // its colour is the level's

bool isUnknown(const CollisionWarning& warning) {
  // That a level is still held says nothing about what was predicted.
  const std::uint32_t reasons = warning.reason & ~std::uint32_t{CollisionWarning::REASON_SETTLING};
  return reasons % kFirstDegradedReason != 0;
}

class Painter {
 public:
  explicit Painter(const Picture& picture)
      : picture_(picture),
        unit_(picture.footprint ? picture.footprint->boundingRadius() : kUnitWithoutFootprint),
        unknown_(isUnknown(picture.warning)) {}

  visualization_msgs::MarkerArray paint() {
    paintFootprint();
    paintObstacles();
    paintGhosts();
    paintText();
    return std::move(array_);
  }

 private:
  /// One for each look, since a marker's lines all have one width.
  using PointsByOutlook = std::array<Points, kOutlooks>;

  void paintFootprint() {
    PointsByOutlook lines;
    if (picture_.footprint)
      for (std::size_t i = 0; i < picture_.footprint->size(); ++i) {
        const core::Segment segment = picture_.footprint->segment(i);
        const Outlook outlook = outlookOfSegment(i);
        addLine(segment.start, segment.end, styleOf(outlook), unit_, layer(outlook),
                lines[static_cast<std::size_t>(outlook)]);
      }
    addLines("footprint", lines);
    Marker body = marker("body", 0, Marker::TRIANGLE_LIST);
    if (picture_.footprint) addFilled(picture_.footprint->vertices(), -layer(kTop), body.points);
    body.scale.x = body.scale.y = body.scale.z = 1;
    body.color = colourOf(Outlook::kIrrelevant, kFillOpacity);
    add(std::move(body));
  }

  Outlook outlookOfSegment(std::size_t i) const {
    const auto& segments = picture_.prediction.segments;
    if (i >= segments.size()) return Outlook::kUnknown;
    const auto& first = picture_.prediction.first;
    // An obstacle inside touches the solid footprint, but maybe none of its segments.
    const bool inside = first && first->segment == i && first->contact.time <= 0;
    const std::optional<double> time = inside        ? std::make_optional(0.0)
                                       : segments[i] ? std::make_optional(segments[i]->contact.time)
                                                     : std::nullopt;
    return outlookOf(time, picture_.thresholds, unknown_ ? Outlook::kUnknown : Outlook::kFree);
  }

  void paintObstacles() {
    PointsByOutlook lines, fills;
    Points arrows;
    const std::vector<Outlook> outlooks = outlooksOfObstacles();
    for (const std::size_t i : drawn(outlooks)) {
      const core::Obstacle& obstacle = picture_.obstacles[i];
      const Outlook outlook = outlooks[i];
      const auto look = static_cast<std::size_t>(outlook);
      const Path outline = outlineAt(obstacle, 0, kLeastRadius * unit_);
      addClosed(outline, styleOf(outlook), unit_, layer(outlook), lines[look]);
      addFilled(outline, layer(outlook), fills[look]);
      const core::Vec2& at = obstacle.motion().position;
      addArrow(at, at + kArrowTime * obstacle.motion().velocity, kArrowHead * unit_, layer(outlook),
               arrows);
    }
    if (picture_.footprint) {
      const core::Vec2& at = picture_.footprint->centroid();
      const core::Twist& twist = picture_.twist;
      const core::Vec2 velocity = twist.linear + twist.angular * core::leftNormal(at);
      addArrow(at, at + kArrowTime * velocity, kArrowHead * unit_, 0, arrows);
    }
    addLines("obstacles", lines);
    addFills("obstacles_fill", fills);
    Marker velocities = marker("velocities", 0, Marker::LINE_LIST);
    velocities.points = std::move(arrows);
    velocities.scale.x = kArrowWidth * unit_;
    velocities.color = colourOf(Outlook::kIrrelevant);
    add(std::move(velocities));
  }

  /// By the earliest contact that names the obstacle.
  std::vector<Outlook> outlooksOfObstacles() const {
    std::vector<Outlook> outlooks(picture_.obstacles.size(),
                                  unknown_ ? Outlook::kUnknown : Outlook::kIrrelevant);
    const auto note = [&](std::size_t obstacle, double time) {
      outlooks[obstacle] =
          std::max(outlooks[obstacle], outlookOf(time, picture_.thresholds, Outlook::kUnknown));
    };
    for (const auto& segment : picture_.prediction.segments)
      if (segment) note(segment->obstacle, segment->contact.time);
    const auto& first = picture_.prediction.first;
    if (first) note(first->obstacle, first->contact.time);
    return outlooks;
  }

  std::vector<std::size_t> drawn(const std::vector<Outlook>& outlooks) {
    std::vector<std::size_t> indices(outlooks.size());
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    if (indices.size() <= kMostObstaclesDrawn) return indices;
    const auto rank = [&](std::size_t i) {
      const auto distance = picture_.obstacles[i].motion().position.squaredNorm();
      return std::make_pair(-static_cast<int>(outlooks[i]), distance);
    };
    const auto end = indices.begin() + kMostObstaclesDrawn;
    std::nth_element(indices.begin(), end, indices.end(),
                     [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
    undrawn_ = indices.size() - kMostObstaclesDrawn;
    indices.erase(end, indices.end());
    return indices;
  }

  /// Footprint and obstacle at the moment of contact, and the point where they touch: on the body
  /// now, and then.
  void paintGhosts() {
    Points lines, contacts;
    Outlook outlook = Outlook::kLater;
    const auto& first = picture_.prediction.first;
    if (first && picture_.footprint) {
      const double time = first->contact.time;
      const PlanarPose pose = poseAfter(picture_.twist, time);
      outlook = outlookOf(time, picture_.thresholds, outlook);
      if (time > 0) {
        if (moves(pose))
          addClosed(posed(picture_.footprint->vertices(), pose), kGhost, unit_, 0, lines);
        addClosed(outlineAt(picture_.obstacles[first->obstacle], time, kLeastRadius * unit_),
                  kGhost, unit_, 0, lines);
        addPoint(posed({first->contact.point}, pose)[0], contacts);
      }
      addPoint(first->contact.point, contacts);
    }
    Marker ghosts = marker("ghosts", 0, Marker::LINE_LIST);
    ghosts.points = std::move(lines);
    ghosts.scale.x = kGhost.width * unit_;
    ghosts.color = colourOf(outlook);
    add(std::move(ghosts));
    Marker contact = marker("contact", 0, Marker::SPHERE_LIST);
    contact.points = std::move(contacts);
    contact.scale.x = contact.scale.y = contact.scale.z = kContactSize * unit_;
    contact.color = colourOf(outlook);
    add(std::move(contact));
  }

  /// Enough for the ghost to be told from the footprint.
  bool moves(const PlanarPose& pose) const {
    return pose.position.norm() > kGhost.width * unit_ ||
           (pose.x_axis - core::Vec2(1, 0)).norm() > kGhost.width;
  }

  void addPoint(const core::Vec2& p, Points& points) const {
    geometry_msgs::Point point;
    point.x = p.x();
    point.y = p.y();
    point.z = layer(kTop);
    points.push_back(point);
  }

  void paintText() {
    Marker text = marker("text", 0, Marker::TEXT_VIEW_FACING);
    text.action = Marker::ADD;
    text.text = markerText(picture_.warning, undrawn_);
    text.scale.z = std::max(kTextHeight * unit_, kLeastTextHeight);
    text.color = colourOf(outlookOf(static_cast<core::Level>(picture_.warning.level)));
    if (picture_.footprint) {
      const core::Vec2& centre = picture_.footprint->centroid();
      text.pose.position.x = centre.x();
      // Ghosts of a robot that turns lie on the inner side.
      const double side = picture_.twist.angular > kTurning ? -1 : 1;
      text.pose.position.y = centre.y() + side * (1.2 * unit_ + text.scale.z);
    }
    array_.markers.push_back(std::move(text));
  }

  double layer(Outlook outlook) const { return kLayer * unit_ * static_cast<double>(outlook); }

  Marker marker(const char* content, int id, int type) const {
    Marker marker;
    marker.header.frame_id = picture_.warning.header.frame_id;
    marker.ns = picture_.warning.footprint + "/" + content;
    marker.id = id;
    marker.type = type;
    marker.pose.orientation.w = 1;
    marker.lifetime = ros::Duration(kMarkerLifetime);
    return marker;
  }

  void addLines(const char* content, PointsByOutlook& lines) {
    for (std::size_t i = 0; i < kOutlooks; ++i) {
      const auto outlook = static_cast<Outlook>(i);
      Marker list = marker(content, static_cast<int>(i), Marker::LINE_LIST);
      list.points = std::move(lines[i]);
      list.scale.x = styleOf(outlook).width * unit_;
      list.color = colourOf(outlook);
      add(std::move(list));
    }
  }

  void addFills(const char* content, PointsByOutlook& triangles) {
    for (std::size_t i = 0; i < kOutlooks; ++i) {
      Marker list = marker(content, static_cast<int>(i), Marker::TRIANGLE_LIST);
      list.points = std::move(triangles[i]);
      list.scale.x = list.scale.y = list.scale.z = 1;
      list.color = colourOf(static_cast<Outlook>(i), kFillOpacity);
      add(std::move(list));
    }
  }

  void add(Marker marker) {
    marker.action = marker.points.empty() ? Marker::DELETE : Marker::ADD;
    array_.markers.push_back(std::move(marker));
  }

  const Picture& picture_;
  const double unit_;  // [m] the picture's measure
  const bool unknown_;
  std::size_t undrawn_ = 0;
  visualization_msgs::MarkerArray array_;
};

}  // namespace

visualization_msgs::MarkerArray markers(const Picture& picture) { return Painter(picture).paint(); }

visualization_msgs::MarkerArray markers(const CollisionWarning& warning, const Scene* scene,
                                        const core::Polygon* footprint,
                                        const core::Thresholds& thresholds) {
  if (!scene) return markers(Picture{warning, thresholds, footprint, {}, {}, {}});
  auto obstacles = carriedOn(*scene, secondsBetween(scene->stamp, warning.header.stamp));
  auto prediction = core::predict(scene->footprint, scene->twist, obstacles, scene->horizon);
  return markers(Picture{warning, thresholds, &scene->footprint, scene->twist, std::move(obstacles),
                         std::move(prediction)});
}

}  // namespace footprint_collision_predictor
