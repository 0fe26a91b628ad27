#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "partitions/shared_cells.hpp"
#include "toccata/partitions/partition.hpp"

namespace toccata {

/// A tree of regions of space: the children of a node share its box among them. A leaf holds the items that meet its
/// box.
struct RegionTree {
  struct Node {
    Aabb box;
    Index first_child = 0;
    Index children = 0;  ///< 0: a leaf
    Index leaf = 0;      ///< of leaves: which list
    Index depth = 0;
  };
  std::vector<Node> nodes;  ///< children after their parent; none for no items
  ItemLists leaves;

  [[nodiscard]] std::vector<Index> candidates(const PartitionItems& items, const Aabb& box) const;
  [[nodiscard]] std::vector<IndexPair> candidate_pairs(const PartitionItems& items) const;
  /// The cells of nodes at the depth, with what is in the leaves below, and of leaves above it.
  [[nodiscard]] std::vector<PartitionCell> cells_at(Index depth) const;
  [[nodiscard]] std::vector<PartitionCell> cells() const { return cells_at(greatest_depth()); }
  [[nodiscard]] Index greatest_depth() const;
  [[nodiscard]] std::size_t bytes() const;
};

/// Whether a cut is undone after which one part holds all items and another some of them too.
enum class RegionCuts { must_part, may_trim };

struct RegionLimits {
  Index leaf_items;    ///< a node of no more is not split
  Index most_depth;    ///< the root is at 0
  double most_copies;  ///< of an item on average, over all leaves: when so many are made, nothing more is split
  RegionCuts cuts;
};

/// The boxes that a node is cut into; empty where it is better left whole.
using RegionSplit = std::function<std::vector<Aabb>(const Aabb& box, std::span<const Index> items)>;

/// Level by level from the box of all items, so that what `limits` leaves unsplit is the deepest.
[[nodiscard]] RegionTree build_regions(const PartitionItems& items, const Aabb& root, const RegionLimits& limits,
                                       const RegionSplit& split);

}  // namespace toccata
