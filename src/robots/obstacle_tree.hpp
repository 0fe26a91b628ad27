#pragma once

#include <span>
#include <vector>

#include "robots/turned_box.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/core/index.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

/// Boxes that do not move, eight at a time compared with a turned box. They are told by their numbers.
class ObstacleTree {
 public:
  ObstacleTree() = default;
  /// Boxes may be infinite, and empty ones are never seen.
  explicit ObstacleTree(std::span<const Aabb> boxes);

  /// All that are not certainly farther than this from what the box stands for, in any order, until `see` returns
  /// false.
  void visit_near(const TurnedBox& box, double distance, FunctionRef<bool(Index)> see) const;

 private:
  WideBvh tree_;
  std::vector<Index> in_tree_;  ///< the number of each of its items
  std::vector<Index> outside_;  ///< without end
};

}  // namespace toccata
