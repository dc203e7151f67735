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
  group.add("ours", kGuarantee, [scene](std::size_t i) {
    const auto first =
        core::firstContact(scene->footprint, scene->twist, scene->obstacles[i], kHorizon);
    return first ? first->contact.time : kNever;
  });
}

void addBox2d(const SharedScene& scene, const Group& group) {
  const auto peer = std::make_shared<Box2dPeer>(*scene);
  group.add("box2d", Box2dPeer::kTolerance, [scene, peer](std::size_t i) {
    return peer->firstContact(scene->seen(i), scene->obstacles[i].outline());
  });
}

template <typename Peer>
void addPeer(const SharedScene& scene, const Group& group, const std::string& name,
             const Tolerance& tolerance, const std::shared_ptr<Peer>& peer) {
  group.add(name, tolerance,
            [scene, peer](std::size_t i) { return peer->firstContact(scene->seen(i)); });
}

void addStepping(const SharedScene& scene, const Group& group, const std::string& name,
                 double step) {
  const auto peer = std::make_shared<SteppingPeer>(*scene, step);
  addPeer(scene, group, name, peer->tolerance(), peer);
}

}  // namespace

void addFootprintBenchmarks(const SharedScene& scene, const SceneTruths& truths) {
  const Group group = footprintGroup(*scene, truths);
  const Kind kind = scene->kind;
  addOurs(scene, group);
  // Neither engine has a sweep with acceleration, or a shape that grows.
  const bool is_swept = kind == Kind::kStraight || kind == Kind::kTurning;
  if (is_swept || kind == Kind::kWalls) addBox2d(scene, group);
  if (is_swept)
    addPeer(scene, group, "fcl", FclPeer::kTolerance, std::make_shared<FclPeer>(*scene));
  if (kind != Kind::kWalls) {
    addStepping(scene, group, "steps_0.02s", 0.02);
    addStepping(scene, group, "steps_0.1s", 0.1);
  }
  if (kind == Kind::kStraight || kind == Kind::kAccelerating)
    addPeer(scene, group, kind == Kind::kStraight ? "lecture" : "eigen", kGuarantee,
            std::make_shared<LecturePeer>(segmentsOf(scene->footprint)));
}

}  // namespace footprint_collision_predictor::bench
