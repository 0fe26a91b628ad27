#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "arguments.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::command {

/// What is asked about clearances, in world units.
struct ClearanceQuestion {
  std::optional<double> common;  ///< there, and 0, also where lengths are asked for some pairs alone
  std::vector<PairClearance> of_pairs;
};

/// Throws Error where touching is to be ignored and a clearance is asked for.
void require_touching_counts(const CheckArguments& arguments);

/// Whether a length may be "all", which is infinity.
enum class Longest { finite, infinite };

/// A length in world units, from a number of these, one with a unit behind it ("2mm"), or "all". Throws Error naming
/// the option and what was written for what is none, and for a unit where the scene has none.
double read_length(std::string_view option, std::string_view text, const Scene& scene,
                   Longest longest = Longest::infinite);

/// Throws Error as `read_length` does, and for objects that are not there.
ClearanceQuestion read_clearances(const CheckArguments& arguments, const Scene& scene);

}  // namespace toccata::command
