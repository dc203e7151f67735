#include "progress.hpp"

#include <unistd.h>

#include <cstdio>
#include <numeric>
#include <string>

namespace footprint_collision_predictor::tools {

Progress::Progress(Style style, std::size_t bags) : style_(style), fractions_(bags, 0.0) {}

Progress::~Progress() {
  if (style_ == Style::kBar && shown_ > 0) std::fprintf(stderr, "\r\033[K");
}

void Progress::set(std::size_t bag, double fraction) {
  if (style_ == Style::kNone) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  fractions_.at(bag) = fraction;
  const double sum = std::accumulate(fractions_.begin(), fractions_.end(), 0.0);
  const int percent = static_cast<int>(100 * sum / static_cast<double>(fractions_.size()) + 1e-9);
  const int step = style_ == Style::kBar ? 1 : 10;
  if (percent / step > shown_ / step) show(percent / step * step);
}

void Progress::show(int percent) {
  shown_ = percent;
  if (style_ == Style::kLines) {
    std::fprintf(stderr, "%d %%\n", percent);
    return;
  }
  const std::string done(static_cast<std::size_t>(percent) / 2, '#');
  std::fprintf(stderr, "\r[%-50s] %3d %%", done.c_str(), percent);
  std::fflush(stderr);
}

Progress::Style progressStyle(bool quiet) {
  if (quiet) return Progress::Style::kNone;
  return isatty(STDERR_FILENO) != 0 ? Progress::Style::kBar : Progress::Style::kLines;
}

}  // namespace footprint_collision_predictor::tools
