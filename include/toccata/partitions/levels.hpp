#pragma once

#include <cstddef>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/partitions/measure.hpp"
#include "toccata/partitions/partition.hpp"

namespace toccata {

/// A partition cut no deeper than this: the cells of the depth and the leaves above it, which together hold all items.
struct PartitionLevel {
  Index depth = 0;
  std::vector<PartitionCell> cells;
};

/// From the cell of all items down: those of at most `most_cells`, and the last one, of all cells as they are. A grid
/// has this one alone.
[[nodiscard]] std::vector<PartitionLevel> partition_levels(PartitionKind kind, const PartitionItems& items,
                                                           std::size_t most_cells = 4096);

}  // namespace toccata
