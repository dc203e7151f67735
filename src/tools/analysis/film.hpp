// The evaluations of a recording that its report shows.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "level_runs.hpp"
#include "replay.hpp"

namespace footprint_collision_predictor::tools {

/// Keeps evaluations within a budget of memory, whatever the length of the recording. When it is
/// used up they are thinned: those far from anything near first, down to one in two seconds, then
/// all. Of those of one slot of time the nearest to a contact stays, else the one with the
/// smallest clearance, and so of the UNKNOWN ones: the worst moment of a recording is always there.
/// The same recording gives the same film.
class Film {
 public:
  /// \param warn_time [s] at or below which a time to collision is near
  /// \param budget [bytes] of the frames' texts
  explicit Film(double warn_time, std::size_t budget = kBudget)
      : warn_time_(warn_time), budget_(budget) {}

  void take(const Evaluation& evaluation);

  /// As frameJson() has them, in order.
  void forEach(const std::function<void(const std::string& json)>& use) const;
  std::size_t size() const { return frames_.size(); }
  const std::vector<LevelRun>& levels() const { return levels_.runs(); }
  /// Whether anything has been left out.
  bool isThinned() const { return thinnings_ > 0; }

 private:
  static constexpr std::size_t kBudget = 6000000;

  struct Frame {
    double elapsed;            // [s]
    double time_to_collision;  // [s] infinite where none is certain
    double clearance;          // [m] infinite where it is not known
    bool is_unknown;
    bool is_near;
    std::string json;
  };

  static bool isNearer(const Frame& a, const Frame& b);
  static std::size_t costOf(const Frame& frame);  // [bytes]
  void thin();
  std::vector<bool> aroundNear() const;

  const double warn_time_;
  const std::size_t budget_;
  LevelRuns levels_;
  std::vector<Frame> frames_;
  std::size_t bytes_ = 0;
  int thinnings_ = 0;
};

}  // namespace footprint_collision_predictor::tools
