#include "over_ranks.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "installed_program.hpp"
#include "toccata/core/error.hpp"

namespace toccata::command {
namespace {

constexpr std::string_view distributed_option = "--distributed";

std::string program_over_ranks(const std::string& subcommand) {
  const std::string name = fmt::format("toccata-{}-ranks", subcommand);
  if (const auto program = installed_program(name)) return *program;
  throw Error(fmt::format(
      "{0} --distributed runs {1}, which is not there. It takes an MPI (Debian: libopenmpi-dev, openmpi-bin), and in "
      "the folder of Toccata's sources: `cmake --preset release -DTOCCATA_WITH_MPI=ON` and "
      "`cmake --build build/release --target toccata_{0}_ranks`",
      subcommand, name));
}

}  // namespace

void add_distributed(CLI::App& app) {
  const std::string help =
      "over the ranks of mpirun, none of which has all: `mpirun -np 4 toccata … --distributed`; with --help, which "
      "options there are then (docs/guide/distributed.md)";
  app.add_flag(std::string(distributed_option), help);
}

void run_over_ranks(const CLI::App& app, int argc, char** argv) {
  char** const end = argv + argc;
  char** const word = std::find(argv, end, distributed_option);
  const auto runs_over_ranks = [&](const CLI::App* subcommand) {
    return subcommand->get_name() == argv[1] &&
           subcommand->get_option_no_throw(std::string(distributed_option)) != nullptr;
  };
  if (word == end || std::ranges::none_of(app.get_subcommands({}), runs_over_ranks)) return;
  std::string program = program_over_ranks(argv[1]);
  std::vector<char*> words{program.data()};
  std::copy(argv + 2, word, std::back_inserter(words));
  std::copy(word + 1, end, std::back_inserter(words));
  words.push_back(nullptr);
  execv(program.c_str(), words.data());
  throw Error(fmt::format("{} cannot be run: {}", program, std::generic_category().message(errno)));
}

}  // namespace toccata::command
