#include "calls.hpp"

#include <chrono>
#include <thread>

namespace toccata::python {

Interruptible::Interruptible(int threads, bool quick) {
  using Clock = std::chrono::steady_clock;
  static constexpr auto between = std::chrono::milliseconds(50);
  options_.threads = threads;
  if (quick) return;
  options_.progress = [caller = std::this_thread::get_id(), next = Clock::now() + between](std::size_t,
                                                                                           std::size_t) mutable {
    if (std::this_thread::get_id() != caller || Clock::now() < next) return;
    next = Clock::now() + between;
    const nb::gil_scoped_acquire acquired;
    if (PyErr_CheckSignals() != 0) throw Interrupted();
  };
}

}  // namespace toccata::python
