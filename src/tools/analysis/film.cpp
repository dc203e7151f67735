#include "film.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "frame_json.hpp"

namespace footprint_collision_predictor::tools {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

constexpr double kAround = 3;           // [s] before and after what is near
constexpr double kFinestStep = 0.125;   // [s]
constexpr double kCoarsestAlone = 2;    // [s] beyond which what is near is thinned as well
constexpr double kCoarsestFar = 64;     // [s] beyond which all are thinned alike
constexpr double kDetail = 32;          // times as many frames around what is near
constexpr std::size_t kOverhead = 100;  // [bytes] of a frame beside its text

/// [s] 0: every frame is kept.
struct Steps {
  double far;
  double near;
};

Steps stepsAfter(int thinnings) {
  const double far = std::ldexp(kFinestStep, thinnings - 1);
  return {far, far > kCoarsestAlone ? far / kDetail : 0};
}

}  // namespace

bool Film::isNearer(const Frame& a, const Frame& b) {
  return std::tie(a.time_to_collision, a.clearance) < std::tie(b.time_to_collision, b.clearance);
}

std::size_t Film::costOf(const Frame& frame) { return frame.json.size() + kOverhead; }

void Film::take(const Evaluation& evaluation) {
  levels_.take(evaluation);
  const CollisionWarning& w = evaluation.answer.warning;
  const double time = w.collision_predicted != 0 ? w.time_to_collision : kFar;
  const bool near = w.level == CollisionWarning::WARN || w.level == CollisionWarning::CRITICAL ||
                    time <= warn_time_;
  frames_.push_back({evaluation.elapsed, time, std::fmin(w.clearance, kFar),
                     w.level == CollisionWarning::UNKNOWN, near, frameJson(evaluation)});
  bytes_ += costOf(frames_.back());
  if (bytes_ <= budget_) return;
  if (thinnings_ > 0) thin();  // what has come since the last time
  while (bytes_ > budget_ / 2 && frames_.size() > 2) {
    ++thinnings_;
    thin();
  }
}

void Film::forEach(const std::function<void(const std::string&)>& use) const {
  for (const Frame& frame : frames_) use(frame.json);
}

/// Which frames are near, or little before or after one that is.
std::vector<bool> Film::aroundNear() const {
  std::vector<bool> around(frames_.size());
  double last = -kFar;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    if (frames_[i].is_near) last = frames_[i].elapsed;
    around[i] = frames_[i].elapsed - last <= kAround;
  }
  double next = frames_.back().elapsed;  // what follows may be near
  for (std::size_t i = frames_.size(); i-- > 0;) {
    if (frames_[i].is_near) next = frames_[i].elapsed;
    if (next - frames_[i].elapsed <= kAround) around[i] = true;
  }
  return around;
}

/// Of each slot of time the nearest of the known frames, and the nearest of the others.
void Film::thin() {
  const Steps steps = stepsAfter(thinnings_);
  const std::vector<bool> detailed =
      steps.far > kCoarsestFar ? std::vector<bool>(frames_.size(), true) : aroundNear();
  std::vector<Frame> kept;
  std::optional<std::pair<bool, double>> slot;
  std::optional<std::size_t> of_slot[2];  // places in `kept`, by is_unknown
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    Frame& frame = frames_[i];
    const double step = detailed[i] ? steps.near : steps.far;
    const std::pair<bool, double> here(
        detailed[i], step > 0 ? std::floor(frame.elapsed / step) : static_cast<double>(i));
    if (slot != here) of_slot[0] = of_slot[1] = std::nullopt;
    slot = here;
    auto& place = of_slot[frame.is_unknown ? 1 : 0];
    if (!place) {
      place = kept.size();
      kept.push_back(std::move(frame));
    } else if (isNearer(frame, kept[*place])) {
      kept[*place] = std::move(frame);
    }
  }
  const auto earlier = [](const Frame& a, const Frame& b) { return a.elapsed < b.elapsed; };
  std::stable_sort(kept.begin(), kept.end(), earlier);
  frames_ = std::move(kept);
  bytes_ = 0;
  for (const Frame& frame : frames_) bytes_ += costOf(frame);
}

}  // namespace footprint_collision_predictor::tools
