// The node's entries in /diagnostics.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "master_watch.hpp"
#include "reconfiguration.hpp"
#include "report.hpp"
#include "warning_publisher.hpp"

namespace footprint_collision_predictor {

class Diagnostics {
 public:
  /// What is asked directly, since it answers from any thread.
  struct Sources {
    std::vector<const WarningPublisher*> warnings;  ///< at least one
    const MasterWatch& master;
    const Reconfiguration& reconfiguration;
  };

  /// \param sources outlive this
  /// \param first tells which bodies and inputs there are, in the order of the warnings
  Diagnostics(ros::NodeHandle& node, ros::NodeHandle& private_node, const Sources& sources,
              const Report& first);

  /// What to say from now on; thread-safe.
  void update(const Report& report);

 private:
  using Describe = std::function<void(const Report&, diagnostic_updater::DiagnosticStatusWrapper&)>;

  void addLevels(const std::vector<BodyReport>& bodies);
  void addFootprints(const std::vector<BodyReport>& bodies);
  void addTransforms(const std::vector<BodyReport>& bodies);
  void add(const std::string& name, const Describe& describe);
  void publish();

  /// diagnostic_updater announces every entry with an OK of which it knows nothing.
  class Updater : public diagnostic_updater::Updater {
   public:
    using diagnostic_updater::Updater::Updater;

   private:
    void addedTaskCallback(DiagnosticTaskInternal&) override {}
  };

  const Sources sources_;
  std::mutex mutex_;
  Report report_;
  Updater updater_;
  ros::WallTimer timer_;  // by wall time, so that it goes on when a simulated clock stands still
};

}  // namespace footprint_collision_predictor
