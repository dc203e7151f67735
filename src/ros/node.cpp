#include "node.hpp"

#include <ros/console.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>

namespace footprint_collision_predictor {
namespace {

constexpr std::uint32_t kQueueSize = 100;

// [s] How often the worker looks whether the transform or odometry that a message waits for has
// come.
constexpr double kPollPeriod = 1e-3;

constexpr double kReportPeriod = 0.1;  // [s] of what the diagnostics are made of

XmlRpc::XmlRpcValue valuesOf(const ros::NodeHandle& private_node) {
  XmlRpc::XmlRpcValue values;
  private_node.getParam(private_node.getNamespace(), values);
  return values;
}

/// For when nothing could be evaluated: not one number is known.
CollisionWarning unknown(const Parameters& parameters, const Body& body, const std::string& why) {
  Findings findings;
  findings.add(CollisionWarning::REASON_DEADLINE, why);
  CollisionWarning msg =
      warningMsg(nullptr, ros::Time::now(), core::Level::kUnknown, findings, parameters, body);
  msg.data_age = std::numeric_limits<double>::infinity();
  return msg;
}

/// What another body's inputs add.
void add(const Report& other, Report& report) {
  report.obstacles.findings.add(other.obstacles.findings);
  if (!report.odometry)
    report.odometry = other.odometry;
  else if (other.odometry)
    report.odometry->findings.add(other.odometry->findings);
  report.bodies.insert(report.bodies.end(), other.bodies.begin(), other.bodies.end());
}

template <typename Predictors>
std::vector<const WarningPublisher*> warningsOf(const Predictors& predictors) {
  std::vector<const WarningPublisher*> warnings;
  for (const auto& predictor : predictors) warnings.push_back(&predictor.warnings);
  return warnings;
}

}  // namespace

Node::Node(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : Node(node, private_node, valuesOf(private_node)) {}

Node::Node(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
           const XmlRpc::XmlRpcValue& values)
    : parameters_(parametersFrom(values)),
      used_(parameters_.get()),
      node_(node),
      private_node_(private_node),
      predictions_(node_.advertise<CollisionPrediction>("collision_prediction", kQueueSize)),
      markers_(private_node_.advertise<visualization_msgs::MarkerArray>("markers", 1)),
      session_(std::random_device{}()),
      predictors_(makePredictors()),
      reconfiguration_(private_node_, values, [this](const Parameters& p) { parameters_.set(p); }),
      diagnostics_(node_, private_node_, {warningsOf(predictors_), master_, reconfiguration_},
                   report(now())) {
  node_.setCallbackQueue(&queue_);
  for (const Predictor& predictor : predictors_) addInputs(predictor);
  for (Input& input : inputs_) subscribe(input);
  subscribeTransforms("/tf", false);
  subscribeTransforms("/tf_static", true);
  worker_ = std::thread(&Node::work, this);
  heartbeat_ = std::thread([this] { beat(); });
}

Node::~Node() {
  {
    const std::lock_guard<std::mutex> lock(stop_mutex_);
    running_ = false;
  }
  stop_.notify_all();
  worker_.join();
  heartbeat_.join();
}

Node::Predictor::Predictor(Node& node, const Body& body)
    : pipeline(*node.used_, body,
               {node.node_.resolveName("obstacles"),
                body.topic.empty() ? "" : node.node_.resolveName(body.topic),
                node.node_.resolveName("odom")},
               node.tf_, ros::Time::isSimTime(),
               [this, &node](const Answer& answer) { node.publish(answer, warnings); }),
      warnings(node.node_, node.session_, pipeline.repeat(now())) {}

std::list<Node::Predictor> Node::makePredictors() {
  std::list<Predictor> predictors;
  for (const Body& body : bodiesOf(*used_)) predictors.emplace_back(*this, body);
  return predictors;
}

void Node::takeNewParameters() {
  const auto newest = parameters_.get();
  if (newest == used_) return;
  used_ = newest;
  for (Predictor& predictor : predictors_) predictor.pipeline.reconfigure(*used_);
}

/// The warning first: it is what others wait for.
void Node::publish(const Answer& answer, WarningPublisher& warnings) {
  const ros::SteadyTime finished = ros::SteadyTime::now();
  const double elapsed = secondsBetween(answer.now.steady, finished);
  const bool evaluated = !std::isnan(answer.warning.clearance);
  if (evaluated) times_.add(elapsed, 1 / used_->heartbeat_rate, finished);
  warnings.publish(finishedAfter(elapsed, answer.warning, *used_));
  if (answer.prediction) predictions_.publish(*answer.prediction);
}

bool Node::isWaiting() const {
  return std::any_of(predictors_.begin(), predictors_.end(),
                     [](const Predictor& predictor) { return predictor.pipeline.isWaiting(); });
}

void Node::work() {
  ros::SteadyTime next = ros::SteadyTime::now();
  while (running_) {
    progress_ = ros::SteadyTime::now().toNSec();
    takeNewParameters();
    const ros::WallDuration period(1 / used_->heartbeat_rate);
    const double left = secondsBetween(ros::SteadyTime::now(), next);
    const double wait = isWaiting() ? std::min(left, kPollPeriod) : left;
    queue_.callAvailable(ros::WallDuration(std::max(0.0, wait)));
    const Moment at = now();
    forEach([&](Predictor& predictor) { predictor.pipeline.process(at); });
    if (ros::SteadyTime::now() < next) continue;
    next = std::max(next + period, ros::SteadyTime::now());
    guarded([&] { goRound(now()); });
  }
}

/// What is done once in a period of the heartbeat, besides taking in messages.
void Node::goRound(const Moment& now) {
  repeat(now);
  renewAbandonedInputs();
  if (secondsBetween(last_report_, now.steady) < kReportPeriod) return;
  last_report_ = now.steady;
  const MasterView master = master_.view();
  for (Predictor& predictor : predictors_)
    predictor.pipeline.setRegistered([&](const std::string& topic) {
      const auto found = master.publishers.find(topic);
      return found == master.publishers.end() ? std::vector<std::string>() : found->second;
    });
  const Report newest = report(now);
  tellOfClock(newest.clock);
  diagnostics_.update(newest);
}

/// All warnings first, then what RViz shows of them.
void Node::repeat(const Moment& now) {
  std::vector<std::pair<const Pipeline*, CollisionWarning>> repeated;
  forEach([&](Predictor& predictor) {
    repeated.emplace_back(&predictor.pipeline, predictor.pipeline.repeat(now));
    publish({repeated.back().second, {}, now}, predictor.warnings);
  });
  if (markers_.getNumSubscribers() == 0) return;
  visualization_msgs::MarkerArray all;
  for (const auto& [pipeline, warning] : repeated) {
    const auto some = pipeline->picture(warning, now);
    all.markers.insert(all.markers.end(), some.markers.begin(), some.markers.end());
  }
  markers_.publish(all);
}

void Node::tellOfClock(const ClockReport& clock) {
  if (clock.jumps_back == jumps_told_) return;
  jumps_told_ = clock.jumps_back;
  ROS_WARN_STREAM("the clock jumped back, it is " << clock.time
                                                  << ": all inputs of the old time are dropped");
}

Report Node::report(const Moment& now) const {
  Report report = predictors_.front().pipeline.report(now);
  for (auto other = std::next(predictors_.begin()); other != predictors_.end(); ++other)
    add(other->pipeline.report(now), report);
  report.computation = times_.report(1 / used_->heartbeat_rate, now.steady);
  return report;
}

/// Looks several times in a period, so that little is added to the silence that is allowed.
void Node::beat() {
  constexpr double kLooks = 4;
  auto parameters = parameters_.get();
  const auto stopped = [this] { return !running_; };
  std::unique_lock<std::mutex> lock(stop_mutex_);
  const auto pause = [&] {
    return std::chrono::duration<double>(1 / (kLooks * parameters->heartbeat_rate));
  };
  while (!stop_.wait_for(lock, pause(), stopped)) {
    parameters = parameters_.get();
    for (Predictor& predictor : predictors_)
      beat(*parameters, predictor.warnings, predictor.pipeline.body());
  }
}

/// Steps in when the worker has been silent: with its newest result while it may just be late, and
/// with UNKNOWN when it has not come round for so long that it must be taken to hang.
void Node::beat(const Parameters& parameters, WarningPublisher& warnings, const Body& body) {
  const double period = 1 / parameters.heartbeat_rate;
  const double patience = std::max(2 * period, 0.1);
  warnings.publishIfSilent(1.5 * period, [&](const CollisionWarning& last, double silence) {
    const std::uint64_t progress = progress_;  // first, so that the difference is not negative
    const double hang = 1e-9 * static_cast<double>(ros::SteadyTime::now().toNSec() - progress);
    if (hang <= patience) return olderBy(silence, last, parameters);
    return unknown(parameters, body,
                   "no evaluation has finished for " + std::to_string(hang) +
                       " s: too many obstacles, or an overloaded machine");
  });
}

/// What goes wrong with one body does not hold up the others.
void Node::forEach(const std::function<void(Predictor&)>& step) {
  for (Predictor& predictor : predictors_) try {
      step(predictor);
    } catch (const std::exception& error) {
      sayFailed(error, predictor);
    }
}

void Node::guarded(const std::function<void()>& step) try {
  step();
} catch (const std::exception& error) {
  for (Predictor& predictor : predictors_) sayFailed(error, predictor);
}

void Node::sayFailed(const std::exception& error, Predictor& predictor) {
  ROS_ERROR_STREAM_THROTTLE(1, "an evaluation failed: " << error.what());
  predictor.warnings.publish(unknown(*used_, predictor.pipeline.body(),
                                     std::string("an evaluation failed: ") + error.what()));
}

}  // namespace footprint_collision_predictor
