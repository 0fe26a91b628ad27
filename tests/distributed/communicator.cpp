#include "distributed/twin_worlds.hpp"

#include <mpi.h>

namespace toccata::test {

MpiCommunicator all_ranks() { return {MPI_Comm_c2f(MPI_COMM_WORLD)}; }

Ranks& our_ranks() {
  static Ranks* ranks = new Ranks(all_ranks().fortran_handle, 120);  // ends after MPI does
  return *ranks;
}

}  // namespace toccata::test
