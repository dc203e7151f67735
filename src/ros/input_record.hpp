// What has come on one input, and what became of it.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "findings.hpp"
#include "moment.hpp"
#include "raw_message.hpp"

namespace footprint_collision_predictor {

enum class InputKind { kObstacles, kFootprint, kOdometry };

/// Messages since the start.
struct InputCounts {
  std::uint64_t received = 0;
  std::uint64_t accepted = 0;
  std::uint64_t refused = 0;
  std::uint64_t ignored = 0;  ///< older than the newest
};

class InputRecord {
 public:
  explicit InputRecord(std::string topic) : topic_(std::move(topic)) {}

  void receive(const RawMessage& message, const ros::SteadyTime& now);
  /// \param stamp_and_arrival of a good message, which ends what was wrong with earlier ones
  void accept(const Moment& stamp_and_arrival);
  /// Stands until the next good message.
  void refuse(const Findings& why, const ros::SteadyTime& now);
  /// For a message older than the newest. \return the words for it
  Findings ignore();
  /// Whom the master knows as publishers; empty when it cannot be asked.
  void setRegistered(std::vector<std::string> publishers) { registered_ = std::move(publishers); }
  /// After a jump of the clock: neither the newest stamp nor a refusal of the old time counts.
  void forget();

  const std::string& topic() const { return topic_; }
  /// Stamp and arrival of the newest good message.
  const std::optional<Moment>& newest() const { return newest_; }
  const Findings& refusal() const { return refusal_; }
  const InputCounts& counts() const { return counts_; }
  /// Of the newest message, whatever became of it; empty before the first.
  const std::string& type() const { return type_; }
  const std::string& md5() const { return md5_; }
  /// Why a message was refused last, also when good ones have come since; empty when none was.
  const std::string& lastRefusal() const { return last_refusal_; }
  const ros::SteadyTime& lastRefusalTime() const { return last_refusal_time_; }

  /// Messages per second [Hz] over the last seconds, good or not; it falls when they cease.
  double rate(const ros::SteadyTime& now) const;
  /// Nodes that have sent something in the last seconds, and those that the master knows.
  std::vector<std::string> publishers(const ros::SteadyTime& now) const;
  /// REASON_SEVERAL_PUBLISHERS, naming them, or nothing.
  Findings severalPublishers(const ros::SteadyTime& now) const;

 private:
  std::string topic_;
  std::string type_;
  std::string md5_;
  InputCounts counts_;
  std::optional<Moment> newest_;
  Findings refusal_;
  std::string last_refusal_;
  ros::SteadyTime last_refusal_time_;
  std::deque<ros::SteadyTime> arrivals_;
  std::map<std::string, ros::SteadyTime> heard_;  // when each node last sent something
  std::vector<std::string> registered_;
};

}  // namespace footprint_collision_predictor
