#include "recording.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <future>
#include <mutex>
#include <set>
#include <tuple>

#include "../exit_status.hpp"
#include "analysis_status.hpp"
#include "bag_problem.hpp"

namespace footprint_collision_predictor::tools {
namespace {

// [s] As long as tf2 keeps transforms.
constexpr double kLeadIn = 10;

// [bytes] Read by a thread of its own while the batch before is looked at.
constexpr std::size_t kBatch = 1 << 18;

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

[[noreturn]] void unreadable(const std::string& path, const std::string& why) {
  throw BagProblem(kBagUnreadable, path + ": " + why);
}

void requireFile(const std::string& path) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::string start(8, '\0');
  if (!in.read(start.data(), 8) && errno != 0) unreadable(path, std::strerror(errno));
  if (start != "#ROSBAG ")
    unreadable(path,
               "this is not a ROS 1 bag (it does not begin with #ROSBAG). A ROS 2 recording or an "
               "mcap file must be converted first");
}

[[noreturn]] void unindexed(const std::string& path) {
  if (endsWith(path, ".active"))
    unreadable(path,
               "this bag is still being recorded, or its recorder was killed. End the recorder "
               "with Ctrl-C; if it is gone, run: rosbag reindex " +
                   path + "   and rename the file to .bag");
  unreadable(path,
             "it has no index: its recorder did not end properly, or the file is cut off. Run: "
             "rosbag reindex " +
                 path);
}

[[noreturn]] void damaged(const std::string& path, const std::string& why) {
  unreadable(path, "it is damaged or cut off (" + why + "). Run: rosbag reindex " + path);
}

/// Runs a step of the bag library, which has exceptions for much, and for damage others.
template <typename Step>
void reading(const std::string& path, const Step& step) try {
  step();
} catch (const rosbag::BagUnindexedException&) {
  unindexed(path);
} catch (const BagProblem&) {
  throw;
} catch (const std::exception& error) {
  damaged(path, error.what());
}

bool isLatched(const rosbag::ConnectionInfo& connection) {
  if (!connection.header) return false;
  const auto found = connection.header->find("latching");
  return found != connection.header->end() && found->second == "1";
}

/// The bag library loads and unloads a plugin with every bag, which is not for several threads at
/// once.
std::shared_ptr<rosbag::Bag> opened(const std::string& path) {
  static std::recursive_mutex mutex;
  const auto close = [](rosbag::Bag* bag) {
    const std::lock_guard<std::recursive_mutex> lock(mutex);
    delete bag;
  };
  const std::lock_guard<std::recursive_mutex> lock(mutex);
  std::shared_ptr<rosbag::Bag> bag(new rosbag::Bag, close);
  bag->open(path, rosbag::bagmode::Read);
  return bag;
}

/// Gives the bag library room for the bytes of a message whose length only it knows.
struct ByteStream {
  std::vector<std::uint8_t>& bytes;
  std::uint8_t* advance(std::uint32_t count) {
    bytes.resize(count);
    return bytes.data();
  }
};

RawMessage rawOf(const rosbag::MessageInstance& message) {
  RawMessage raw{message.getDataType(), message.getMD5Sum(), {}};
  ByteStream stream{raw.bytes};
  message.write(stream);
  return raw;
}

/// Messages that are read together.
struct Batch {
  std::vector<RecordedMessage> messages;
  std::exception_ptr problem;  // why there is none after them
};

ros::Time earlier(const ros::Time& time, double seconds) {
  return time.toSec() > seconds ? time - ros::Duration(seconds) : ros::TIME_MIN;
}

ros::Time justBefore(const ros::Time& time) { return time - ros::Duration(0, 1); }

}  // namespace

Recording::Recording(const std::string& path) : path_(path) {
  requireFile(path);
  reading(path, [&] {
    bag_ = opened(path);
    rosbag::View all(*bag_);
    if (all.size() == 0) unreadable(path, "there is no message in it");
    span_ = {all.getBeginTime(), all.getEndTime()};
  });
}

std::vector<RecordedTopic> Recording::topics() const {
  std::set<std::tuple<std::string, std::string, std::string>> found;
  for (const rosbag::ConnectionInfo* info : rosbag::View(*bag_).getConnections())
    found.emplace(info->topic, info->datatype, info->md5sum);
  std::vector<RecordedTopic> topics;
  for (const auto& [name, type, md5] : found) topics.push_back({name, type, md5});
  return topics;
}

std::size_t Recording::messagesOf(const std::string& topic) const {
  return rosbag::View(*bag_, rosbag::TopicQuery(topic)).size();
}

void Recording::read(const Window& window, const std::map<std::string, Input>& inputs,
                     const std::function<bool()>& go_on, const Take& take) const {
  using Connection = rosbag::ConnectionInfo;
  const auto wanted = [&](const Connection* info) { return inputs.count(info->topic) > 0; };
  const auto latched = [&](const Connection* info) { return wanted(info) && isLatched(*info); };
  rosbag::View view;
  reading(path_, [&] {
    const ros::Time recent = std::max(span_.begin, earlier(window.begin, kLeadIn));
    if (recent > span_.begin) view.addQuery(*bag_, latched, span_.begin, justBefore(recent));
    view.addQuery(*bag_, wanted, recent, window.end);
  });
  rosbag::View::iterator message;
  reading(path_, [&] { message = view.begin(); });
  const auto readNext = [&] {
    RecordedMessage next{inputs.at(message->getTopic()), message->getTime(), rawOf(*message)};
    ++message;
    return next;
  };
  const auto readBatch = [&] {
    Batch batch;
    std::size_t bytes = 0;
    try {
      reading(path_, [&] {
        while (message != view.end() && bytes < kBatch) {
          batch.messages.push_back(readNext());
          bytes += sizeof(RecordedMessage) + batch.messages.back().raw.bytes.size();
        }
      });
    } catch (...) {
      batch.problem = std::current_exception();
    }
    return batch;
  };
  Batch batch = readBatch();
  while (!batch.messages.empty() || batch.problem) {
    std::future<Batch> next;
    if (!batch.problem) next = std::async(std::launch::async, readBatch);
    for (const RecordedMessage& one : batch.messages) {
      if (!go_on()) return;
      take(one);
    }
    if (batch.problem) std::rethrow_exception(batch.problem);
    batch = next.get();
  }
}

}  // namespace footprint_collision_predictor::tools
