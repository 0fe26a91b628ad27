#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>

namespace toccata {

/// Reads the words of the command line, on all ranks. The code with which all end where these are wrong or ask for
/// help: rank 0 has told it then.
std::optional<int> end_by_words(CLI::App& app, int count, char** words);

/// Collective: until all ranks are here. Those that wait leave their cores to the others, which MPI's own calls do not.
void wait_idly();

/// What a program of many ranks returns: MPI is begun, `work` done and MPI ended. Its code is rank 0's. What a rank
/// throws ends all ranks: rank 0 says what is wrong, where it can, and all end with the code 2.
int run_ranks(int count, char** words, const char* program, const std::function<int()>& work);

}  // namespace toccata
