// Overlap volumes of meshes against exact ones: boxes by their edges, solids of voxels by counting, others as sums of
// signed tetrahedra that are cut in rational arithmetic. None may lie outside its bracket.
#include <cmath>
#include <span>

#include "oracle/common_volume.hpp"
#include "query/winding_checks.hpp"
#include "support/case_seeds.hpp"
#include "support/relation_cases.hpp"
#include "support/voxel_solids.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::test {
namespace {

using oracle::Rational;

struct VolumeCase {
  TriangleMesh a;
  TriangleMesh b;
  PairQuery query;
  Rational truth;
  double width = 1e-12;  ///< as part of `upper` and, where that is next to nothing, of the boxes
};

Vec3 vector_in(Random& random, double reach) {
  return {random.between(-reach, reach), random.between(-reach, reach), random.between(-reach, reach)};
}

Rational common_length(double lower_a, double upper_a, double lower_b, double upper_b) {
  const Rational lower = oracle::exact(std::max(lower_a, lower_b)), upper = oracle::exact(std::min(upper_a, upper_b));
  return lower < upper ? upper - lower : Rational(0);
}

/// A few coordinates, so that faces lie in one plane.
double coordinate(Random& random) { return 0.1 * static_cast<double>(random.below(8)); }

VolumeCase boxes(Random& random) {
  std::array<Vec3, 4> ends;
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t box = 0; box < 2; ++box) {
      const double p = coordinate(random);
      double q = coordinate(random);
      while (q == p) q = coordinate(random);
      ends[2 * box][axis] = std::min(p, q);
      ends[2 * box + 1][axis] = std::max(p, q);
    }
  Rational truth = 1;
  for (int axis = 0; axis < 3; ++axis)
    truth *= common_length(ends[0][axis], ends[1][axis], ends[2][axis], ends[3][axis]);
  return {other_box_mesh(ends[0], ends[1]), other_box_mesh(ends[2], ends[3]), {}, truth};
}

VolumeCase voxels(Random& random, Skin skin) {
  const VoxelSolid a = random_voxels(random, 12, 3), b = random_voxels(random, 12, 3);
  long long common = 0;
  for (const Voxel& voxel : a) common += b.contains(voxel) ? 1 : 0;
  const Pose pose = random_integer_pose(random);
  const Mat3& m = pose.linear;
  const double stretch = std::abs(dot(m[0], cross(m[1], m[2])));
  return {mesh_of(a, skin, random),
          mesh_of(b, Skin::outer, random),
          {.pose_a = pose, .pose_b = pose},
          Rational(common) * oracle::exact(stretch),
          1};
}

TriangleMesh random_tetrahedron(Random& random) {
  for (;;) {
    const Vec3 p = vector_in(random, 1), q = vector_in(random, 1), r = vector_in(random, 1), s = vector_in(random, 1);
    if (dot(cross(q - p, r - p), s - p) < -0.05) return tetrahedron_mesh(p, q, r, s);
  }
}

Vec3 unit_vector(Random& random) {
  for (;;) {
    const Vec3 v = vector_in(random, 1);
    if (const double length = std::sqrt(dot(v, v)); length > 0.1) return (1 / length) * v;
  }
}

TriangleMesh small_solid(Random& random) {
  switch (random.below(4)) {
    case 0:
      return l_mesh();
    case 1:
      return box_mesh({random.between(0.2, 1), random.between(0.2, 1), random.between(0.2, 1)});
    case 2:
      return prism_mesh(random.between(0.3, 1), random.between(0.3, 2), static_cast<int>(3 + random.below(4)));
    default:
      return random_tetrahedron(random);
  }
}

VolumeCase with_exact_volume(TriangleMesh a, TriangleMesh b, const PairQuery& query) {
  const Rational truth = oracle::common_volume(world_triangles(a, query.pose_a), world_triangles(b, query.pose_b));
  return {std::move(a), std::move(b), query, abs(truth)};
}

VolumeCase solids(Random& random, double from_origin) {
  const Vec3 origin = vector_in(random, from_origin);
  PairQuery query;
  if (random.below(3) != 0) query.pose_a.linear = rotation_about(unit_vector(random), random.between(0, 360));
  if (random.below(3) != 0) query.pose_b.linear = rotation_about(unit_vector(random), random.between(0, 360));
  query.pose_a.offset = origin;
  query.pose_b.offset = origin + random.between(0, 1.2) * unit_vector(random);
  VolumeCase made = with_exact_volume(small_solid(random), small_solid(random), query);
  made.width = 1e-12 * std::max(1.0, from_origin);
  return made;
}

VolumeCase volume_case(const std::string& family, Random& random) {
  if (family == "boxes") return boxes(random);
  if (family == "voxels") return voxels(random, Skin::outer);
  if (family == "inner faces") return voxels(random, random.below(2) == 0 ? Skin::every : Skin::inside_out);
  if (family == "tetrahedra") return with_exact_volume(random_tetrahedron(random), random_tetrahedron(random), {});
  return solids(random, family == "far" ? 1e5 : 0);
}

std::string fault_of_volume(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  const VolumeCase made = volume_case(family, random);
  const Model a(made.a), b(made.b);
  const OverlapVolume found = overlap_volume(a, b, made.query);
  if (!(oracle::exact(found.lower) <= made.truth)) return "lower is above the exact volume";
  if (!(made.truth <= oracle::exact(found.upper))) return "upper is below the exact volume";
  if (found.upper - found.lower > made.width * (found.upper + 1e-3)) return "the bracket is wide";
  if (found != overlap_volume(b, a, {.pose_a = made.query.pose_b, .pose_b = made.query.pose_a})) return "exchanged";
  return "";
}

SweepResult run_overlap_volumes(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) { return fault_of_volume(family, case_seed); });
}

const bool overlap_volumes_known = register_sweep({"overlap-volumes",
                                                   {"boxes", "voxels", "inner faces", "tetrahedra", "solids", "far"},
                                                   10'000,
                                                   20,
                                                   run_overlap_volumes,
                                                   500,
                                                   4});

}  // namespace
}  // namespace toccata::test
