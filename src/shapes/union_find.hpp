#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

#include "toccata/core/index.hpp"

namespace toccata {

/// Disjoint sets of 0 … n − 1; the leader of a set is its least member (R. E. Tarjan, "Efficiency of a good but not
/// linear set union algorithm", 1975, with path halving).
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

  Index leader(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void unite(Index i, Index j) {
    i = leader(i);
    j = leader(j);
    if (i != j) parent_[i < j ? j : i] = i < j ? i : j;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace toccata
