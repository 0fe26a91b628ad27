#include "calls.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <thread>

namespace toccata::python {
namespace {

/// Says when to look for signals: about twenty times a second. Questions may be so quick that to ask the clock after
/// each would be felt; so it is asked after as many as take less than a hundredth of that time.
class SignalTimes {
 public:
  bool has_come() {
    if (++seen_ < at_once_) return false;
    const auto now = Clock::now(), before = std::exchange(asked_, now);
    at_once_ = now - before < between / 200 ? std::min<std::size_t>(2 * at_once_, 16) : (at_once_ + 1) / 2;
    seen_ = 0;
    if (now < next_) return false;
    next_ = now + between;
    return true;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::microseconds between{50'000};

  Clock::time_point asked_ = Clock::now(), next_ = asked_ + between;
  std::size_t seen_ = 0, at_once_ = 1;
};

}  // namespace

Interruptible::Interruptible(int threads) {
  options_.threads = threads;
  options_.progress = [caller = std::this_thread::get_id(), times = SignalTimes()](std::size_t, std::size_t) mutable {
    if (std::this_thread::get_id() != caller || !times.has_come()) return;
    const nb::gil_scoped_acquire acquired;
    if (PyErr_CheckSignals() != 0) throw Interrupted();
  };
}

}  // namespace toccata::python
