// The recent odometry, so that a message is evaluated with the motion at its own stamp.
#pragma once

#include <ros/time.h>

#include <deque>
#include <optional>
#include <string>

#include "footprint_collision_predictor/motion.hpp"

namespace footprint_collision_predictor {

struct OdometrySample {
  ros::Time stamp;
  ros::SteadyTime arrived;
  std::string frame;  ///< the body frame that the twist is of, and expressed in
  core::Twist twist;
};

class OdometryHistory {
 public:
  /// One with an equal stamp replaces; one older than the newest is ignored.
  /// \return false when ignored
  bool add(const OdometrySample& sample);
  /// The newest one at or before the stamp.
  std::optional<OdometrySample> at(const ros::Time& stamp) const;
  /// Whether one at or after the stamp has come, so that no better answer for it can follow.
  bool reaches(const ros::Time& stamp) const;
  /// Forgets those after the stamp.
  void dropAfter(const ros::Time& stamp);
  bool empty() const { return samples_.empty(); }
  void clear() { samples_.clear(); }

 private:
  std::deque<OdometrySample> samples_;  // in the order of their stamps
};

}  // namespace footprint_collision_predictor
