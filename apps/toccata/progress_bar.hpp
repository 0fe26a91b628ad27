#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

#include "toccata/core/parallel.hpp"

namespace toccata::command {

/// Tells on standard error how far long work is. On a terminal a bar, ten times a second, not in the first half second,
/// and gone when it ends; elsewhere a line a minute, or as often as the environment says in TOCCATA_PROGRESS_SECONDS.
class ProgressBar {
 public:
  /// Throws Error where the environment says no such time.
  explicit ProgressBar(std::string label);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// To be handed to the work. Until it is called first, what is shown is for how long the work has been going on.
  [[nodiscard]] Progress callback();

 private:
  void keep_showing();
  void show();
  /// How fast it goes and how long it will take at that; empty where that cannot be told.
  [[nodiscard]] std::string time_left(double seconds) const;

  using Clock = std::chrono::steady_clock;
  std::string label_;
  bool terminal_;
  std::chrono::duration<double> line_pause_;  ///< where it is none
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();

  std::mutex mutex_;  ///< of what follows
  std::condition_variable over_;
  bool is_over_ = false;
  std::size_t done_ = 0, total_ = 0;

  std::thread shower_;
};

}  // namespace toccata::command
