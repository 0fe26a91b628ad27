#include "toccata/partitions/measure.hpp"

#include <utility>

#include "partitions/partition_makers.hpp"

namespace toccata {
namespace {

template <class P>
std::vector<PartitionLevel> levels_of(const P& partition, std::size_t most_cells) {
  std::vector<PartitionLevel> levels;
  if constexpr (requires { partition.cells_at(Index{}); }) {
    const Index greatest = partition.greatest_depth();
    for (Index depth = 0; depth < greatest; ++depth) {
      std::vector<PartitionCell> cells = partition.cells_at(depth);
      if (cells.size() > most_cells) break;  // deeper ones have as many
      levels.push_back({depth, std::move(cells)});
    }
    levels.push_back({greatest, partition.cells()});
  } else {
    levels.push_back({0, partition.cells()});
  }
  return levels;
}

}  // namespace

std::vector<PartitionLevel> partition_levels(PartitionKind kind, const PartitionItems& items, std::size_t most_cells) {
  return with_maker(kind, items, [&](const auto& make) { return levels_of(make(), most_cells); });
}

}  // namespace toccata
