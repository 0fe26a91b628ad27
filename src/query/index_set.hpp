#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "toccata/core/index.hpp"

namespace toccata {

/// A set of numbers below a bound, for many additions of the same ones.
class IndexSet {
 public:
  explicit IndexSet(Index bound) : has_(bound) {}

  void add(Index number) {
    if (has_[number]) return;
    has_[number] = true;
    members_.push_back(number);
  }

  [[nodiscard]] std::vector<Index> ascending() && {
    std::sort(members_.begin(), members_.end());
    return std::move(members_);
  }

 private:
  std::vector<bool> has_;
  std::vector<Index> members_;
};

}  // namespace toccata
