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

/// Whether a length may be "all", which is infinity.
enum class Longest { finite, infinite };

/// In what lengths are written.
struct LengthUnits {
  std::string_view world;     ///< as `Scene::unit`
  std::string_view number{};  ///< of a number alone; empty: the world's, as that of points that are written beside it
};

/// Where no points are written: a number alone is in the unit that --unit says the files have.
LengthUnits length_units(const Scene& scene, const InputArguments& input);

/// A length in world units, from a number, one with a unit behind it ("2mm"), or "all". Throws Error naming the option
/// and what was written for what is none, and for a unit where the scene has none.
double read_length(std::string_view option, std::string_view text, const LengthUnits& units,
                   Longest longest = Longest::infinite);

/// Throws Error as `read_length` does, and for objects that are not there.
ClearanceQuestion read_clearances(const CheckArguments& arguments, const Scene& scene);

}  // namespace toccata::command
