#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "toccata/partitions/partition.hpp"

namespace toccata {

struct OctreeOptions {
  Index leaf_items = 16;   ///< a cell of no more is not split
  Index most_depth = 16;   ///< the cell of all items is at depth 0
  double most_copies = 8;  ///< the most copies of an item, on average: when there are so many, nothing more is split
};

/// A cube around all items, cut into eight where it holds many, and these again (D. Meagher, "Geometric modeling using
/// octree encoding", 1982). Space-centric: an item is in every leaf that it meets, a triangle exactly. A cell is also
/// left whole where its eight parts would together hold more than 2.5 times its items, or one of them all and another
/// some: what lies around one point is never parted.
class Octree {
 public:
  explicit Octree(const PartitionItems& items, const OctreeOptions& options = {});
  Octree(Octree&&) noexcept;
  Octree& operator=(Octree&&) noexcept;
  ~Octree();

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
