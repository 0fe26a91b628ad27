#pragma once

#include <array>
#include <csignal>
#include <string>
#include <vector>

namespace toccata::command {

/// Writes the whole answer to standard output; throws Error when that fails (a full disk, a closed pipe).
void print_answer(const std::string& text);

/// Prints warnings to standard error, a line each.
void print_warnings(const std::vector<std::string>& warnings);

/// While it lives, Ctrl-C and an end that is asked for from elsewhere (SIGTERM, SIGHUP) wait: files that are being
/// written are finished first, and what has been begun is put away. One at a time or one inside another, on one thread.
class UninterruptedWriting {
 public:
  UninterruptedWriting();
  ~UninterruptedWriting();
  UninterruptedWriting(const UninterruptedWriting&) = delete;
  UninterruptedWriting& operator=(const UninterruptedWriting&) = delete;

  /// Somebody waits for the end.
  [[nodiscard]] static bool is_interrupted();

 private:
  static constexpr std::array<int, 3> signals_{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, 3> before_{};
};

/// A file that is to be written, and the option that names it.
struct NamedOutput {
  std::string option;
  std::string path;  ///< empty: it was not asked for
};

/// Throws Error when two of them are one file, or one of them is a file that is read.
void require_distinct(const std::vector<NamedOutput>& outputs, const std::vector<std::string>& inputs);

}  // namespace toccata::command
