// A bag, read message by message; never held in memory, apart from its index.
#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "raw_message.hpp"

namespace footprint_collision_predictor::tools {

struct RecordedTopic {
  std::string name;
  std::string type;
  std::string md5;
};

/// What a topic is read as.
enum class Input { kObstacles, kFootprint, kOdometry, kTransforms, kFixedTransforms, kClock };

struct RecordedMessage {
  Input input;
  ros::Time recorded;
  RawMessage raw;
};

/// The part of a recording that is looked at, by the times of recording.
struct Window {
  ros::Time begin;
  ros::Time end;
};

class Recording {
 public:
  using Take = std::function<void(const RecordedMessage&)>;

  /// \throws BagProblem when it cannot be read
  explicit Recording(const std::string& path);

  /// In the order of their names; one with several types is there once for each.
  std::vector<RecordedTopic> topics() const;
  std::size_t messagesOf(const std::string& topic) const;
  /// From the first message to the last.
  const Window& span() const { return span_; }

  /// Hands over the messages of the window in the order of their recording; before them what a
  /// subscriber who comes at its begin would know: latched messages, and the recent others. Reads
  /// ahead in a thread of its own, and hands over in the caller's.
  /// \param go_on is asked before each message
  /// \throws BagProblem when the bag turns out to be damaged; what came before has been handed over
  void read(const Window& window, const std::map<std::string, Input>& inputs,
            const std::function<bool()>& go_on, const Take& take) const;

 private:
  std::string path_;
  std::shared_ptr<rosbag::Bag> bag_;
  Window span_;
};

}  // namespace footprint_collision_predictor::tools
