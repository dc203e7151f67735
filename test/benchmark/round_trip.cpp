#include "round_trip.hpp"

#include <stdexcept>

namespace footprint_collision_predictor::bench {

RoundTrip::RoundTrip(const std::string& answers) : spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  const boost::function<void(const boost::shared_ptr<const Stamped>&)> callback =
      [this](const boost::shared_ptr<const Stamped>& answer) { take(*answer); };
  subscriber_ = node_.subscribe<Stamped>(answers, 10, callback, ros::VoidConstPtr(),
                                         ros::TransportHints().tcpNoDelay());
  spinner_.start();
}

void RoundTrip::take(const Stamped& answer) {
  const Clock::time_point now = Clock::now();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (answer.stamp != awaited_) return;
  arrival_ = now;
  awaited_ = {};
  arrived_.notify_one();
}

double RoundTrip::measure(const ros::Time& stamp, const std::function<void()>& send) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    awaited_ = stamp;
  }
  const Clock::time_point sent = Clock::now();
  send();
  std::unique_lock<std::mutex> lock(mutex_);
  if (!arrived_.wait_for(lock, std::chrono::seconds(5), [this] { return awaited_.isZero(); }))
    throw std::runtime_error("no answer on " + subscriber_.getTopic());
  return std::chrono::duration<double>(arrival_ - sent).count();
}

}  // namespace footprint_collision_predictor::bench
