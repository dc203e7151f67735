// The border between messages and the core, in both directions.
#pragma once

#include <geometry_msgs/Polygon.h>
#include <geometry_msgs/Twist.h>

#include <cstdint>
#include <vector>

#include "findings.hpp"
#include "footprint_collision_predictor/CollisionPrediction.h"
#include "footprint_collision_predictor/ObstacleArray.h"
#include "footprint_collision_predictor/predictor.hpp"
#include "planar_pose.hpp"

namespace footprint_collision_predictor {

/// What a core obstacle was in its message.
struct ObstacleKey {
  ObstacleKey(std::int64_t id_of, std::int32_t index_of) : id(id_of), index(index_of) {}
  std::int64_t id;
  std::int32_t index;
};

/// The usable obstacles of a message.
struct SceneObstacles {
  std::vector<core::Obstacle> in_body;  ///< in the footprint's body frame
  std::vector<ObstacleKey> keys;        ///< one for each of them
  Findings findings;                    ///< about those that are missing here, and about their ids
};

/// \param body pose of the body frame in the message's frame
/// \param header_motion twist over ground of the message's frame as a rigid part of the body, about
/// the
///     body's origin and along its axes; it is added to the obstacles' velocities. Zero for
///     velocities that are over ground already.
SceneObstacles toCore(const ObstacleArray& message, const PlanarPose& body,
                      const core::Twist& header_motion);

/// Vertices in the body frame.
/// \param body pose of the body frame in the polygon's frame
std::vector<core::Vec2> toCore(const geometry_msgs::Polygon& polygon, const PlanarPose& body);

/// The twist of a rigid body at another frame's origin, along that frame's axes.
/// \param from pose of the frame in which the twist is given, in the other frame
core::Twist carriedOver(const core::Twist& twist, const PlanarPose& from);

geometry_msgs::Point toMsg(const core::Vec2& p);
geometry_msgs::Twist toMsg(const core::Twist& twist);

/// The segments of a prediction.
/// \param complete false when not every input is known: a segment without a certain contact then
/// has
///     time_to_collision NaN and contact_free_time 0, so that it does not read as clear
std::vector<SegmentPrediction> toMsg(const core::Polygon& footprint,
                                     const core::Prediction& prediction,
                                     const std::vector<ObstacleKey>& keys, double horizon,
                                     bool complete);

}  // namespace footprint_collision_predictor
