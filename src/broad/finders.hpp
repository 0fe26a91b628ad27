#pragma once

#include "broad/pair_finder.hpp"

// One function per method of finding pairs (docs/design/broad-phase.md); each class is in the file of its name.
namespace toccata {

[[nodiscard]] std::unique_ptr<PairFinder> make_brute_force();
[[nodiscard]] std::unique_ptr<PairFinder> make_sort_and_sweep();
[[nodiscard]] std::unique_ptr<PairFinder> make_uniform_grid();
[[nodiscard]] std::unique_ptr<PairFinder> make_kd_tiles();
[[nodiscard]] std::unique_ptr<PairFinder> make_morton_tree();
[[nodiscard]] std::unique_ptr<PairFinder> make_packed_r_tree();
[[nodiscard]] std::unique_ptr<PairFinder> make_r_tree();
[[nodiscard]] std::unique_ptr<PairFinder> make_layers();
[[nodiscard]] std::unique_ptr<PairFinder> make_incremental_sweep();
/// Cells of `side` times the usual box, which has to be positive.
[[nodiscard]] std::unique_ptr<PairFinder> make_spatial_hash(double side);
[[nodiscard]] std::unique_ptr<PairFinder> make_hierarchical_hash();
[[nodiscard]] std::unique_ptr<PairFinder> make_interval_sweeps();
[[nodiscard]] std::unique_ptr<PairFinder> make_rectangle_sweeps();
[[nodiscard]] std::unique_ptr<PairFinder> make_dynamic_tree();
[[nodiscard]] std::unique_ptr<PairFinder> make_loose_octree();
[[nodiscard]] std::unique_ptr<PairFinder> make_automatic();

}  // namespace toccata
