#pragma once

#include <csignal>
#include <string>
#include <vector>

namespace toccata::command {

/// Writes the whole answer to standard output; throws Error when that fails (a full disk, a closed pipe).
void print_answer(const std::string& text);

/// Prints warnings to standard error, a line each.
void print_warnings(const std::vector<std::string>& warnings);

/// While it lives, Ctrl-C waits: files that are being written are finished first.
class UninterruptedWriting {
 public:
  UninterruptedWriting();
  ~UninterruptedWriting();
  UninterruptedWriting(const UninterruptedWriting&) = delete;
  UninterruptedWriting& operator=(const UninterruptedWriting&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace toccata::command
