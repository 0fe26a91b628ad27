#pragma once

#include <array>
#include <set>

#include "toccata/core/random.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/relation.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::test {

/// A solid of unit cubes on the integer grid, of which relations can be counted: a truth that shares nothing with the
/// queries nor with the rational oracle. Voxel (i, j, k) is the closed cube from that point to (i + 1, j + 1, k + 1).
using Voxel = std::array<int, 3>;
using VoxelSolid = std::set<Voxel>;

/// A unit square of the grid: `lower` is its least corner, `axis` the direction of its normal.
struct GridFace {
  Voxel lower{};
  int axis = 0;
  friend auto operator<=>(const GridFace&, const GridFace&) = default;
};
using GridSheet = std::set<GridFace>;

/// 1 to `count` voxels with coordinates in [0, size).
VoxelSolid random_voxels(Random& random, int count, int size);
GridSheet random_sheet(Random& random, int count, int size);

enum class Skin {
  outer,      ///< only the faces between a voxel and none
  every,      ///< all six faces of every voxel: those inside are there twice
  inside_out  ///< as outer, every triangle turned round
};

/// Each square is cut into two triangles along a diagonal that `random` chooses.
TriangleMesh mesh_of(const VoxelSolid& solid, Skin skin, Random& random);
TriangleMesh mesh_of(const GridSheet& sheet, Random& random);

/// The relation of the two solids; that of a sheet and a solid whose mesh has the outer skin.
Relation true_relation(const VoxelSolid& a, const VoxelSolid& b);
Relation true_relation(const GridSheet& a, const VoxelSolid& b);

/// A pose of small integers, not singular, under which every world vertex of the grid is exact: both meshes under it
/// lie as they do without it.
Pose random_integer_pose(Random& random);

}  // namespace toccata::test
