#pragma once

#include <string>
#include <vector>

namespace toccata::bench {

struct ProcessRun {
  int exit_code = -1;  ///< −1: could not be started, or did not end by itself
  double seconds = 0;
  double processor_seconds = 0;  ///< of all its threads, and of the kernel for it
  /// By the kernel's count, in which a process starts with the peak of the one that started it. So it is an upper
  /// bound: this program stays small.
  double peak_megabytes = 0;
};

/// Runs a program, looked for as a shell does, with its standard output thrown away.
ProcessRun run_program(const std::vector<std::string>& words);

}  // namespace toccata::bench
