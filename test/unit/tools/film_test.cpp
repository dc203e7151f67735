// Which evaluations a report keeps.
#include "analysis/film.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace footprint_collision_predictor::tools {
namespace {

using W = CollisionWarning;

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kWarnTime = 3;
constexpr std::size_t kBudget = 60000;  // [bytes] some 400 frames without a scene

class FilmTest : public testing::Test {
 protected:
  void at(double elapsed, double time_to_collision, double clearance = 9) {
    Evaluation evaluation{elapsed, false, {}};
    W& warning = evaluation.answer.warning;
    const bool unknown = std::isnan(time_to_collision);
    warning.level = unknown ? W::UNKNOWN : time_to_collision <= kWarnTime ? W::WARN : W::CLEAR;
    warning.time_to_collision = time_to_collision;
    warning.collision_predicted = std::isfinite(time_to_collision) ? 1 : 0;
    warning.clearance = clearance;
    warning.segment = -1;
    warning.obstacle_id = -1;
    film.take(evaluation);
  }

  /// Ten evaluations a second, in each of which the time to collision is as given.
  template <typename TimeToCollision>
  void drive(double seconds, const TimeToCollision& time_to_collision) {
    for (int i = 0; i < 10 * seconds; ++i) at(0.1 * i, time_to_collision(0.1 * i));
  }

  std::vector<double> kept() const {
    std::vector<double> times;
    film.forEach([&](const std::string& json) {
      times.push_back(nlohmann::json::parse(json)[0].get<double>());
    });
    return times;
  }

  bool keeps(double elapsed) const {
    for (const double t : kept())
      if (std::abs(t - elapsed) < 1e-6) return true;
    return false;
  }

  std::size_t bytes() const {
    std::size_t sum = 0;
    film.forEach([&](const std::string& json) { sum += json.size(); });
    return sum;
  }

  Film film{kWarnTime, kBudget};
};

TEST_F(FilmTest, KeepsEverythingOfAShortDrive) {
  drive(10, [](double) { return kNone; });
  EXPECT_EQ(film.size(), 100u);
  EXPECT_FALSE(film.isThinned());
}

TEST_F(FilmTest, KeepsEverythingAroundWhatIsNear) {
  drive(200, [](double t) { return std::abs(t - 100) < 1.01 ? 2.0 : kNone; });
  EXPECT_TRUE(film.isThinned());
  EXPECT_LE(bytes(), kBudget);
  for (double t = 96.1; t < 103.95; t += 0.1) EXPECT_TRUE(keeps(t)) << t;
  for (double t = 0; t < 190; t += 4) {  // never nothing for long
    const auto times = kept();
    const auto next = std::lower_bound(times.begin(), times.end(), t);
    EXPECT_TRUE(next != times.end() && *next - t < 9) << t;
  }
}

TEST_F(FilmTest, KeepsTheWorstMoment) {
  drive(2000, [](double t) { return std::abs(t - 1234.5) < 0.01 ? 3.5 : kNone; });
  EXPECT_TRUE(keeps(1234.5));
}

TEST_F(FilmTest, KeepsTheNearestMomentOfAllNearOnes) {
  drive(2000, [](double t) { return std::abs(t - 1234.5) < 0.01 ? 0.7 : 1 + std::fmod(t, 2); });
  EXPECT_LE(bytes(), kBudget);
  EXPECT_TRUE(keeps(1234.5));
}

TEST_F(FilmTest, KeepsTheSmallestClearance) {
  for (int i = 0; i < 20000; ++i) at(0.1 * i, kNone, i == 7777 ? 0.3 : 5);
  EXPECT_TRUE(keeps(777.7));
}

TEST_F(FilmTest, KeepsAMomentThatIsUnknownBesideKnownOnes) {
  drive(2000, [](double t) { return std::abs(t - 777.7) < 0.01 ? std::nan("") : kNone; });
  EXPECT_TRUE(keeps(777.7));
}

TEST_F(FilmTest, OrderIsThatOfTime) {
  drive(2000, [](double t) { return std::fmod(t, 7) < 1 ? std::nan("") : std::fmod(t, 20); });
  const auto times = kept();
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  EXPECT_GT(times.size(), 20u);
}

TEST_F(FilmTest, StaysWithinItsBudgetWhateverComes) {
  // Approaches that take turns with calm: nothing is in a class of its own for long.
  drive(20000, [](double t) { return std::fmod(t, 10) < 1 ? 1.0 : kNone; });
  EXPECT_LE(bytes(), kBudget);
  EXPECT_GT(film.size(), 40u);
}

TEST_F(FilmTest, OneFrameThatIsLargerThanTheBudgetIsKept) {
  Film small(kWarnTime, 50);
  Evaluation evaluation{1, false, {}};
  small.take(evaluation);
  EXPECT_EQ(small.size(), 1u);
}

}  // namespace
}  // namespace footprint_collision_predictor::tools
