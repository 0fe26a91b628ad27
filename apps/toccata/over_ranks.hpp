#pragma once

namespace CLI {
class App;
}

// What runs over the ranks of mpirun is a program of its own beside this one, which so needs no MPI
// (docs/guide/distributed.md).
namespace toccata::command {

/// Adds --distributed.
void add_distributed(CLI::App& app);

/// Where the words have --distributed behind a subcommand that has it, its program over ranks runs in place of this one
/// with the others, and this does not return. Throws Error where that is not installed, telling how it is.
void run_over_ranks(const CLI::App& app, int argc, char** argv);

}  // namespace toccata::command
