#include "toccata/core/parallel.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace toccata {
namespace {

/// Keeps the exception of the least index, so that which one is reported does not depend on timing.
class FirstFailure {
 public:
  void keep(std::size_t index) {
    const std::lock_guard lock(mutex_);
    if (!failure_ || index < index_) {
      failure_ = std::current_exception();
      index_ = index;
    }
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::size_t index_ = 0;
};

}  // namespace

int thread_count(int threads) {
  // TBB prints a warning when asked for more threads than the machine has.
  const int available = tbb::info::default_concurrency();
  return threads > 0 ? std::min(threads, available) : available;
}

#ifdef __SANITIZE_THREAD__

// The thread sanitizer cannot look into the library of TBB and takes every hand-over between its threads for a race. So
// it gets plain threads, each with every n-th index, however fast the others are: nothing but what the body itself does
// orders the calls of two threads.

void on_threads(int, FunctionRef<void()> work) { work(); }

namespace {

void share_out(std::size_t count, int threads, FunctionRef<void(std::size_t)> call) {
  const std::size_t wanted = threads > 0 ? static_cast<std::size_t>(threads) : 2;
  const std::size_t used = std::min({wanted, count, std::size_t{8}});
  const auto work = [&](std::size_t first) {
    for (std::size_t i = first; i < count; i += used) call(i);
  };
  std::vector<std::jthread> others;
  while (others.size() + 1 < used) others.emplace_back(work, others.size() + 1);
  work(0);
}

}  // namespace

#else

void on_threads(int threads, FunctionRef<void()> work) {
  // Threads that have just left one arena take up to 0.1 ms to come to another, so the one at hand is used where it has
  // the right size. Isolated: whoever waits in it must not begin with other work of the caller's in the meantime.
  const int count = thread_count(threads);
  if (count == tbb::this_task_arena::max_concurrency())
    tbb::this_task_arena::isolate(work);
  else
    tbb::task_arena(count).execute(work);
}

namespace {

void share_out(std::size_t count, int threads, FunctionRef<void(std::size_t)> call) {
  const auto call_each = [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) call(i);
  };
  on_threads(threads, [&] { tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), call_each); });
}

}  // namespace

#endif

void parallel_for(std::size_t count, int threads, FunctionRef<void(std::size_t)> body) {
  if (threads == 1 || count < 2) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  FirstFailure failure;
  share_out(count, threads, [&](std::size_t i) {
    try {
      body(i);
    } catch (...) {
      failure.keep(i);
    }
  });
  failure.rethrow();
}

}  // namespace toccata
