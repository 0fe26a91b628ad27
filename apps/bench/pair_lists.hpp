#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "toccata/broad/broad_phase.hpp"

namespace toccata::bench {

/// How many of `a` are not in `b`; both are ascending.
[[nodiscard]] inline std::size_t count_without(const std::vector<IndexPair>& a, const std::vector<IndexPair>& b) {
  std::vector<IndexPair> rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  return rest.size();
}

}  // namespace toccata::bench
