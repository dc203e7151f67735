// Asks the ROS master now and then who publishes what, and notices when it does not answer.
#pragma once

#include <ros/time.h>

#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace footprint_collision_predictor {

struct MasterView {
  bool answers = false;
  double since_answer = 0;  ///< [s] since the last answer, or since the watch began
  std::map<std::string, std::vector<std::string>> publishers;  ///< by topic; empty without answer
};

/// In a thread of its own: a master that is out of reach can take minutes to fail to answer.
class MasterWatch {
 public:
  MasterWatch();
  ~MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

  MasterView view() const;  ///< thread-safe

 private:
  void watch();
  bool isStopping() const;

  mutable std::mutex mutex_;
  std::condition_variable stop_;
  bool stopping_ = false;
  MasterView view_;
  ros::SteadyTime last_answer_;
  std::thread thread_;
};

}  // namespace footprint_collision_predictor
