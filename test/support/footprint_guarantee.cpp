#include "footprint_guarantee.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "footprint_oracle.hpp"

namespace footprint_collision_predictor::test {
namespace {

using Answers = std::vector<std::optional<core::SegmentContact>>;

constexpr Real kLateness = 1e-9;
constexpr double kClosest = 1e-6;

/// Puts the answers to one case to the oracle, and writes down what is wrong.
class Examination {
 public:
  Examination(const FootprintCase& c, FootprintTally* tally)
      : c_(c),
        tally_(tally),
        oracle_(c),
        footprint_(c.footprint),
        within_(oracle_.isWithinNow()),
        touches_(oracle_.firstTouchOfEachSegment()),
        touch_(oracle_.firstTouch(touches_)) {
    wrong_.precision(17);
  }

  std::string run() {
    const core::Obstacle obstacle = obstacleOf(c_);
    const core::ObstacleBatch batch({obstacle});
    ++tally_->cases;
    const auto first = firstContact(footprint_, c_.twist, obstacle, c_.horizon);
    countIn(first);
    examineFirst("footprint", first);
    const auto in_batch = firstContact(footprint_, c_.twist, batch, c_.horizon);
    compare("footprint", first, in_batch);
    if (first && in_batch &&
        (first->segment != in_batch->segment || first->closing_speed != in_batch->closing_speed))
      wrong_ << "another segment or closing speed in a batch\n";
    Answers segments;
    firstContacts(footprint_, c_.twist, batch, c_.horizon, &segments);
    for (std::size_t i = 0; i < footprint_.size(); ++i) examineSegment(i, segments.at(i));
    examinePrediction(predict(footprint_, c_.twist, {obstacle}, c_.horizon), segments);
    return wrong_.str();
  }

 private:
  double tolerance(double t) const {
    return (c_.twist.angular == 0 ? 1e-9 : 1e-6) * std::max(1.0, sizeOfCoordinates(c_, t));
  }

  void countIn(const std::optional<core::FootprintContact>& first) {
    if (!touch_.contact_at && touch_.free_until < c_.horizon) ++tally_->undecided;
    if (first) ++tally_->hits;
    if (first && first->contact.time == 0) ++tally_->now;
  }

  void examineFirst(const std::string& name, const std::optional<core::FootprintContact>& first) {
    examineTime(name, touch_, first ? &first->contact : nullptr);
    if (!first) return;
    if (!(first->closing_speed >= 0)) wrong_ << "closing speed " << first->closing_speed << "\n";
    if (first->obstacle != 0) wrong_ << "obstacle " << first->obstacle << "\n";
    if (first->segment >= footprint_.size())
      wrong_ << "segment " << first->segment << "\n";
    else
      examinePlace(name, first->segment, first->contact,
                   within_ ? static_cast<double>(oracle_.gap(0)) : 0);
    const bool start_of_another =
        first->contact.feature == core::Feature::kStart && first->segment > 0;
    const bool end_of_last =
        first->contact.feature == core::Feature::kEnd && first->segment + 1 == footprint_.size();
    if (start_of_another || end_of_last) wrong_ << "not the lower index on a vertex\n";
  }

  void examineSegment(std::size_t i, const std::optional<core::SegmentContact>& contact) {
    const std::string name = "segment " + std::to_string(i);
    examineTime(name, touches_[i], contact ? &contact->contact : nullptr);
    if (contact) examinePlace(name, i, contact->contact, 0);
  }

  void examineTime(const std::string& name, const FirstTouch& touch, const core::Contact* contact) {
    if (!touch.contact_at) return;
    if (!contact) {
      wrong_ << name << " missed: true contact at " << *touch.contact_at << " s\n";
      return;
    }
    const Real late = contact->time - *touch.contact_at;
    tally_->worst_lateness = std::max(tally_->worst_lateness, static_cast<double>(late));
    if (late > kLateness * std::max(Real(1), *touch.contact_at))
      wrong_ << name << " late by " << late << " s: true contact at " << *touch.contact_at
             << " s, reported " << contact->time << " s\n";
  }

  /// `more` is what the gap may be larger, for one that is within the other.
  void examinePlace(const std::string& name, std::size_t segment, const core::Contact& contact,
                    double more) {
    if (!(contact.time >= 0 && contact.time <= c_.horizon)) {
      wrong_ << name << ": time " << contact.time << " s is not within the horizon\n";
      return;
    }
    const double allowed = tolerance(contact.time);
    const double gap = static_cast<double>(oracle_.gapOfSegment(segment, contact.time));
    tally_->worst_gap = std::max(tally_->worst_gap, gap - more);
    if (!(gap <= more + allowed))
      wrong_ << name << " invented: segment " << segment << " has a gap of " << gap
             << " m at the reported " << contact.time << " s\n";
    const double of_point = static_cast<double>(oracle_.gapOfPoint(contact.point, contact.time));
    const double touched = more > 0 || c_.outline.empty() ? gap : std::max(gap, 0.0);
    if (!(of_point <= touched + allowed))
      wrong_ << name << ": the contact point has a gap of " << of_point << " m, the segment " << gap
             << " m\n";
    examinePoint(name, footprint_.segment(segment), contact);
  }

