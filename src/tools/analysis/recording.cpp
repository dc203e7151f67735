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

/// Into the memory of the message before.
void readInto(const rosbag::MessageInstance& message, RawMessage* raw) {
  raw->type = message.getDataType();
  raw->md5 = message.getMD5Sum();
  ByteStream stream{raw->bytes};
  message.write(stream);
}

/// Messages that were read together, in the memory of those before them.
struct Batch {
  std::vector<RecordedMessage> messages;
  std::size_t count = 0;       // the messages beyond are of earlier batches
  std::size_t bytes = 0;       // of the messages
  std::exception_ptr problem;  // why there is none after them

  bool isEmpty() const { return count == 0 && !problem; }

  void clear() {
    count = bytes = 0;
    problem = nullptr;
  }

  template <typename Read>
  void add(const Read& read) {
    if (count == messages.size()) messages.emplace_back();
    read(messages[count]);
    bytes += messages[count++].raw.bytes.size();
  }
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
  const auto readNext = [&](RecordedMessage& next) {
    next.input = inputs.at(message->getTopic());
    next.recorded = message->getTime();
    readInto(*message, &next.raw);
    ++message;
  };
  const auto readBatch = [&](Batch& batch) {
    batch.clear();
    try {
      reading(path_, [&] {
        while (message != view.end() && batch.bytes < kBatch) batch.add(readNext);
      });
    } catch (...) {
      batch.problem = std::current_exception();
    }
  };
  Batch batch, next;
  readBatch(next);
  while (!next.isEmpty()) {
    std::swap(batch, next);
    std::future<void> reader;
    if (!batch.problem) reader = std::async(std::launch::async, [&] { readBatch(next); });
    for (std::size_t i = 0; i < batch.count; ++i) {
      if (!go_on()) return;
      take(batch.messages[i]);
    }
    if (batch.problem) std::rethrow_exception(batch.problem);
    reader.wait();
  }
}

}  // namespace footprint_collision_predictor::tools
