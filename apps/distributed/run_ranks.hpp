#pragma once

#include <functional>

namespace toccata {

/// What a program of many ranks returns: MPI is begun, `work` done and MPI ended. What a rank throws ends all ranks:
/// rank 0 says what is wrong, where it can, and all end with the code 2.
int run_ranks(int count, char** words, const char* program, const std::function<int()>& work);

}  // namespace toccata
