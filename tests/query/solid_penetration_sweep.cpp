#include <cmath>
#include <span>

#include "math/vec3_measures.hpp"
#include "support/case_seeds.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/relation.hpp"

// Depths of solid meshes: of convex ones against the depth of their hulls, of others against the exact relation after
// translations that are shorter than `lower`, and after `upper · direction`.
namespace toccata::test {
namespace {

constexpr double full_turn = 360;

Vec3 vector_in_cube(Random& random) { return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}; }

Vec3 random_unit(Random& random) {
  for (;;) {
    const Vec3 v = vector_in_cube(random);
    if (const double length = std::sqrt(dot(v, v)); length > 0.1) return (1 / length) * v;
  }
}

TriangleMesh convex_mesh(Random& random) {
  switch (random.below(4)) {
    case 0:
      return toccata::box_mesh({random.between(0.2, 1), random.between(0.2, 1), random.between(0.2, 1)});
    case 1:
      return toccata::tetrahedron_mesh(random.between(0.5, 1));
    case 2:
      return prism_mesh(random.between(0.3, 1), random.between(0.3, 2), static_cast<int>(3 + random.below(6)));
    default:
      return icosphere_mesh(1, static_cast<int>(random.below(2)));
  }
}

TriangleMesh any_mesh(Random& random) {
  const std::vector<Vec2> corner_piece = {{0, 0}, {1.5, 0}, {1.5, 0.5}, {0.5, 0.5}, {0.5, 1.5}, {0, 1.5}};
  switch (random.below(5)) {
    case 0:
      return convex_mesh(random);
    case 1:
      return extruded_mesh(corner_piece, random.between(0.25, 1));
    case 2:
      return torus_mesh({.tube_radius = random.between(0.1, 0.4), .around = 12, .sides = 6});
    case 3:
      return gear_mesh({.teeth = 6});
    default:
      return noise_sphere_mesh({.roughness = 0.5, .subdivisions = 1, .seed = random.bits()});
  }
}

/// Pairs far from the origin have fewer digits left.
PairQuery random_query(const std::string& family, Random& random) {
  const Vec3 origin = family == "far" ? 1e4 * vector_in_cube(random) : Vec3{};
  PairQuery query;
  query.pose_a = {rotation_about(random_unit(random), random.between(0, full_turn)), origin};
  query.pose_b = {rotation_about(random_unit(random), random.between(0, full_turn)),
                  origin + random.between(0.2, 1.8) * random_unit(random)};
  if (family == "sheared")
    for (int row = 0; row < 3; ++row)
      query.pose_b.linear[row] = query.pose_b.linear[row] + 0.3 * vector_in_cube(random);
  return query;
}

PairQuery moved(PairQuery query, const Vec3& by) {
  query.pose_b.offset = query.pose_b.offset + by;
  return query;
}

std::string fault_of_hulls(const TriangleMesh& a, const TriangleMesh& b, const PairQuery& query, const Penetration& p) {
  const ConvexHull hull_a{transform(query.pose_a, a.vertices())}, hull_b{transform(query.pose_b, b.vertices())};
  const Penetration truth = penetration(PosedPolytope(hull_a), PosedPolytope(hull_b));
  if (p.lower > truth.upper || p.upper < truth.lower) return "the bracket does not meet that of the hulls";
  if (truth.lower > 1e-3 && p.upper > (1 + 1e-8) * p.lower) return "the bracket is not narrow";
  return "";
}

std::string fault_of_translations(const Model& a, const Model& b, const PairQuery& query, const Penetration& p,
                                  Random& random) {
  if (p.lower > p.upper) return "the bracket is empty";
  // Convex solids are parted as they are posed, by a translation in exact arithmetic; one that is added to a pose
  // rounds each of their vertices anew.
  const bool is_of_hulls = p.upper <= (1 + 0x1p-40) * p.lower;
  const double rounded = is_of_hulls ? 0x1p-48 * (4 + sum_of_magnitudes(query.pose_b.offset)) : 0;
  if (relation(a, b, moved(query, (p.upper + rounded) * p.direction)).kind == RelationKind::overlapping)
    return "upper · direction does not part them";
  for (int i = 0; i < 4; ++i)
    if (p.lower > 1e-9 &&
        relation(a, b, moved(query, 0.9999 * p.lower * random_unit(random))).kind != RelationKind::overlapping)
      return "less than lower parts them";
  return "";
}

std::string fault_of_solid_penetration(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  const bool convex = family == "convex";
  const TriangleMesh mesh_a = convex ? convex_mesh(random) : any_mesh(random);
  const TriangleMesh mesh_b = convex ? convex_mesh(random) : any_mesh(random);
  const PairQuery query = random_query(family, random);
  const Model a(mesh_a), b(mesh_b);
  const Penetration p = penetration(a, b, query);
  if (flipped(p) != penetration(b, a, {.pose_a = query.pose_b, .pose_b = query.pose_a})) return "exchanged";
  const bool overlaps = relation(a, b, query).kind == RelationKind::overlapping;
  if (overlaps != (p.upper > 0)) return "a depth, and no overlap, or the other way round";
  if (!overlaps) return "";
  const std::string fault = convex ? fault_of_hulls(mesh_a, mesh_b, query, p) : "";
  return fault.empty() ? fault_of_translations(a, b, query, p, random) : fault;
}

SweepResult run_solid_penetration(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases,
                   [&](std::uint64_t case_seed) { return fault_of_solid_penetration(family, case_seed); });
}

const bool solid_penetration_known = register_sweep(
    {"mesh-penetrations", {"convex", "solids", "far", "sheared"}, 200, 2, run_solid_penetration, 100, 1});

}  // namespace
}  // namespace toccata::test
