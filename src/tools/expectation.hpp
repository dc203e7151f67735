// What a scenario's answers are, and whether the warnings that came agree with them.
#pragma once

#include <footprint_collision_predictor/CollisionWarning.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace footprint_collision_predictor::tools {

/// Thrown for a file of answers that cannot be used; what() names it and says why.
class ReadError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The answers, as make_scenario writes them. Times in [s] since `start`: in absolute seconds a
/// double has no more than 2e-7 s.
struct Answers {
  unsigned start;
  double last;
  std::optional<double> contact;
  std::optional<double> first_warn;
  std::optional<double> first_critical;
  std::optional<std::string> footprint;  ///< nothing where the robot has only one
  std::optional<int> segment;
  std::optional<std::int64_t> obstacle_id;
  double warn_time;
  double critical_time;
};

/// \throws ReadError
Answers readAnswers(const std::string& path);

/// Follows the warnings of one run.
class Expectation {
 public:
  explicit Expectation(const Answers& answers) : answers_(answers) {}

  /// [s] since the scenario's start; nothing for a stamp before it (such as 0).
  std::optional<double> timeOf(const ros::Time& stamp) const;
  void take(const CollisionWarning& warning);
  /// Whether the scenario's last moment has been answered.
  bool isOver() const { return newest_ >= answers_.last; }
  /// [s] of the newest warning, or -1: to see whether time goes on.
  double newest() const { return newest_; }

  /// A table for a person, closed by what disagrees.
  std::string summary() const;
  /// kSuccess, kDisagrees or kNoWarning.
  int exitStatus() const;

 private:
  struct Seen {
    double t;
    CollisionWarning warning;
  };

  std::vector<std::string> disagreements() const;
  bool nothingCame() const;

  Answers answers_;
  double newest_ = -1;
  bool known_ = false;            ///< something else than UNKNOWN has come
  std::optional<Seen> warn_;      ///< first WARN or CRITICAL
  std::optional<Seen> critical_;  ///< first CRITICAL
};

}  // namespace footprint_collision_predictor::tools
