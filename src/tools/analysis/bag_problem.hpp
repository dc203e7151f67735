// What keeps a bag from being analysed.
#pragma once

#include <stdexcept>
#include <string>

namespace footprint_collision_predictor::tools {

/// what() names the bag, says what is wrong, and what to do about it.
class BagProblem : public std::runtime_error {
 public:
  BagProblem(int status, const std::string& text) : std::runtime_error(text), status_(status) {}
  /// kUsage when another command line helps, else kBagUnreadable.
  int status() const { return status_; }

 private:
  int status_;
};

}  // namespace footprint_collision_predictor::tools
