#include "run_ranks.hpp"

#include <fmt/format.h>
#include <mpi.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <string_view>
#include <thread>

namespace toccata {

namespace {

constexpr int trouble = 2;

int this_rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

}  // namespace

std::optional<int> end_by_words(CLI::App& app, int count, char** words) {
  try {
    app.parse(count, words);
    return std::nullopt;
  } catch (const CLI::ParseError& end) {
    if (this_rank() == 0) app.exit(end);
    return end.get_exit_code() == 0 ? 0 : trouble;
  }
}

void wait_idly() {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  for (int is_over = 0; MPI_Test(&request, &is_over, MPI_STATUS_IGNORE) == MPI_SUCCESS && is_over == 0;)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

int run_ranks(int count, char** words, const char* program, const std::function<int()>& work) {
  int provided = 0;
  MPI_Init_thread(&count, &words, MPI_THREAD_FUNNELED, &provided);
  int code = trouble;
  try {
    code = work();
  } catch (const std::exception& error) {
    // Mostly all ranks have the same to say. Who ends first ends all of them, so the others let rank 0 speak.
    const int rank = this_rank();
    if (rank != 0) std::this_thread::sleep_for(std::chrono::seconds(2));
    const std::string_view words = error.what();
    const bool is_told_by_all = rank == 0 || words.starts_with("rank ");
    fmt::print(stderr, "{}: {}{}\n", program, is_told_by_all ? "" : fmt::format("rank {}: ", rank), words);
    MPI_Abort(MPI_COMM_WORLD, trouble);
  }
  // mpirun ends those that are late once one has ended with another code than 0.
  std::fflush(stdout);
  const int own_code = this_rank() == 0 ? code : 0;
  MPI_Finalize();
  return own_code;
}

}  // namespace toccata
