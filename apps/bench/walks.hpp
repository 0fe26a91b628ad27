#pragma once

#include <span>
#include <string>
#include <vector>

#include "toccata/trees/builders.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata::bench {

/// Boxes, and the binary tree over them.
struct BoxBvh {
  explicit BoxBvh(std::vector<Aabb> of) : boxes(std::move(of)), tree(build_bvh(boxes)) {}

  std::vector<Aabb> boxes;
  Bvh<Aabb> tree;
};

/// The same question asked through the library's walkers and by loops written for it alone: which boxes overlap.
enum class Walk {
  two_trees,  ///< boxes of a and of b
  self,       ///< two boxes of a
  one_tree,   ///< boxes of a and the root box of b
};

enum class Method { generic, by_hand };

struct Walked {
  std::vector<ItemPair> found;  ///< in the order of discovery; of one tree the second is 0
  WalkCounts counts;
  friend bool operator==(const Walked&, const Walked&) = default;
};

[[nodiscard]] Walked walked(Walk walk, Method method, const BoxBvh& a, const BoxBvh& b);

}  // namespace toccata::bench
