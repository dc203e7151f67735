#include "benchmarks.hpp"
#include "box2d_peer.hpp"
#include "fcl_peer.hpp"
#include "footprint_collision_predictor/predictor.hpp"
#include "group.hpp"
#include "lecture_peer.hpp"
#include "stepping_peer.hpp"

namespace footprint_collision_predictor::bench {
namespace {

void addOurs(const SharedScene& scene, const Group& group) {
  // One obstacle is a list of one: the list is kept, as a caller would keep it.
  const auto one = std::make_shared<std::vector<Obstacle>>(1, scene->obstacles.front());
  group.add("ours", kGuarantee, [scene, one](std::size_t i) {
    one->front() = scene->obstacles[i];
    const auto prediction = core::predict(scene->footprint, scene->twist, *one, kHorizon);
    return prediction.first ? prediction.first->contact.time : kNever;
  });
}

template <typename Peer>
void addPeer(const SharedScene& scene, const Group& group, const std::string& name,
             const Tolerance& tolerance, const std::shared_ptr<Peer>& peer) {
  group.add(name, tolerance, [scene, peer](std::size_t i) {
    return peer->firstContact(scene->relative(i), scene->obstacles[i].radius());
  });
}

void addStepping(const SharedScene& scene, const Group& group, const std::string& name,
                 double step) {
  const auto peer = std::make_shared<SteppingPeer>(scene->footprint, step);
  addPeer(scene, group, name, peer->tolerance(), peer);
}

}  // namespace

void addFootprintBenchmarks(const SharedScene& scene) {
  const Group group = footprintGroup(*scene);
  const bool straight = scene->kind == MotionKind::kStraight;
  addOurs(scene, group);
  if (straight) {  // neither engine has a sweep with acceleration
    addPeer(scene, group, "box2d", Box2dPeer::kTolerance,
            std::make_shared<Box2dPeer>(scene->convex_parts));
    addPeer(scene, group, "fcl", FclPeer::kTolerance,
            std::make_shared<FclPeer>(scene->convex_parts));
  }
  addStepping(scene, group, "steps_0.02s", 0.02);
  addStepping(scene, group, "steps_0.1s", 0.1);
  addPeer(scene, group, straight ? "lecture" : "eigen", kGuarantee,
          std::make_shared<LecturePeer>(segmentsOf(scene->footprint)));
}

}  // namespace footprint_collision_predictor::bench
