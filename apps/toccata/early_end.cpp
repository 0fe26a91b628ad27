#include "early_end.hpp"

#include <atomic>
#include <chrono>

namespace toccata::command {
namespace {

using EndClock = std::chrono::steady_clock;

const EndClock::time_point program_start = EndClock::now();

/// A handler can reach nothing else.
std::atomic<bool> is_asked_to_end = false;
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

EarlyEnd::EarlyEnd(double limit) : limit_(limit) {
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    sigaction(signals_[i], nullptr, &before_[i]);
    if (before_[i].sa_handler == SIG_IGN) continue;
    struct sigaction ask {};
    ask.sa_handler = [](int) { is_asked_to_end = true; };
    ask.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
    sigaction(signals_[i], &ask, nullptr);
  }
}

EarlyEnd::~EarlyEnd() {
  for (std::size_t i = 0; i < signals_.size(); ++i) sigaction(signals_[i], &before_[i], nullptr);
}

bool EarlyEnd::is_due() const {
  if (is_asked_to_end) return true;
  return std::chrono::duration<double>(EndClock::now() - program_start).count() > limit_;
}

bool was_interrupted() { return is_asked_to_end; }

}  // namespace toccata::command