  void examinePoint(const std::string& name, const core::Segment& s, const core::Contact& contact) {
    const double rounding =
        0x1p-48 * sizeOfCoordinates(c_, contact.time) + 0x1p-51 * contact.point.norm();
    if (!(distance(s, contact.point) <= rounding))
      wrong_ << name << ": the contact point is " << distance(s, contact.point)
             << " m beside the segment\n";
    if ((contact.feature == core::Feature::kStart && contact.point != s.start) ||
        (contact.feature == core::Feature::kEnd && contact.point != s.end))
      wrong_ << name << ": the contact point is not exactly the end that is named\n";
  }

  void examinePrediction(const core::Prediction& p, const Answers& segments) {
    examineFirst("predict().first", p.first);
    for (std::size_t i = 0; i < segments.size(); ++i)
      compare("segment " + std::to_string(i), segments[i], p.segments.at(i));
    if (!p.clearance || !p.closest) {
      wrong_ << "no clearance or no closest approach\n";
      return;
    }
    const Real clearance = oracle_.clearance();
    if (!(std::abs(*p.clearance - clearance) <= 1e-9 * std::max(1.0, sizeOfCoordinates(c_, 0))))
      wrong_ << "clearance " << *p.clearance << " m instead of " << clearance << " m\n";
    examineClosest(*p.closest, p.first);
  }

  /// What comes from the same function is the same to the last bit.
  template <typename Answer>
  void compare(const std::string& name, const std::optional<Answer>& one,
               const std::optional<Answer>& other) {
    const bool same = one && other ? one->contact.time == other->contact.time &&
                                         one->contact.point == other->contact.point &&
                                         one->contact.feature == other->contact.feature
                                   : one.has_value() == other.has_value();
    if (!same)
      wrong_ << name << " at " << (one ? one->contact.time : -1) << " s and elsewhere at "
             << (other ? other->contact.time : -1) << " s\n";
  }

  void examineClosest(const core::ClosestApproach& closest,
                      const std::optional<core::FootprintContact>& first) {
    if (first) {
      if (closest.distance != 0 || closest.time != first->contact.time)
        wrong_ << "closest " << closest.distance << " m at " << closest.time << " s in a contact\n";
      return;
    }
    const SmallestGap smallest = oracle_.smallestGap();
    const double off = std::abs(closest.distance - static_cast<double>(smallest.gap));
    tally_->worst_closest = std::max(tally_->worst_closest, off);
    if (!(off <= kClosest + 1e-7))
      wrong_ << "closest " << closest.distance << " m at " << closest.time << " s instead of "
             << smallest.gap << " m at " << smallest.time << " s\n";
    if (!(closest.time >= 0 && closest.time <= c_.horizon &&
          oracle_.gap(closest.time) <= smallest.gap + kClosest))
      wrong_ << "not closest at " << closest.time << " s but at " << smallest.time << " s\n";
  }

  const FootprintCase& c_;
  FootprintTally* tally_;
  FootprintOracle oracle_;
  core::Polygon footprint_;
  bool within_;
  std::vector<FirstTouch> touches_;  // of each segment
  FirstTouch touch_;                 // of the footprint
  std::ostringstream wrong_;
};

}  // namespace

std::string violations(const FootprintCase& c, FootprintTally* tally) {
  const std::string wrong = Examination(c, tally).run();
  return wrong.empty() ? "" : wrong + asCode(c);
}

void expectFootprintGuarantee(const FootprintCase& c) {
  FootprintTally tally;
  EXPECT_EQ(violations(c, &tally), "");
}

void runFootprintSuite(const std::string& suite, const SuiteSize& size,
                       const std::function<FootprintCase(Random&)>& make) {
  FootprintTally tally;
  forEachCase(suite, size, [&](Random& random) { return violations(make(random), &tally); });
  std::printf(
      "%-28s %6zu cases %6zu hits (%zu now) %3zu undecided, worst: %7.1e s late, gap %7.1e m, "
      "closest %7.1e m\n",
      suite.c_str(), tally.cases, tally.hits, tally.now, tally.undecided, tally.worst_lateness,
      tally.worst_gap, tally.worst_closest);
}

}  // namespace footprint_collision_predictor::test
