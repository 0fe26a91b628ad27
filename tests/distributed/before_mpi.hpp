#pragma once

#include <string>

#include "toccata/distributed.hpp"

namespace toccata::test {

/// Makes a DistributedWorld before MPI begins, and keeps what that says. Called by main.
void try_before_mpi();
[[nodiscard]] const std::string& told_before_mpi();

/// As what MPI_Comm_split leaves to a rank that is in no part.
[[nodiscard]] MpiCommunicator no_ranks();

}  // namespace toccata::test
