#pragma once

#include <span>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::command {

/// What is asked about clearances, in world units.
struct ClearanceQuestion {
  bool asked = false;
  double common = 0;
  std::vector<PairClearance> of_pairs;
};

/// A length is a number of world units, or one with a unit behind it: "2mm". Throws Error naming the option for what is
/// none, for a unit where the scene has none, and for objects that are not there.
ClearanceQuestion read_clearances(const CheckArguments& arguments, const Scene& scene);

}  // namespace toccata::command
