#pragma once

#include "toccata/partitions/kd_tree.hpp"
#include "toccata/partitions/measure.hpp"
#include "toccata/partitions/octree.hpp"
#include "toccata/partitions/r_tree.hpp"
#include "toccata/partitions/uniform_grid.hpp"

namespace toccata {

[[nodiscard]] inline RTree inserted_r_tree(const PartitionItems& items) {
  RTree tree;
  for (Index item = 0; item < items.size(); ++item) tree.insert(item, items.boxes()[item]);
  return tree;
}

/// Calls `use` with a function that builds a partition of this kind over the items.
template <class Use>
auto with_maker(PartitionKind kind, const PartitionItems& items, const Use& use) {
  switch (kind) {
    case PartitionKind::grid_2d:
      return use([&] { return UniformGrid<2>(items); });
    case PartitionKind::grid:
      return use([&] { return UniformGrid<3>(items); });
    case PartitionKind::octree:
      return use([&] { return Octree(items); });
    case PartitionKind::kd_tree:
      return use([&] { return KdTree(items); });
    case PartitionKind::r_tree:
      return use([&] { return RTree(items); });
    case PartitionKind::inserted_r_tree:
      break;
  }
  return use([&] { return inserted_r_tree(items); });
}

}  // namespace toccata
