// rosrun footprint_collision_predictor predictor_node
#include <ros/console.h>
#include <ros/init.h>

#include "node.hpp"

int main(int argc, char** argv) {
  ros::init(argc, argv, "predictor_node");
  // Outside the try: when the last handle goes, roscpp shuts down and logs nothing any more.
  const ros::NodeHandle public_handle, private_handle("~");
  try {
    const footprint_collision_predictor::Node node(public_handle, private_handle);
    ros::spin();
  } catch (const footprint_collision_predictor::ParameterError& error) {
    ROS_FATAL_STREAM("wrong parameters in " << ros::this_node::getName() << ":\n" << error.what());
    return 1;
  }
  return 0;
}
