#include "interruption.hpp"

#include <atomic>
#include <csignal>

namespace footprint_collision_predictor::tools {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler writes it");

void interrupt(int signal) {
  interrupted = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watchForInterruption() {
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
}

bool isInterrupted() { return interrupted; }

}  // namespace footprint_collision_predictor::tools
