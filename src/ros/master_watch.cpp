#include "master_watch.hpp"

#include <ros/master.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcClient.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <chrono>
#include <functional>
#include <optional>

#include "moment.hpp"

namespace footprint_collision_predictor {
namespace {

using XmlRpc::XmlRpcValue;

constexpr auto kPeriod = std::chrono::seconds(2);
constexpr double kTimeout = 2;  // [s] for an answer
constexpr double kStep = 50;    // [ms] in which a request looks whether it shall stop

class Client : public XmlRpc::XmlRpcClient {
 public:
  using XmlRpcClient::XmlRpcClient;
  bool hasFailed() const { return _connectionState == NO_CONNECTION; }
};

/// [code, message, [publishers, subscribers, services]], each of these [[topic, [node, ...]], ...]
std::optional<XmlRpcValue> systemState(const std::function<bool()>& cancelled) {
  Client client(ros::master::getHost().c_str(), static_cast<int>(ros::master::getPort()), "/");
  XmlRpcValue request, answer;
  request[0] = ros::this_node::getName();
  if (!client.executeNonBlock("getSystemState", request)) return std::nullopt;
  const ros::SteadyTime begin = ros::SteadyTime::now();
  while (!client.hasFailed() && !cancelled() &&
         secondsBetween(begin, ros::SteadyTime::now()) < kTimeout) {
    client._disp.work(kStep);
    if (!client.executeCheckDone(answer)) continue;
    if (client.isFault() || !answer.valid()) return std::nullopt;
    return answer;
  }
  return std::nullopt;
}

std::map<std::string, std::vector<std::string>> publishersIn(XmlRpcValue& state) {
  std::map<std::string, std::vector<std::string>> publishers;
  XmlRpcValue& topics = state[2][0];
  for (int i = 0; i < topics.size(); ++i) {
    std::vector<std::string>& names = publishers[static_cast<std::string&>(topics[i][0])];
    for (int k = 0; k < topics[i][1].size(); ++k)
      names.push_back(static_cast<std::string&>(topics[i][1][k]));
  }
  return publishers;
}

/// Nothing when the master does not answer, or not as it should.
std::optional<MasterView> ask(const std::function<bool()>& cancelled) try {
  std::optional<XmlRpcValue> state = systemState(cancelled);
  if (!state) return std::nullopt;
  return MasterView{true, 0, publishersIn(*state)};
} catch (const XmlRpc::XmlRpcException&) {
  return std::nullopt;
}

}  // namespace

MasterWatch::MasterWatch()
    : view_{true, 0, {}},  // without it there would be no node
      last_answer_(ros::SteadyTime::now()),
      thread_(&MasterWatch::watch, this) {}

MasterWatch::~MasterWatch() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  stop_.notify_all();
  thread_.join();
}

MasterView MasterWatch::view() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  MasterView view = view_;
  view.since_answer = secondsBetween(last_answer_, ros::SteadyTime::now());
  return view;
}

bool MasterWatch::isStopping() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return stopping_;
}

void MasterWatch::watch() {
  while (!isStopping()) {
    const auto view = ask([this] { return isStopping(); });
    std::unique_lock<std::mutex> lock(mutex_);
    view_ = view.value_or(MasterView());
    if (view) last_answer_ = ros::SteadyTime::now();
    stop_.wait_for(lock, kPeriod, [this] { return stopping_; });
  }
}

}  // namespace footprint_collision_predictor
