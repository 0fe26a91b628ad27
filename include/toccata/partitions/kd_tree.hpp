#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "toccata/partitions/partition.hpp"

namespace toccata {

struct KdTreeOptions {
  Index leaf_items = 8;    ///< a cell of no more is not split
  Index most_depth = 40;   ///< the cell of all items is at depth 0
  double most_copies = 8;  ///< the most copies of an item, on average: when there are so many, nothing more is split
};

/// The box of all items, cut in two by a plane across an axis where that is thought to pay, and these again (J. L.
/// Bentley, "Multidimensional binary search trees used for associative searching", 1975). The plane is that of 31
/// across each axis with the least cost by the surface-area heuristic: the items of either side by the area of its box,
/// and one more for the step (J. D. MacDonald, K. S. Booth, "Heuristics for ray tracing using space subdivision", 1990;
/// I. Wald, V. Havran, "On building fast kd-trees for ray tracing, and on doing that in O(N log N)", 2006); a cell is
/// left whole where none costs less than that. Space-centric: an item is in every leaf that it meets, a triangle
/// exactly.
class KdTree {
 public:
  explicit KdTree(const PartitionItems& items, const KdTreeOptions& options = {});
  KdTree(KdTree&&) noexcept;
  KdTree& operator=(KdTree&&) noexcept;
  ~KdTree();

  [[nodiscard]] std::vector<Index> candidates(const Aabb& box) const;
  [[nodiscard]] std::vector<IndexPair> candidate_pairs() const;
  [[nodiscard]] std::vector<PartitionCell> cells() const;
  /// The cells as if those at that depth had not been cut: they, and the leaves above.
  [[nodiscard]] std::vector<PartitionCell> cells_at(Index depth) const;
  [[nodiscard]] Index greatest_depth() const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  class State;
  std::unique_ptr<const State> state_;
};

}  // namespace toccata
