#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/partitions/partition.hpp"

namespace toccata {

enum class PartitionKind { grid_2d, grid, octree, kd_tree, r_tree, inserted_r_tree };

inline constexpr std::array all_partition_kinds{PartitionKind::grid_2d, PartitionKind::grid,
                                                PartitionKind::octree,  PartitionKind::kd_tree,
                                                PartitionKind::r_tree,  PartitionKind::inserted_r_tree};

/// "grid-2d", "grid", "octree", "kd-tree", "r-tree" (packed at once), "inserted-r-tree" (item by item).
[[nodiscard]] std::string_view name_of(PartitionKind kind);

/// Whether it groups the items, so that its regions may overlap; else it cuts space, and items may be in many cells.
[[nodiscard]] bool is_object_centric(PartitionKind kind);

/// A partition over some items, measured. Times are of the caller's thread; counts depend on the items alone.
struct PartitionCost {
  PartitionKind kind = PartitionKind::grid;
  std::size_t cells = 0;      ///< that hold an item
  double items_per_cell = 0;  ///< on average
  std::size_t most_in_a_cell = 0;
  double copies_per_item = 0;   ///< object redundancy: how many cells an item is in, on average
  double cells_at_an_item = 0;  ///< space redundancy: in how many cells' boxes the middle of an item lies, on average
  std::size_t bytes = 0;
  double build_ns = 0;
  double candidates = 0;   ///< items that are asked themselves by a box question, on average
  double answers = 0;      ///< those of these that meet the box, on average
  double question_ns = 0;  ///< on average, with the decision of every candidate
  std::size_t candidate_pairs = 0;
  std::size_t pairs = 0;  ///< pairs of items that meet
  double pairs_ns = 0;    ///< all of them, with the decision of every candidate
};

struct PartitionCostOptions {
  std::size_t questions = 1000;  ///< questions about boxes around items, each twice as large as that of its item
  std::uint64_t seed = 1;        ///< which items
  Progress progress{};
};

/// Builds each kind over the items and asks all of them the same. Throws Error when two do not answer the same.
[[nodiscard]] std::vector<PartitionCost> measure_partitions(const PartitionItems& items,
                                                            const PartitionCostOptions& options = {});

/// A partition cut no deeper than this: the cells of the depth and the leaves above it, which together hold all items.
struct PartitionLevel {
  Index depth = 0;
  std::vector<PartitionCell> cells;
};

/// The levels from the cell of all items down: those of at most `most_cells`, and the last one, of all cells as they
/// are. A grid has this one alone.
[[nodiscard]] std::vector<PartitionLevel> partition_levels(PartitionKind kind, const PartitionItems& items,
                                                           std::size_t most_cells = 4096);

}  // namespace toccata
