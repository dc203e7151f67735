// Many obstacles at once are what each of them is alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "footprint_oracle.hpp"
#include "guarantee.hpp"
#include "scene.hpp"

namespace footprint_collision_predictor::test {
namespace {

using core::FootprintContact;
using core::ObstacleBatch;
using core::Polygon;
using core::SegmentContact;

constexpr SuiteSize kScenes{1500, 100000};

using Contacts = std::vector<std::optional<SegmentContact>>;

Contacts contactsIn(const Scene& scene, const ObstacleBatch& batch) {
  Contacts contacts(99, SegmentContact{{-1, core::Feature::kEnd, {9, 9}}, 99});  // to be replaced
  firstContacts(Polygon(scene.footprint), scene.twist, batch, scene.horizon, &contacts);
  return contacts;
}

Contacts contactsIn(const Scene& scene) {
  return contactsIn(scene, ObstacleBatch(scene.obstacles));
}

std::optional<FootprintContact> firstIn(const Scene& scene) {
  return firstContact(Polygon(scene.footprint), scene.twist, ObstacleBatch(scene.obstacles),
                      scene.horizon);
}

/// When each obstacle is touched alone; HUGE_VAL where it is not.
using Times = std::vector<double>;

template <typename Contact>
double timeOf(const std::optional<Contact>& contact) {
  return contact ? contact->contact.time : HUGE_VAL;
}

Times timesOfFootprint(const Scene& scene) {
  const Polygon footprint(scene.footprint);
  Times times;
  for (const core::Obstacle& o : scene.obstacles)
    times.push_back(timeOf(firstContact(footprint, scene.twist, o, scene.horizon)));
  return times;
}

std::vector<Times> timesOfSegments(const Scene& scene) {
  const Polygon footprint(scene.footprint);
  std::vector<Times> times(footprint.size());
  for (const core::Obstacle& o : scene.obstacles) {
    Contacts alone;
    if (!o.outline().empty())
      firstContacts(footprint, scene.twist, ObstacleBatch({o}), scene.horizon, &alone);
    for (std::size_t i = 0; i < footprint.size(); ++i) {
      if (!o.outline().empty()) {
        times[i].push_back(timeOf(alone[i]));
        continue;
      }
      const auto contact =
          timeToCollision(footprint.segment(i), scene.twist, o.disc(), scene.horizon);
      times[i].push_back(contact ? contact->time : HUGE_VAL);
    }
  }
  return times;
}

bool areSame(const core::Obstacle& a, const core::Obstacle& b) {
  const core::Motion& m = a.motion();
  const core::Motion& n = b.motion();
  return m.position == n.position && m.velocity == n.velocity && m.acceleration == n.acceleration &&
         a.radius() == b.radius() && a.disc().radius_rate == b.disc().radius_rate &&
         a.outline() == b.outline();
}

/// Of the footprint when there is no segment.
Real gapNow(const Scene& scene, std::size_t obstacle, std::optional<std::size_t> segment) {
  const FootprintOracle oracle(scene.with(obstacle));
  return segment ? oracle.gapOfSegment(*segment, 0) : oracle.clearance();
}

std::string wrongTie(const Scene& scene, const Times& alone, std::size_t named,
                     std::optional<std::size_t> segment) {
  for (std::size_t i = 0; i < named; ++i)
    if (areSame(scene.obstacles[i], scene.obstacles[named]))
      return "obstacle " + std::to_string(i) + " is the same, with a lower index";
  if (alone[named] > 0) return "";
  const Real gap = gapNow(scene, named, segment);
  for (std::size_t i = 0; i < alone.size(); ++i)
    if (alone[i] == 0 && gapNow(scene, i, segment) < gap - 1e-9L)
      return "obstacle " + std::to_string(i) + " is deeper\n" + asCode(scene.with(i)) + "\nthan\n" +
             asCode(scene.with(named));
  return "";
}

/// What is wrong with a contact in the batch, given what the obstacles are alone.
template <typename Contact>
std::string wrong(const Scene& scene, const std::optional<Contact>& contact, const Times& alone,
                  std::optional<std::size_t> segment = {}) {
  const auto earliest = std::min_element(alone.begin(), alone.end());
  const std::size_t first = static_cast<std::size_t>(earliest - alone.begin());
  if (!contact && *earliest == HUGE_VAL) return "";
  if (!contact) return "missed at " + std::to_string(*earliest) + "\n" + asCode(scene.with(first));
  const std::size_t named = contact->obstacle;
  const double time = contact->contact.time;
  if (named >= alone.size()) return "obstacle " + std::to_string(named);
  if (!areBothRight(scene, first, std::min(time, *earliest), std::max(time, *earliest), segment))
    return "at " + std::to_string(time) + ", alone at " + std::to_string(*earliest) + "\n" +
           asCode(scene.with(first));
  if (!areBothRight(scene, named, time, alone[named], segment))
    return "other obstacle\n" + asCode(scene.with(named)) + "\nthan\n" + asCode(scene.with(first));
  return wrongTie(scene, alone, named, segment);
}

TEST(Batch, OfSegmentsIsTheFirstOfAll) {
  forEachCase("batch of segments", kScenes, [](Random& random) -> std::string {
    const Scene scene = anyScene(random);
    const Contacts contacts = contactsIn(scene);
    if (contacts.size() != scene.footprint.size()) return "not one for each segment";
    const std::vector<Times> alone = timesOfSegments(scene);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const std::string text = wrong(scene, contacts[i], alone[i], i);
      if (!text.empty()) return "segment " + std::to_string(i) + ": " + text;
    }
    return "";
  });
}

TEST(Batch, OfTheFootprintIsTheFirstOfAll) {
  forEachCase("batch of footprints", kScenes, [](Random& random) {
    const Scene scene = anyScene(random);
    return wrong(scene, firstIn(scene), timesOfFootprint(scene));
  });
}

template <typename Contact>
bool areEqual(const std::optional<Contact>& a, const std::optional<Contact>& b) {
  return a && b ? a->contact.time == b->contact.time && a->contact.point == b->contact.point &&
                      a->contact.feature == b->contact.feature
                : a.has_value() == b.has_value();
}

TEST(Batch, IsNotChangedByWhatIsOutOfReach) {
  forEachCase("out of reach", kScenes, [](Random& random) -> std::string {
    const Scene scene = anyScene(random);
    Scene more{scene.footprint, scene.twist, {}, scene.horizon};
    std::vector<std::size_t> place;
    for (const core::Obstacle& o : scene.obstacles) {
      while (random.chance(0.5)) more.obstacles.push_back(anyOutOfReach(scene, random));
      place.push_back(more.obstacles.size());
      more.obstacles.push_back(o);
    }
    const auto first = firstIn(scene);
    const auto with_more = firstIn(more);
    if (!areEqual(first, with_more)) return "footprint\n" + asCode(scene.with(first->obstacle));
    if (first && place[first->obstacle] != with_more->obstacle) return "another obstacle";
    const Contacts segments = contactsIn(scene);
    const Contacts segments_with_more = contactsIn(more);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (!areEqual(segments[i], segments_with_more[i])) return "segment " + std::to_string(i);
      if (segments[i] && place[segments[i]->obstacle] != segments_with_more[i]->obstacle)
        return "another obstacle for segment " + std::to_string(i);
    }
    return "";
  });
}

