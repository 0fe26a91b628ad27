#include <mpi.h>

#include "distributed/before_mpi.hpp"
#include "distributed/twin_worlds.hpp"

namespace toccata::test {
namespace {

std::string& words_before_mpi() {
  static std::string words;
  return words;
}

}  // namespace

MpiCommunicator all_ranks() { return {MPI_Comm_c2f(MPI_COMM_WORLD)}; }
MpiCommunicator no_ranks() { return {MPI_Comm_c2f(MPI_COMM_NULL)}; }

Ranks& our_ranks() {
  static Ranks* ranks = new Ranks(all_ranks().fortran_handle, 120);  // ends after MPI does
  return *ranks;
}

void try_before_mpi() {
  words_before_mpi() = message_of([] { DistributedWorld world(MpiCommunicator{}); });
}

const std::string& told_before_mpi() { return words_before_mpi(); }

}  // namespace toccata::test
