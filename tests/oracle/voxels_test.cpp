// The rational oracle against relations that can be counted on the grid.
#include <gtest/gtest.h>

#include "oracle/meshes.hpp"
#include "support/voxel_clashes.hpp"
#include "support/voxel_solids.hpp"

namespace toccata::oracle {
namespace {

using test::GridSheet;
using test::Skin;
using test::VoxelSolid;

void expect_same(const Relation& answer, const toccata::Relation& truth, const std::string& where) {
  EXPECT_EQ(static_cast<int>(answer.kind), static_cast<int>(truth.kind)) << where;
  EXPECT_EQ(static_cast<int>(answer.containment), static_cast<int>(truth.containment)) << where;
}

static_assert(static_cast<int>(RelationKind::crossing) == static_cast<int>(toccata::RelationKind::crossing));
static_assert(static_cast<int>(Containment::equal) == static_cast<int>(toccata::Containment::equal));

TEST(OracleVoxels, SolidsLieAsTheirVoxelsDo) {
  const std::uint64_t seed = 21;
  Random random(seed);
  for (int round = 0; round < 5; ++round) {
    const VoxelSolid a = test::random_voxels(random, 3, 2);
    const VoxelSolid b = test::random_voxels(random, 3, 2);
    const Skin skin = round % 3 == 0 ? Skin::every : round % 3 == 1 ? Skin::outer : Skin::inside_out;
    const Pose pose = test::random_integer_pose(random);
    const auto set_a = solid_set(mesh_of(a, skin, random), pose);
    const Relation answer = relation(set_a, solid_set(mesh_of(b, Skin::outer, random), pose));
    expect_same(answer, test::true_relation(a, b), "seed 21 round " + std::to_string(round));
  }
}

TEST(OracleVoxels, SheetsLieAsTheirSquaresDo) {
  const std::uint64_t seed = 22;
  Random random(seed);
  for (int round = 0; round < 10; ++round) {
    const GridSheet a = test::random_sheet(random, 2, 3);
    const VoxelSolid b = test::random_voxels(random, 12, 3);
    const auto set_a = surface_set(mesh_of(a, random), {});
    const Relation answer = relation(set_a, solid_set(mesh_of(b, Skin::outer, random), {}));
    expect_same(answer, test::true_relation(a, b), "seed 22 round " + std::to_string(round));
  }
}

VoxelSolid block(const test::Voxel& from, const test::Voxel& to) {
  VoxelSolid solid;
  for (int x = from[0]; x < to[0]; ++x)
    for (int y = from[1]; y < to[1]; ++y)
      for (int z = from[2]; z < to[2]; ++z) solid.insert({x, y, z});
  return solid;
}

/// What one solid does to another that is moved by half a step along each axis.
test::VoxelClash clash_of(const VoxelSolid& a, const VoxelSolid& b) {
  return test::true_clash(test::on_half_grid(a, {}), test::on_half_grid(b, {1, 1, 1}));
}

TEST(OracleVoxels, WhatPassesThroughPierces) {
  using Piercing = PairAnswer::Piercing;
  const VoxelSolid plate = block({0, 0, 2}, {5, 5, 3}), rod = block({2, 2, 0}, {3, 3, 5}),
                   peg = block({2, 2, 2}, {3, 3, 5});
  EXPECT_TRUE(clash_of(plate, rod).pierces);
  EXPECT_EQ(clash_of(plate, rod).piercing, Piercing::b_through_a);
  EXPECT_EQ(clash_of(rod, plate).piercing, Piercing::a_through_b);
  EXPECT_FALSE(clash_of(plate, peg).pierces);
  EXPECT_TRUE(clash_of(plate, peg).has_curves);
  EXPECT_FALSE(clash_of(block({0, 0, 0}, {5, 5, 5}), block({2, 2, 2}, {3, 3, 3})).has_curves);
}

TEST(OracleVoxels, TwoFeetInAPlateProtrude) {
  VoxelSolid bench = block({0, 0, 3}, {8, 1, 4});
  bench.merge(block({0, 0, 1}, {1, 1, 3}));
  bench.merge(block({7, 0, 1}, {8, 1, 3}));
  const test::VoxelClash clash = clash_of(block({0, 0, 0}, {9, 3, 2}), bench);
  EXPECT_FALSE(clash.pierces);
  EXPECT_TRUE(clash.has_curves_apart);
}

}  // namespace
}  // namespace toccata::oracle
