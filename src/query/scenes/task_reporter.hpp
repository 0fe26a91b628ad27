#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>

#include "toccata/core/parallel.hpp"

namespace toccata {

/// Counts finished steps for the caller, from many threads. Once its report throws, what is left need not be done.
class TaskReporter {
 public:
  TaskReporter(const Progress& progress, std::size_t total) : progress_(progress), total_(total) {}

  [[nodiscard]] bool cancelled() const { return cancelled_; }

  void finished_one() {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    if (cancelled_) return;
    try {
      progress_(++done_, total_);
    } catch (...) {
      cancelled_ = true;
      throw;
    }
  }

 private:
  const Progress& progress_;
  std::mutex mutex_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::atomic<bool> cancelled_ = false;
};

}  // namespace toccata
