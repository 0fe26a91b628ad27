#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "environment.hpp"

namespace toccata::command {

/// Runs another program, with nothing to read, and waits for it. What it says goes to `out` and `err` in the folder,
/// and so do its temporary files. It is in a group of its own with what it begins, and ends when this program does,
/// even where that is killed. Gives its status as `waitpid` tells it, or none where it took longer than `patience`, or
/// somebody wanted an end of this (UninterruptedWriting): then it was ended. Throws Error where it cannot be run.
[[nodiscard]] std::optional<int> run_program(std::vector<std::string> words, const std::filesystem::path& folder,
                                             Seconds patience);

}  // namespace toccata::command
