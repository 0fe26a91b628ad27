#pragma once

#include <array>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"

namespace toccata {

/// A node of a bounding-volume hierarchy. A leaf (count > 0) holds the items [first, first + count) of the tree's item
/// order; an inner node has its children at [first, first + child_count).
template <class Volume>
struct BvhNode {
  Volume volume;
  Index first = 0;
  Index count = 0;
  Index child_count = 0;

  [[nodiscard]] bool is_leaf() const { return count > 0; }
};

/// A hierarchy over items 0 … n − 1. Node 0 is the root; children come after their parent. A node's volume fits the
/// items below it, not its children's volumes; siblings may overlap. Empty (no nodes) for no items.
template <class Volume, int Arity = 2>
struct Bvh {
  static constexpr int arity = Arity;
  std::vector<BvhNode<Volume>> nodes;
  std::vector<Index> items;  ///< item numbers in leaf order
  double built_size = -1;    ///< what half_area of all nodes added up to when it was built; −1: not known
};

}  // namespace toccata
