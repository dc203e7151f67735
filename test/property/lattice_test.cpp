// Integers and Pythagorean triples: the answer is known exactly before anything is computed.
//
// A point P of the segment and an integer vector n of integer length c are chosen so that the
// segment lies behind the line through P across n. A circle of radius j c centred at P + j n then
// touches exactly at P. It is led there for time T along a path which before T was beyond that
// line, so T is the first contact.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <utility>

#include "generators.hpp"
#include "guarantee.hpp"
#include "oracle.hpp"

namespace footprint_collision_predictor::test {
namespace {

struct Place {
  Segment segment;
  Vec2 touched;
  Vec2 outwards;  // integers
  int length;     // of outwards, an integer too
  bool certain_end;
};

Vec2 integers(Random& random, int size) {
  return {random.integer(-size, size), random.integer(-size, size)};
}

/// (a, b) with an integer length, in any of the eight octants.
Vec2 triple(Random& random, int* length) {
  static const std::array<std::array<int, 3>, 6> kTriples{
      {{1, 0, 1}, {3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}, {20, 21, 29}}};
  const std::array<int, 3>& t = kTriples[static_cast<std::size_t>(random.integer(0, 5))];
  *length = t[2];
  const Vec2 v{random.sign() * t[0], random.sign() * t[1]};
  return random.chance(0.5) ? v : Vec2{v.y(), v.x()};
}

/// Touched between the ends or at one of them, square to the segment.
Place besideTheSegment(Random& random) {
  Place place{};
  const Vec2 along = triple(random, &place.length);
  const int pieces = random.integer(2, 6);
  place.segment.start = integers(random, 50);
  place.segment.end = place.segment.start + pieces * along;
  place.touched = place.segment.start + random.integer(0, pieces) * along;
  place.outwards = random.sign() * core::leftNormal(along);
  return place;
}

/// Touched at the start, the rest of the segment lying strictly behind.
Place beyondAnEnd(Random& random) {
  Place place{};
  place.outwards = triple(random, &place.length);
  Vec2 back = integers(random, 20);
  if (back.dot(place.outwards) > 0) back = -back;
  if (back.dot(place.outwards) == 0) back = -place.outwards;
  place.segment.start = place.touched = integers(random, 50);
  place.segment.end = place.segment.start + back;
  place.certain_end = true;
  return place;
}

Place anyPlace(Random& random) {
  Place place = random.chance(0.5) ? besideTheSegment(random) : beyondAnEnd(random);
  if (random.chance(0.5)) std::swap(place.segment.start, place.segment.end);
  return place;
}

/// Even integers, never pulling towards the segment.
Vec2 outwardAcceleration(const Place& place, Random& random) {
  if (random.chance(0.5)) return {0, 0};
  const Vec2 a = 2 * integers(random, 2);
  return a.dot(place.outwards) < 0 ? Vec2{-a} : a;
}

Vec2 approachingVelocity(const Place& place, Random& random) {
  const Vec2 v = integers(random, 6);
  const double towards = v.dot(place.outwards);
  if (towards == 0) return -place.outwards;
  return towards > 0 ? Vec2{-v} : v;
}

/// A point that meets an end at a slant may be said to meet the inside, by a hair: only a circle's
/// centre keeps its distance from the inside.
std::string wrongFeature(const Place& place, const core::Contact& contact, bool is_point) {
  const bool at_start = place.touched == place.segment.start;
  const bool at_end = place.touched == place.segment.end;
  const core::Feature end = at_start ? core::Feature::kStart : core::Feature::kEnd;
  if (place.certain_end && !is_point && (contact.feature != end || contact.point != place.touched))
    return "not exactly the end\n";
  if (!at_start && !at_end && contact.feature != core::Feature::kInside) return "not the inside\n";
  return (contact.point - place.touched).norm() <= 1e-9 ? "" : "not the point touched\n";
}

TEST(Lattice, HitsAreExactAlsoAtTheHorizon) {
  std::size_t asked = 0;
  forEachCase("lattice, hits", kMain, [&asked](Random& random) -> std::string {
    const Place place = anyPlace(random);
    const int j = random.integer(0, 4);
    const double time = random.integer(0, 10);
    const Motion motion =
        leadingTo(place.touched + j * place.outwards, time, approachingVelocity(place, random),
                  outwardAcceleration(place, random));
    const double later = random.chance(0.5) ? 0 : random.integer(1, 10);
    const Case c{place.segment, motion, static_cast<double>(j * place.length), time + later};
    const std::optional<core::Contact> contact = ask(c);
    ++asked;
    std::ostringstream expected;
    expected << "expected " << time << " s\n" << asCode(c);
    const std::optional<Quad> truth = trueContact(c);
    if (j > 0 && !(truth && absolute(*truth - Quad(time)) <= Quad(1e-15)))
      return "oracle: " + expected.str();  // it cannot decide a point that meets an end
    if (!contact) return "missed: " + expected.str();
    if (std::abs(contact->time - time) > 1e-9 || (time == 0 && contact->time != 0))
      return "reported " + std::to_string(contact->time) + ": " + expected.str();
    const std::string wrong = wrongFeature(place, *contact, j == 0);
    return wrong.empty() ? "" : wrong + expected.str();
  });
  std::printf("%-28s %7zu cases\n", "lattice, hits", asked);
}

TEST(Lattice, ExactGrazesAreContact) {
  Tally tally;
  forEachCase("lattice, grazes", kMain, [&tally](Random& random) -> std::string {
    const Place place = anyPlace(random);
    const int j = random.integer(1, 4);
    const double time = random.integer(0, 10);
    const Vec2 sideways = random.sign() * core::leftNormal(place.outwards);
    const Case c{place.segment,
                 leadingTo(place.touched + j * place.outwards, time, sideways,
                           outwardAcceleration(place, random)),
                 static_cast<double>(j * place.length), time + random.integer(0, 3)};
    const std::string wrong = violations(c, &tally);
    if (!wrong.empty()) return wrong;
    const std::optional<core::Contact> contact = ask(c);
    if (contact && contact->time <= time + 1e-9) return "";
    return "missed: touches at " + std::to_string(time) + " s\n" + asCode(c);
  });
  std::printf("%-28s %7zu cases %7zu hits\n", "lattice, grazes", tally.cases, tally.hits);
}

TEST(Lattice, NearMissesAreNone) {
  forEachCase("lattice, misses", kMain, [](Random& random) -> std::string {
    const Place place = anyPlace(random);
    const int j = random.integer(1, 4);
    const double time = random.integer(1, 10);
    const bool too_small = random.chance(0.5);  // else: right size, but 1 ms too late
    const Vec2 sideways = random.sign() * core::leftNormal(place.outwards);
    const Vec2 velocity = too_small ? sideways : approachingVelocity(place, random);
    const Case c{place.segment,
                 leadingTo(place.touched + j * place.outwards, time, velocity,
                           outwardAcceleration(place, random)),
                 j * place.length - (too_small ? 1e-5 : 0), too_small ? 20 : time - 1e-3};
    const std::optional<core::Contact> contact = ask(c);
    return contact ? "invented at " + std::to_string(contact->time) + " s\n" + asCode(c) : "";
  });
}

}  // namespace
}  // namespace footprint_collision_predictor::test
