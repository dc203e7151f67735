#include "benchmarks.hpp"
#include "footprint_collision_predictor/time_to_collision.hpp"
#include "group.hpp"
#include "lecture_peer.hpp"

namespace footprint_collision_predictor::bench {

void addSegmentBenchmarks(const SharedScene& scene) {
  const Group group = segmentGroup(*scene);
  const std::vector<Segment> segments = segmentsOf(scene->footprint);
  group.add("ours", kGuarantee, [scene, segments](std::size_t i) {
    const auto contact = core::timeToCollision(segments[i % segments.size()], scene->relative(i),
                                               scene->obstacles[i].radius(), kHorizon);
    return contact ? contact->time : kNever;
  });
  std::vector<LecturePeer> peers;
  for (const Segment& segment : segments) peers.push_back(LecturePeer({segment}));
  const bool straight = scene->kind == MotionKind::kStraight;
  group.add(straight ? "lecture" : "eigen", kGuarantee, [scene, peers](std::size_t i) {
    return peers[i % peers.size()].firstContact(scene->relative(i), scene->obstacles[i].radius());
  });
}

}  // namespace footprint_collision_predictor::bench
