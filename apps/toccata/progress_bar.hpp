#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "toccata/core/parallel.hpp"

namespace toccata::command {

/// A bar on standard error while long work runs: only where that is a terminal, at most ten times a second, and not in
/// the first half second. Gone when it ends.
class ProgressBar {
 public:
  explicit ProgressBar(std::string label);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// To be handed to the work; empty where no bar is shown.
  [[nodiscard]] Progress callback();

 private:
  void show(std::size_t done, std::size_t total);

  using Clock = std::chrono::steady_clock;
  std::string label_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point next_;
};

}  // namespace toccata::command
