// The newest parameters, for every thread.
#pragma once

#include <memory>
#include <mutex>

#include "parameters.hpp"

namespace footprint_collision_predictor {

class LiveParameters {
 public:
  explicit LiveParameters(const Parameters& parameters)
      : newest_(std::make_shared<const Parameters>(parameters)) {}

  /// A set that never changes: whoever keeps it sees no mixture of old and new.
  std::shared_ptr<const Parameters> get() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return newest_;
  }
  void set(const Parameters& parameters) {
    const auto next = std::make_shared<const Parameters>(parameters);
    const std::lock_guard<std::mutex> lock(mutex_);
    newest_ = next;
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const Parameters> newest_;
};

}  // namespace footprint_collision_predictor
