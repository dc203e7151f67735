#include "time_to_collision_cases.hpp"

namespace footprint_collision_predictor::test {
namespace {

using core::Feature;

const Segment kLine{{0, 0}, {4, 0}};
constexpr bool kGraze = true;

Motion straight(const Vec2& position, const Vec2& velocity) { return {position, velocity, {0, 0}}; }

NamedCase hit(const std::string& name, const Case& question, double time, Feature feature,
              const Vec2& point, bool graze = false) {
  return {name, question, time, feature, point, graze};
}

NamedCase none(const std::string& name, const Case& question) {
  return {name, question, std::nullopt, Feature::kInside, {0, 0}, false};
}

// The inside, from both sides. Centre 5 m off, radius 1: 4 m to go.
std::vector<NamedCase> insideCases() {
  return {
      hit("inside from the left", {kLine, straight({2, 5}, {0, -2}), 1, 10}, 2, Feature::kInside,
          {2, 0}),
      hit("inside from the right", {kLine, straight({2, -5}, {0, 2}), 1, 10}, 2, Feature::kInside,
          {2, 0}),
      hit("inside at a slant", {kLine, straight({-1, 5}, {1, -2}), 1, 10}, 2, Feature::kInside,
          {1, 0}),
      hit("point onto the inside", {kLine, straight({3, 5}, {0, -2}), 0, 10}, 2.5, Feature::kInside,
          {3, 0}),
      none("receding from the inside", {kLine, straight({2, 5}, {0, 2}), 1, 10}),
      none("receding on the other side", {kLine, straight({2, -5}, {0, -2}), 1, 10}),
      none("parallel, passing clear", {kLine, straight({-9, 1.5}, {3, 0}), 1, 10}),
      none("beyond the end, crossing its line", {kLine, straight({6, 5}, {0, -2}), 1, 10}),
      // Crosses the height 1 at t = 2 at x = -8, far beyond the start, then runs off below.
      none("in the strip only beyond the end", {kLine, straight({-8, 5}, {0, -2}), 1, 10}),
  };
}

// The ends. 3-4-5: with radius 5 the end is touched when it is 3 m ahead at a height of 4 m.
std::vector<NamedCase> endCases() {
  return {
      hit("start on its rim", {kLine, straight({-6, 4}, {1, 0}), 5, 10}, 3, Feature::kStart,
          {0, 0}),
      hit("end on its rim", {kLine, straight({10, -4}, {-1, 0}), 5, 10}, 3, Feature::kEnd, {4, 0}),
      hit("end-on at the start", {kLine, straight({-6, 0}, {1, 0}), 1, 10}, 5, Feature::kStart,
          {0, 0}),
      hit("end-on at the end", {kLine, straight({10, 0}, {-1, 0}), 1, 10}, 5, Feature::kEnd,
          {4, 0}),
      hit("point end-on", {kLine, straight({-6, 0}, {2, 0}), 0, 10}, 3, Feature::kStart, {0, 0}),
      none("end-on, receding", {kLine, straight({-6, 0}, {-1, 0}), 1, 10}),
      none("passes the end", {kLine, straight({-6, 4}, {0, -1}), 5, 10}),
      hit("grazes the start", {kLine, straight({-1, -5}, {0, 1}), 1, 10}, 5, Feature::kStart,
          {0, 0}, kGraze),
      // |(6 - t, 5 - 2t) - (4, 0)| = 1: 5 t^2 - 24 t + 28 = 0, t = 2 or 2.8.
      hit("at a slant onto the point above the end", {kLine, straight({6, 5}, {-1, -2}), 1, 10}, 2,
          Feature::kInside, {4, 0}),
      // The strip is entered at t = 1 at x = 8, beyond the end; |(5 - t, 6 - t)| = 5:
      // t^2 - 11 t + 18 = 0, t = 2 or 9.
      hit("later root needed: enters the strip beyond the end, then touches the end",
          {kLine, straight({9, 6}, {-1, -1}), 5, 10}, 2, Feature::kEnd, {4, 0}),
      // |(5 - t, 2 - t)| = 3: t^2 - 7 t + 10 = 0, t = 2 or 5.
      hit("in the strip beyond the end from the beginning",
          {kLine, straight({9, 2}, {-1, -1}), 3, 10}, 2, Feature::kEnd, {4, 0}),
      hit("zero-length segment", {{{2, 1}, {2, 1}}, straight({2, 8}, {0, -1}), 3, 10}, 4,
          Feature::kStart, {2, 1}),
      none("zero-length segment, passed by", {{{2, 1}, {2, 1}}, straight({6, 8}, {0, -1}), 3, 10}),
  };
}

std::vector<NamedCase> nowCases() {
  return {
      hit("touching now, moving in", {kLine, straight({2, 1}, {0, -1}), 1, 10}, 0, Feature::kInside,
          {2, 0}),
      hit("touching now, moving out", {kLine, straight({2, 1}, {0, 1}), 1, 10}, 0, Feature::kInside,
          {2, 0}),
      hit("touching now, sliding", {kLine, straight({2, 1}, {1, 0}), 1, 10}, 0, Feature::kInside,
          {2, 0}),
      hit("touching now, standing", {kLine, straight({2, 1}, {0, 0}), 1, 10}, 0, Feature::kInside,
          {2, 0}),
      hit("touching the end now, moving out", {kLine, straight({5, 0}, {1, 0}), 1, 10}, 0,
          Feature::kEnd, {4, 0}),
      hit("touching the start now, sliding", {kLine, straight({-1, 0}, {0, 1}), 1, 10}, 0,
          Feature::kStart, {0, 0}),
      hit("overlapping now, leaving", {kLine, straight({2, 0.5}, {0, 1}), 1, 10}, 0,
          Feature::kInside, {2, 0}),
      hit("overlapping an end now, leaving", {kLine, straight({-0.5, 0}, {-1, 0}), 1, 10}, 0,
          Feature::kStart, {0, 0}),
      hit("centre on the segment", {kLine, straight({1, 0}, {0, 1}), 1, 10}, 0, Feature::kInside,
          {1, 0}),
      hit("point on the segment, leaving", {kLine, straight({1, 0}, {0, 1}), 0, 10}, 0,
          Feature::kInside, {1, 0}),
      none("standing still, clear", {kLine, straight({2, 2}, {0, 0}), 1, 10}),
      none("standing still, clear of an end", {kLine, straight({6, 0}, {0, 0}), 1, 10}),
      hit("parallel, sliding on at the start", {kLine, straight({-3, 1}, {1, 0}), 1, 10}, 3,
          Feature::kStart, {0, 0}, kGraze),
      hit("parallel, sliding on at the end", {kLine, straight({9, -1}, {-1, 0}), 1, 10}, 5,
          Feature::kEnd, {4, 0}, kGraze),
  };
}

// p = 5 - u t + a t^2 / 2 above the inside; contact at height 1, 4 m down.
std::vector<NamedCase> acceleratedCases() {
  return {
      hit("falling from rest", {kLine, {{2, 5}, {0, 0}, {0, -2}}, 1, 10}, 2, Feature::kInside,
          {2, 0}),
      hit("stopping exactly at contact", {kLine, {{2, 5}, {0, -4}, {0, 2}}, 1, 10}, 2,
          Feature::kInside, {2, 0}, kGraze),
      none("stopping 1 mm short", {kLine, {{2, 5}, {0, -4}, {0, 2}}, 0.999, 10}),
      // 5 - 5 t + t^2 = 1: t = 1 or 4.
      hit("stopping past contact", {kLine, {{2, 5}, {0, -5}, {0, 2}}, 1, 10}, 1, Feature::kInside,
          {2, 0}),
      // 1 + 3 t - t^2 is the height above 4: 5 + 3 t - t^2 = 1, t = 4.
      hit("away and back", {kLine, {{2, 5}, {0, 3}, {0, -2}}, 1, 10}, 4, Feature::kInside, {2, 0}),
      none("away and back after the horizon", {kLine, {{2, 5}, {0, 3}, {0, -2}}, 1, 3.999}),
      hit("away and back onto an end", {kLine, {{-5, 0}, {-3, 0}, {2, 0}}, 1, 10}, 4,
          Feature::kStart, {0, 0}),
      // Down the strip beyond the start, and in from the side by the acceleration: at t = 4 the
      // centre is at (-9 + t^2 / 2, 0) = (-1, 0).
      hit("acceleration across the velocity", {kLine, {{-9, 4}, {0, -1}, {1, 0}}, 1, 10}, 4,
          Feature::kStart, {0, 0}),
      // Through height 1 beyond the start at t = 1 and t = 7, over the inside at t = 7:
      // y = 1 + (t - 1)(t - 7) = 8 - 8 t + t^2 is below -1 in between; back up through -1 at
      // t^2 - 8 t + 9 = 0, t = 4 + sqrt(7) = 6.65, x = t - 5 = 1.65.
      hit("later root needed: dives under the line and comes up",
          {kLine, {{-5, 8}, {1, -8}, {0, 2}}, 1, 10}, 6.6457513110645905905, Feature::kInside,
          {1.6457513110645905905, 0}),
      hit("accelerating along the segment, end-on", {kLine, {{-9, 0}, {0, 0}, {1, 0}}, 1, 10}, 4,
          Feature::kStart, {0, 0}),
      none("accelerating away", {kLine, {{2, 5}, {0, 0}, {0, 2}}, 1, 10}),
      hit("accelerating away from touching", {kLine, {{2, 1}, {0, 0}, {0, 2}}, 1, 10}, 0,
          Feature::kInside, {2, 0}),
      // 3-4-5 again: -7.5 + t^2 / 2 = -3 at t = 3.
      hit("accelerating onto a rim", {kLine, {{-7.5, 4}, {0, 0}, {1, 0}}, 5, 10}, 3,
          Feature::kStart, {0, 0}),
  };
}

Case growing(const Motion& motion, double radius, double rate, double horizon = 10) {
  return {kLine, motion, radius, horizon, rate};
}

std::vector<NamedCase> growingCases() {
  return {
      hit("grows onto the inside", growing(straight({2, 3}, {0, 0}), 0.5, 0.5), 5, Feature::kInside,
          {2, 0}),
      hit("grows onto an end", growing(straight({-3, 4}, {0, 0}), 1, 0.5), 8, Feature::kStart,
          {0, 0}),
      hit("grows out of a point", growing(straight({2, -3}, {0, 0}), 0, 1), 3, Feature::kInside,
          {2, 0}),
      hit("grows as it comes", growing(straight({2, 5}, {0, -1}), 1, 1), 2, Feature::kInside,
          {2, 0}),
      hit("grows as it passes", growing(straight({-6, 4}, {1, 0}), 2, 1), 3, Feature::kStart,
          {0, 0}),
      hit("leaves more slowly than it grows", growing(straight({2, 5}, {0, 1}), 1, 3), 2,
          Feature::kInside, {2, 0}),
      none("leaves as fast as it grows", growing(straight({2, 5}, {0, 1}), 1, 1)),
      none("leaves an end faster than it grows", growing(straight({7, 4}, {3, 4}), 4.5, 4.9)),
      hit("grows as it falls", growing({{2, 5}, {0, 0}, {0, -2}}, 0, 0.5), 2, Feature::kInside,
          {2, 0}),
      // Up at first: 1 + 4 t - t^2 above a radius of 0 + t: t^2 - 3 t - 4 = 0 at 4.
      hit("grows as it goes away and comes back", growing({{2, 4}, {0, 4}, {0, -2}}, 0, 1), 4,
          Feature::kInside, {2, 0}),
      hit("stops and grows on", growing({{2, 5}, {0, -4}, {0, 2}}, 0.5, 0.25), 2, Feature::kInside,
          {2, 0}),
      hit("touches now, leaves faster than it grows", growing(straight({2, 1}, {0, 2}), 1, 1), 0,
          Feature::kInside, {2, 0}),
      hit("rests at its rim while it grows", growing(straight({2, 1}, {0, 1}), 1, 1), 0,
          Feature::kInside, {2, 0}),
      hit("exactly at the horizon by growing", growing(straight({2, 3}, {0, 0}), 1, 0.5, 4), 4,
          Feature::kInside, {2, 0}),
      none("just after the horizon by growing", growing(straight({2, 3}, {0, 0}), 1, 0.5, 3.999)),
      // In the strip from t = 3, at x = 8; |(7 - t, 4)| = 1 + t at 4.
      hit("its strip reaches it beyond the end, then it touches the end",
          growing(straight({11, 4}, {-1, 0}), 1, 1), 4, Feature::kEnd, {4, 0}),
  };
}

std::vector<NamedCase> horizonCases() {
  return {
      hit("exactly at the horizon", {kLine, straight({2, 5}, {0, -2}), 1, 2}, 2, Feature::kInside,
          {2, 0}),
      hit("an end exactly at the horizon", {kLine, straight({-6, 4}, {1, 0}), 5, 3}, 3,
          Feature::kStart, {0, 0}),
      hit("accelerated, exactly at the horizon", {kLine, {{2, 5}, {0, 0}, {0, -2}}, 1, 2}, 2,
          Feature::kInside, {2, 0}),
      none("just after the horizon", {kLine, straight({2, 5}, {0, -2}), 1, 2 - 1e-6}),
      none("an end just after the horizon", {kLine, straight({-6, 4}, {1, 0}), 5, 3 - 1e-6}),
      none("horizon 0, clear", {kLine, straight({2, 5}, {0, -2}), 1, 0}),
      hit("horizon 0, touching", {kLine, straight({2, 1}, {0, -2}), 1, 0}, 0, Feature::kInside,
          {2, 0}),
  };
}

}  // namespace

const std::vector<NamedCase>& namedCases() {
  static const std::vector<NamedCase> kAll = [] {
    std::vector<NamedCase> all;
    for (const auto& part : {insideCases(), endCases(), nowCases(), acceleratedCases(),
                             growingCases(), horizonCases(), turningCases()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return kAll;
}

}  // namespace footprint_collision_predictor::test
