#include "guarantee.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <sstream>

#include "oracle.hpp"
#include "truth.hpp"

namespace footprint_collision_predictor::test {
namespace {

constexpr double kLateness = 1e-9;    // [s]
constexpr double kGap = 1e-9;         // [m]
constexpr double kTurningGap = 1e-6;  // [m]

std::string tooLate(const Case& c, const std::optional<core::Contact>& contact, Tally* tally) {
  const Truth truth = truthOf(c);
  if (!truth.is_decided) ++tally->undecided;
  if (!truth.contact) return "";
  std::ostringstream text;
  text.precision(17);
  const double t = static_cast<double>(*truth.contact);
  if (!contact) {
    ++tally->misses;
    text << "missed: true contact at " << t << " s\n";
    return text.str();
  }
  const double late = static_cast<double>(Quad(contact->time) - *truth.contact);
  tally->worst_lateness = std::max(tally->worst_lateness, late);
  if (late > kLateness * std::max(1.0, t))
    text << "late by " << late << " s: true contact at " << t << " s, reported " << contact->time
         << " s\n";
  return text.str();
}

/// What the core promises of itself is far stricter; twice, since it decides in double.
double promisedGap(const Case& c, double t) {
  if (c.twist.angular != 0) return 2e-9 * std::max(1.0, sizeOfCoordinates(c, t));
  const Disc seen{relativeMotion(c.circle, c.twist), c.radius, c.radius_rate};
  return 2 * contactTolerance(c.segment, seen, t);
}

std::string notTrue(const Case& c, const core::Contact& contact, Tally* tally) {
  std::ostringstream text;
  text.precision(17);
  if (!(contact.time >= 0 && contact.time <= c.horizon)) {
    text << "time " << contact.time << " s is not within [0, " << c.horizon << "]\n";
    return text.str();
  }
  const double size = std::max(1.0, sizeOfCoordinates(c, contact.time));
  const double tolerance = allowedGap(c, contact.time);
  const double gap = static_cast<double>(trueGap(c, contact.time));
  tally->worst_gap = std::max(tally->worst_gap, gap);
  tally->worst_share = std::max(tally->worst_share, gap / size);
  if (!(gap <= tolerance))
    text << "invented: the gap is " << gap << " m at the reported " << contact.time << " s\n";
  const double promised = promisedGap(c, contact.time);
  if (!(gap <= promised))
    text << "the gap is " << gap << " m at the reported " << contact.time << " s, promised are "
         << promised << " m\n";
  const double off = static_cast<double>(distanceFromNearest(c, contact.time, contact.point));
  const double rounding = 0x1p-52 * contact.point.norm();  // of the point itself, far away
  if (!(off <= tolerance + rounding))
    text << "the contact point is " << off << " m from the nearest one\n";
  if ((contact.feature == core::Feature::kStart && contact.point != c.segment.start) ||
      (contact.feature == core::Feature::kEnd && contact.point != c.segment.end))
    text << "the contact point is not exactly the end that is named\n";
  return text.str();
}

const char* environment(const char* name, const char* otherwise) {
  const char* value = std::getenv(name);
  return value ? value : otherwise;
}

}  // namespace

double allowedGap(const Case& c, double t) {
  return (c.twist.angular == 0 ? kGap : kTurningGap) * std::max(1.0, sizeOfCoordinates(c, t));
}

std::string violations(const Case& c, Tally* tally) {
  const std::optional<core::Contact> contact = ask(c);
  ++tally->cases;
  if (contact) ++tally->hits;
  const std::string wrong =
      tooLate(c, contact, tally) + (contact ? notTrue(c, *contact, tally) : "");
  return wrong.empty() ? "" : wrong + asCode(c);
}

void expectGuarantee(const Case& c) {
  Tally tally;
  EXPECT_EQ(violations(c, &tally), "");
}

std::uint64_t suiteSeed() { return std::strtoull(environment("PROPERTY_SEED", "1"), nullptr, 10); }

std::size_t scaled(const SuiteSize& size) {
  const bool is_long = environment("PROPERTY_LONG", "0") == std::string("1");
  const std::size_t cases = is_long ? size.long_run : size.each_time;
  const double scale = std::strtod(environment("PROPERTY_SCALE", "1"), nullptr);
  return static_cast<std::size_t>(static_cast<double>(cases) * scale);
}

void forEachCase(const std::string& suite, const SuiteSize& size,
                 const std::function<std::string(Random&)>& each) {
  const std::size_t cases = scaled(size);
  int failed = 0;
  for (std::size_t i = 0; i < cases && failed < 5; ++i) {
    Random random(suiteSeed(), i);
    std::string wrong;
    try {
      wrong = each(random);
    } catch (const std::exception& e) {
      wrong = std::string("thrown: ") + e.what();
    }
    if (wrong.empty()) continue;
    ++failed;
    ADD_FAILURE() << "suite '" << suite << "', PROPERTY_SEED=" << suiteSeed() << ", case " << i
                  << ":\n"
                  << wrong;
  }
}

Tally runSuite(const std::string& suite, const SuiteSize& size,
               const std::function<Case(Random&)>& make) {
  Tally tally;
  forEachCase(suite, size, [&](Random& random) { return violations(make(random), &tally); });
  std::printf(
      "%-28s %7zu cases %7zu hits %3zu missed, worst: %7.1e s late, gap %7.1e m (%7.1e of size)",
      suite.c_str(), tally.cases, tally.hits, tally.misses, tally.worst_lateness, tally.worst_gap,
      tally.worst_share);
  if (tally.undecided > 0) std::printf(", %zu undecided", tally.undecided);
  std::printf("\n");
  return tally;
}

}  // namespace footprint_collision_predictor::test
