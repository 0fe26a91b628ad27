#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "toccata/partitions/partition.hpp"

namespace toccata {

/// Boxes in groups of 6 to 16, groups of these, and so on, each with the least box around it (A. Guttman, "R-trees: a
/// dynamic index structure for spatial searching", 1984). Object-centric: a box is in one group, and the boxes around
/// groups overlap. Made at once, by halving along the widest axis, or box by box: put where the area grows least, and
/// full groups split as the R*-tree does (N. Beckmann et al., 1990, without its reinsertion).
///
/// Boxes have numbers of the caller's choice; they are dense: memory is kept for all below the greatest. A box may have
/// infinite sides. Const functions may be called from many threads at once.
class RTree {
 public:
  RTree();
  /// Box i has the number i. Throws Error naming one that has NaN or lower > upper.
  explicit RTree(std::span<const Aabb> boxes);
  explicit RTree(const PartitionItems& items) : RTree(items.boxes()) {}
  RTree(const RTree& other);
  RTree(RTree&&) noexcept;
  RTree& operator=(RTree other) noexcept;
  ~RTree();

  // What throws Error has changed nothing.
  /// Throws Error when the number is there already, and where the box has NaN or lower > upper.
  void insert(Index number, const Aabb& box);
  /// Throws Error when there is no such number.
  void remove(Index number);
  /// Throws Error when there is no such number, and for a box as `insert` does.
  void move(Index number, const Aabb& box);

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] bool contains(Index number) const;
  /// Throws Error when there is no such number.
  [[nodiscard]] const Aabb& box(Index number) const;

  [[nodiscard]] std::vector<Index> candidates(const Aabb& box) const;
  [[nodiscard]] std::vector<IndexPair> candidate_pairs() const;
  /// The groups of boxes.
  [[nodiscard]] std::vector<PartitionCell> cells() const;
  /// The groups at that depth, with all boxes below; those of `cells` are at the greatest depth, and at all beyond.
  [[nodiscard]] std::vector<PartitionCell> cells_at(Index depth) const;
  /// 0 where there is one group or none.
  [[nodiscard]] Index greatest_depth() const;
  [[nodiscard]] std::size_t bytes() const;
  /// For tests: which of what should hold of groups and their boxes does not; empty when all is well.
  [[nodiscard]] std::string complaint() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace toccata
