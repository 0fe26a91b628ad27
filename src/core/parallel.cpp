#include "toccata/core/parallel.hpp"

#include <algorithm>
#include <exception>
#include <mutex>

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

void on_threads(int threads, const std::function<void()>& work) {
  // Threads that have just left one arena take up to 0.1 ms to come to another, so the one at hand is used where it has
  // the right size. Isolated: whoever waits in it must not begin with other work of the caller's in the meantime.
  const int count = thread_count(threads);
  if (count == tbb::this_task_arena::max_concurrency())
    tbb::this_task_arena::isolate(work);
  else
    tbb::task_arena(count).execute(work);
}

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  if (threads == 1 || count < 2) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  FirstFailure failure;
  const auto run = [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      try {
        body(i);
      } catch (...) {
        failure.keep(i);
      }
    }
  };
  on_threads(threads, [&] { tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), run); });
  failure.rethrow();
}

}  // namespace toccata
