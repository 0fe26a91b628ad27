// The relation of two meshes against relations that can be counted on the grid.
#include <fmt/format.h>

#include <utility>

#include "support/sweep.hpp"
#include "support/voxel_solids.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::test {
namespace {

struct Case {
  TriangleMesh a;
  TriangleMesh b;
  PairQuery query;
  Relation truth;
};

Case solids(Random& random, int count, int size, Skin skin_a, Skin skin_b) {
  const VoxelSolid a = random_voxels(random, count, size);
  // Every third pair is made to contain one another.
  VoxelSolid b = random_voxels(random, count, size);
  if (random.below(3) == 0) b.insert(a.begin(), a.end());
  const Pose pose = random_integer_pose(random);
  return {
      mesh_of(a, skin_a, random), mesh_of(b, skin_b, random), {.pose_a = pose, .pose_b = pose}, true_relation(a, b)};
}

Case sheet_and_solid(Random& random) {
  const GridSheet a = random_sheet(random, 4, 4);
  VoxelSolid b = random_voxels(random, 40, 4);
  if (random.below(3) == 0)
    for (int x = -1; x < 4; ++x)
      for (int y = -1; y < 4; ++y)
        for (int z = -1; z < 3; ++z) b.insert({x, y, z});
  const Pose pose = random_integer_pose(random);
  return {mesh_of(a, random),
          mesh_of(b, Skin::outer, random),
          {.pose_a = pose, .pose_b = pose, .solid_a = Solid::none},
          true_relation(a, b)};
}

Case make_case(const std::string& family, Random& random) {
  if (family == "few") return solids(random, 4, 3, Skin::outer, Skin::outer);
  if (family == "many") return solids(random, 30, 4, Skin::outer, Skin::outer);
  if (family == "inner faces") return solids(random, 10, 3, Skin::every, Skin::every);
  if (family == "inside out") return solids(random, 10, 3, Skin::inside_out, Skin::every);
  return sheet_and_solid(random);
}

Relation other_way_round(Relation relation) {
  std::swap(relation.a_solid, relation.b_solid);
  if (relation.containment == Containment::a_in_b)
    relation.containment = Containment::b_in_a;
  else if (relation.containment == Containment::b_in_a)
    relation.containment = Containment::a_in_b;
  return relation;
}

bool is_right(const Case& c) {
  const Model a(c.a), b(c.b);
  const PairQuery swapped{c.query.pose_b, c.query.pose_a, c.query.solid_b, c.query.solid_a};
  return relation(a, b, c.query) == c.truth && relation(b, a, swapped) == other_way_round(c.truth) &&
         overlap(a, b, c.query) == (c.truth.kind != RelationKind::apart);
}

SweepResult run_voxel_solids(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  for (std::uint64_t i = 0; i < cases; ++i) {
    Random random(Random(seed).bits() + i);
    ++result.cases;
    if (is_right(make_case(family, random))) continue;
    ++result.wrong;
    if (result.first_failure.empty()) result.first_failure = fmt::format("family {} seed {} case {}", family, seed, i);
  }
  return result;
}

const bool voxel_solids_known =
    register_sweep({.name = "voxel-solids",
                    .families = {"few", "many", "inner faces", "inside out", "sheet and solid"},
                    .goal = 10000,
                    .slice = 20,
                    .run = run_voxel_solids,
                    .shard = 1000});

}  // namespace
}  // namespace toccata::test
