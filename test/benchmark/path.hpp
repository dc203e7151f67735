// One of the two that are compared: where its messages go to, and its answers.
#pragma once

#include <footprint_collision_predictor/ObstacleArray.h>
#include <topic_tools/shape_shifter.h>

#include <string>

#include "round_trip.hpp"

namespace footprint_collision_predictor::bench {

class Path {
 public:
  /// \param within_process messages are handed over as pointers to their type, as nodelets do;
  ///     otherwise they are serialised before the time begins
  Path(const std::string& name, bool within_process);

  const std::string& name() const { return name_; }

  /// Sends messages meanwhile: a relay advertises its answers with the first one only.
  void waitConnected(ObstacleArray& message);

  /// Stamped with the present time.
  /// \return time until the answer [s]
  double measure(ObstacleArray& message);

 private:
  std::string name_;
  bool within_process_;
  ros::Publisher publisher_;
  RoundTrip answers_;
};

}  // namespace footprint_collision_predictor::bench
