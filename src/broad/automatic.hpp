#pragma once

#include <functional>
#include <memory>

#include "broad/pair_finder.hpp"

namespace toccata {

/// The means by which `auto` measures, and what it measures.
struct AutomaticMeans {
  std::function<double()> milliseconds;  ///< since some moment
  std::function<std::unique_ptr<PairFinder>(BroadPhaseMethod)> finder;
};

/// The means with the machine's clock and the finders of all methods: what `make_automatic()` measures.
[[nodiscard]] AutomaticMeans usual_means();
[[nodiscard]] std::unique_ptr<PairFinder> make_automatic(AutomaticMeans means);

}  // namespace toccata
