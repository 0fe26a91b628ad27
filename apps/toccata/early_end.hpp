#pragma once

#include <array>
#include <csignal>
#include <string>

namespace toccata::command {

/// While it lives, long work can be ended early so that what is done is told: by Ctrl-C or SIGTERM, and at a time limit
/// in seconds since the program began. Asked to end a second time, the program ends at once.
class EarlyEnd {
 public:
  explicit EarlyEnd(double limit);
  ~EarlyEnd();
  EarlyEnd(const EarlyEnd&) = delete;
  EarlyEnd& operator=(const EarlyEnd&) = delete;

  /// May be called from any thread.
  [[nodiscard]] bool is_due() const;

 private:
  static constexpr std::array<int, 2> signals_{SIGINT, SIGTERM};
  std::array<struct sigaction, 2> before_{};
  double limit_;
};

/// Whether the last EarlyEnd was due because somebody asked for it, and not by its limit.
[[nodiscard]] bool was_interrupted();

}  // namespace toccata::command
