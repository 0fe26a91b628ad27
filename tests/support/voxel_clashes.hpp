#pragma once

#include <optional>

#include "support/voxel_solids.hpp"
#include "toccata/core/random.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::test {

/// A union of up to three boxes of voxels, with coordinates in [0, size), whose surface is a manifold: no two voxels
/// meet in an edge or a corner alone.
VoxelSolid random_manifold_voxels(Random& random, int size);

/// The same solid on a grid of half the step, moved by so many of its steps.
VoxelSolid on_half_grid(const VoxelSolid& solid, const Voxel& steps);

/// Whether one solid passes through the other, counted (docs/reference/check-report.md#volume-kind-and-point).
struct VoxelClash {
  bool has_curves = false;  ///< not of a part of one that lies wholly inside the other
  bool pierces = false;
  /// No two curves are so near that squares of either surface at them have corners in common.
  bool has_curves_apart = true;
  std::optional<PairAnswer::Piercing> piercing{};  ///< where it does, and the page leaves no doubt which
};

/// The faces of A lie in even planes of the grid, those of B in odd ones, so no two lie in one plane; both are
/// manifolds.
VoxelClash true_clash(const VoxelSolid& a, const VoxelSolid& b);

}  // namespace toccata::test
