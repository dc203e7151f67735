// The node, loaded into a nodelet manager.
#include <nodelet/nodelet.h>

#include <memory>
#include <pluginlib/class_list_macros.hpp>

#include "node.hpp"

namespace footprint_collision_predictor {

class Predictor : public nodelet::Nodelet {
 private:
  /// What is thrown makes the manager refuse to load it, and go on.
  void onInit() override try {
    node_ = std::make_unique<Node>(getNodeHandle(), getPrivateNodeHandle());
  } catch (const ParameterError& error) {
    NODELET_FATAL_STREAM("wrong parameters in " << getName() << ":\n" << error.what());
    throw;
  }

  std::unique_ptr<Node> node_;
};

}  // namespace footprint_collision_predictor

PLUGINLIB_EXPORT_CLASS(footprint_collision_predictor::Predictor, nodelet::Nodelet)
