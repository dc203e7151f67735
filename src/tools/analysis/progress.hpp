// How far the analysis is, for a person who waits.
#pragma once

#include <mutex>
#include <vector>

namespace footprint_collision_predictor::tools {

/// A bar on a terminal, else a line for every 10 %. Bags count alike; may be called from several
/// threads.
class Progress {
 public:
  enum class Style { kNone, kBar, kLines };

  Progress(Style style, std::size_t bags);
  /// Takes the bar away.
  ~Progress();

  /// \param fraction of that bag, from 0 to 1
  void set(std::size_t bag, double fraction);

 private:
  void show(int percent);

  const Style style_;
  std::mutex mutex_;
  std::vector<double> fractions_;
  int shown_ = 0;  // [%]
};

/// What fits stderr.
Progress::Style progressStyle(bool quiet);

}  // namespace footprint_collision_predictor::tools
