#include "run_ranks.hpp"

#include <fmt/format.h>
#include <mpi.h>

#include <chrono>
#include <exception>
#include <thread>

namespace toccata {

int run_ranks(int count, char** words, const char* program, const std::function<int()>& work) {
  constexpr int trouble = 2;
  int provided = 0;
  MPI_Init_thread(&count, &words, MPI_THREAD_FUNNELED, &provided);
  int code = trouble;
  try {
    code = work();
  } catch (const std::exception& error) {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    // Mostly all ranks have the same to say. Who ends first ends all of them, so the others let rank 0 speak.
    if (rank != 0) std::this_thread::sleep_for(std::chrono::seconds(2));
    fmt::print(stderr, "{}: {}\n", program, error.what());
    MPI_Abort(MPI_COMM_WORLD, trouble);
  }
  MPI_Finalize();
  return code;
}

}  // namespace toccata
