// A nodelet that does what topic_tools' relay does.
#pragma once

#include <nodelet/nodelet.h>
#include <topic_tools/shape_shifter.h>

namespace footprint_collision_predictor::bench {

class RelayNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    const boost::function<void(const topic_tools::ShapeShifter::ConstPtr&)> callback =
        [this](const topic_tools::ShapeShifter::ConstPtr& message) {
          if (!publisher_) publisher_ = message->advertise(getNodeHandle(), "relay/answer", 100);
          publisher_.publish(message);
        };
    subscriber_ =
        getNodeHandle().subscribe<topic_tools::ShapeShifter>("relay/obstacles", 100, callback);
  }

  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace footprint_collision_predictor::bench
