#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace toccata::test {

/// What a run of the `toccata` command left behind. `exit_code` is 128 + n when signal n ended it.
struct CommandResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs the built command with these words, in `folder`, with a file as its standard input or with this program's.
CommandResult run_command(const std::vector<std::string>& words, const std::filesystem::path& folder = ".",
                          const std::filesystem::path& input = {});

/// Runs it with a terminal for its standard error, until `awaited` is seen there or it ends; then it is killed. Gives
/// what was seen.
[[nodiscard]] std::string seen_on_terminal(const std::vector<std::string>& words, const std::string& awaited);

/// The program that `run_command` runs.
[[nodiscard]] std::string command_file();

/// All that is in a file; nothing where there is none.
[[nodiscard]] std::string text_of(const std::filesystem::path& file);

}  // namespace toccata::test
