#include "benchmarks.hpp"
#include "footprint_collision_predictor/time_to_collision.hpp"
#include "group.hpp"
#include "lecture_peer.hpp"

namespace footprint_collision_predictor::bench {

void addSegmentBenchmarks(const SharedScene& scene, const SceneTruths& truths) {
  const Group group = segmentGroup(*scene, truths);
  const std::vector<Segment> segments = segmentsOf(scene->footprint);
  group.add("ours", kGuarantee, [scene, segments](std::size_t i) {
    const auto contact =
        core::timeToCollision(segments[i % segments.size()], scene->seen(i), kHorizon);
    return contact ? contact->time : kNever;
  });
  std::vector<LecturePeer> peers;
  for (const Segment& segment : segments) peers.push_back(LecturePeer({segment}));
  group.add(scene->kind == Kind::kStraight ? "lecture" : "eigen", kGuarantee,
            [scene, peers](std::size_t i) {
              return peers[i % peers.size()].firstContact(scene->seen(i));
            });
}

}  // namespace footprint_collision_predictor::bench
