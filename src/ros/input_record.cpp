#include "input_record.hpp"

#include <algorithm>
#include <set>

#include "input_findings.hpp"

namespace footprint_collision_predictor {
namespace {

constexpr double kRateWindow = 5;            // [s]
constexpr std::size_t kMostArrivals = 1000;  // bounds the memory, whatever the rate
constexpr std::size_t kMostPublishers = 20;  // likewise, for names that change with every start

// [s] How long a node that has sent something counts as publisher when the master does not say so:
// much longer than a period of any tracker, so that two of them are noticed at their first
// messages.
constexpr double kHeardFor = 2;

std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

}  // namespace

void InputRecord::receive(const RawMessage& message, const ros::SteadyTime& now) {
  ++counts_.received;
  type_ = message.type;
  md5_ = message.md5;
  arrivals_.push_back(now);
  while (arrivals_.size() > kMostArrivals || secondsBetween(arrivals_.front(), now) > kRateWindow)
    arrivals_.pop_front();
  if (message.publisher.empty()) return;
  heard_[message.publisher] = now;
  if (heard_.size() <= kMostPublishers) return;
  heard_.erase(std::min_element(heard_.begin(), heard_.end(),
                                [](const auto& a, const auto& b) { return a.second < b.second; }));
}

void InputRecord::accept(const Moment& stamp_and_arrival) {
  ++counts_.accepted;
  newest_ = stamp_and_arrival;
  refusal_ = {};
}

void InputRecord::refuse(const Findings& why, const ros::SteadyTime& now) {
  ++counts_.refused;
  refusal_ = why;
  last_refusal_ = why.text();
  last_refusal_time_ = now;
}

Findings InputRecord::ignore() {
  Findings findings;
  findings.add(CollisionWarning::REASON_OUT_OF_ORDER, ignoredText(topic_, ++counts_.ignored));
  return findings;
}

void InputRecord::forget() {
  newest_.reset();
  refusal_ = {};
}

double InputRecord::rate(const ros::SteadyTime& now) const {
  if (arrivals_.size() < 2) return 0;
  const double window = secondsBetween(arrivals_.front(), now);
  if (window > 2 * kRateWindow || window <= 0) return 0;
  return static_cast<double>(arrivals_.size() - 1) / window;
}

std::vector<std::string> InputRecord::publishers(const ros::SteadyTime& now) const {
  std::set<std::string> names(registered_.begin(), registered_.end());
  for (const auto& [name, time] : heard_)
    if (secondsBetween(time, now) <= kHeardFor) names.insert(name);
  return {names.begin(), names.end()};
}

Findings InputRecord::severalPublishers(const ros::SteadyTime& now) const {
  const std::vector<std::string> names = publishers(now);
  Findings findings;
  if (names.size() > 1)
    findings.add(CollisionWarning::REASON_SEVERAL_PUBLISHERS,
                 std::to_string(names.size()) + " nodes publish on " + topic_ + " (" +
                     listed(names) +
                     "), of which each message replaces the other's: keep one, or remap the others "
                     "(rosnode cleanup forgets nodes that died)");
  return findings;
}

}  // namespace footprint_collision_predictor
