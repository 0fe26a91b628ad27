// The main of a program that `mpirun` starts several times: every rank runs the same tests in the same order.
#include <gtest/gtest.h>
#include <mpi.h>

#include "distributed/before_mpi.hpp"

int main(int count, char** words) {
  toccata::test::try_before_mpi();
  int provided = 0;
  MPI_Init_thread(&count, &words, MPI_THREAD_FUNNELED, &provided);
  testing::InitGoogleTest(&count, words);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  // The others speak where something is wrong.
  if (rank != 0) GTEST_FLAG_SET(brief, true);
  const int failed = RUN_ALL_TESTS();
  MPI_Finalize();
  return failed;
}