TEST(Batch, RefilledIsAsNew) {
  ObstacleBatch refilled;
  forEachCase("refilled", {300, 10000}, [&](Random& random) -> std::string {
    const Scene scene = anyScene(random);
    refilled.clear();
    for (const core::Obstacle& o : scene.obstacles) refilled.add(o);
    if (refilled.size() != scene.obstacles.size()) return "size";
    const Contacts contacts = contactsIn(scene);
    const Contacts again = contactsIn(scene, refilled);
    for (std::size_t i = 0; i < contacts.size(); ++i)
      if (!areEqual(contacts[i], again[i])) return "segment " + std::to_string(i);
    return "";
  });
}

TEST(Batch, IsWhatIsPredicted) {
  forEachCase("predict", {500, 20000}, [](Random& random) -> std::string {
    const Scene scene = anyScene(random);
    const core::Prediction p =
        predict(Polygon(scene.footprint), scene.twist, scene.obstacles, scene.horizon);
    const Contacts contacts = contactsIn(scene);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (!areEqual(contacts[i], p.segments.at(i))) return "segment " + std::to_string(i);
      if (contacts[i] && contacts[i]->obstacle != p.segments[i]->obstacle) return "other obstacle";
    }
    const std::string text = wrong(scene, p.first, timesOfFootprint(scene));
    if (!text.empty()) return "first: " + text;
    Real clearance = HUGE_VALL;
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i)
      clearance = std::min(clearance, FootprintOracle(scene.with(i)).clearance());
    if (!(std::abs(*p.clearance - clearance) <= 1e-9)) return "clearance";
    if (p.first) return p.closest->distance == 0 ? "" : "closest";
    return p.closest->distance <= clearance + 1e-6 ? "" : "farther than now";
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
