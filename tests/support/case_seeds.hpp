#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "support/sweep.hpp"

namespace toccata::test {

/// Tells what is wrong with the case of a seed; empty where nothing is.
using FaultOfCase = std::function<std::string(std::uint64_t case_seed)>;

/// As many cases of the family as asked, each of a seed of its own, which the first failure names.
SweepResult run_cases(const std::string& family, std::uint64_t seed, std::uint64_t cases,
                      const FaultOfCase& fault_of_case);

/// The same, each case at one of the SIMD levels of this machine, by its seed.
SweepResult run_cases_at_simd_levels(const std::string& family, std::uint64_t seed, std::uint64_t cases,
                                     const FaultOfCase& fault_of_case);

}  // namespace toccata::test
