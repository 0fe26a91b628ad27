// The proved bounds of subdivision against what many levels more do to the points.
#include <algorithm>
#include <cmath>
#include <string>

#include "query/subdivision/limit_bound.hpp"
#include "query/subdivision_cages.hpp"
#include "query/subdivision_descent.hpp"
#include "support/case_seeds.hpp"
#include "toccata/query/nearest.hpp"

namespace toccata::test {
namespace {

/// Levels that all faces are refined further, and those that one vertex is followed alone.
constexpr int levels_of_faces = 2;
constexpr int levels_of_vertex = 24;

PolygonMesh random_polygons(const std::string& family, bool triangles, Random& random) {
  if (family == "borders") return sheet_cage(1 + static_cast<Index>(random.below(3)), triangles);
  if (family == "valences") return bipyramid_cage(3 + static_cast<int>(random.below(28)));
  if (random.below(3) == 0) return bipyramid_cage(3 + static_cast<int>(random.below(10)));
  if (!triangles && random.below(3) == 0) return cube_cage();
  return torus_cage(3 + static_cast<Index>(random.below(3)), 3 + static_cast<Index>(random.below(3)), triangles);
}

/// Nearly flat, nearly in a line, or with points that coincide.
void make_slivers(PolygonMesh& mesh, Random& random) {
  const Vec3 scale{std::pow(10, random.between(-9, 0)), std::pow(10, random.between(-9, 0)), 1};
  for (Vec3& v : mesh.vertices) v = {v.x * scale.x, v.y * scale.y, v.z * scale.z};
  const Vec3 same = mesh.vertices[random.below(mesh.vertices.size())];
  for (Vec3& v : mesh.vertices)
    if (random.below(6) == 0) v = same;
}

SubdivisionCage random_cage(const std::string& family, Random& random) {
  const bool triangles = random.below(2) == 0;
  PolygonMesh mesh = shaken(random_polygons(family, triangles, random), random.below(2) == 0 ? 0.1 : 1, random);
  if (family == "slivers") make_slivers(mesh, random);
  if (family == "scales") {
    const double scale = std::pow(10, random.between(-8, 8));
    const Vec3 offset = std::pow(10, random.between(-2, 6)) * Vec3{1, -2, 0.5};
    for (Vec3& v : mesh.vertices) v = scale * (v + offset);
  }
  CageFeatures features;
  if (family == "creases") features = random_features(mesh, true, random);
  if (family == "creases-that-end") features = random_features(mesh, false, random);
  if (family == "borders") features = random_features(mesh, random.below(2) == 0, random);
  return {std::move(mesh), triangles ? SubdivisionScheme::loop : SubdivisionScheme::catmull_clark, std::move(features)};
}

/// A coordinate is off by no more than the rounding of its level, a vector by less than twice as much.
double off_by_rounding(const LevelMesh& mesh) { return 2 * mesh.rounding; }

bool is_within_bounds(const LevelMesh& mesh) {
  LimitBounds bounds(mesh);
  Descent descent(mesh);
  for (int level = 0; level < levels_of_faces; ++level) {
    descent.descend();
    const std::vector<double> moved = descent.moved(mesh.face_count());
    for (Index f = 0; f < mesh.face_count(); ++f)
      if (!(moved[f] - off_by_rounding(descent.mesh()) <= bounds.of(f).to_limit)) return false;
  }
  return true;
}

/// Follows one vertex, with the faces at it alone, nearly to the limit.
bool stays_within_bounds(LevelMesh mesh, Index vertex) {
  LimitBounds bounds(mesh);
  const Vec3 start = mesh.points[vertex];
  double allowed = std::numeric_limits<double>::infinity();
  for (const Index side : mesh.sides_at(vertex))
    allowed = std::min(allowed, bounds.of(mesh.face_of_side[side]).to_limit);
  for (int level = 0; level < levels_of_vertex; ++level) {
    std::vector<char> refined(mesh.face_count(), 0);
    for (const Index side : mesh.sides_at(vertex)) refined[mesh.face_of_side[side]] = 1;
    LevelMesh finer = subdivided(mesh, refined);
    vertex = mesh.point_of_vertex[vertex];
    mesh = std::move(finer);
    if (!(length(mesh.points[vertex] - start) - off_by_rounding(mesh) <= allowed)) return false;
  }
  return true;
}

/// Points of later levels against the mesh that stands for the limit, whose faces may be of several levels.
bool is_within_mesh_bound(const SubdivisionCage& cage, const LevelMesh& later, Random& random) {
  const Aabb box = fit_aabb(cage.polygons().vertices);
  const double size = length(box.upper - box.lower);
  const SubdividedMesh refined = refine(
      cage, {.tolerance = std::max(random.between(0.05, 1) * size, least_tolerance(cage)), .max_triangles = 400});
  if (refined.deepest_level > later.level) return true;
  const Model model(refined.mesh);
  for (int i = 0; i < 12; ++i) {
    const Vec3& p = later.points[random.below(later.points.size())];
    if (nearest_point(p, model)->lower - off_by_rounding(later) > refined.distance_to_limit) return false;
  }
  return true;
}

std::string fault_of_bounds(const std::string& family, std::uint64_t seed) {
  Random random(seed);
  const SubdivisionCage cage = random_cage(family, random);
  LevelMesh mesh = first_level(cage);
  if (mesh.face_count() < 40 && random.below(2) == 0) mesh = subdivided(mesh, std::vector<char>(mesh.face_count(), 1));
  if (!is_within_bounds(mesh)) return "a point that moves farther than the bound of its face";
  if (!stays_within_bounds(mesh, static_cast<Index>(random.below(mesh.points.size()))))
    return "a vertex whose limit is farther than the bound of its faces";
  for (int level = 0; level < 2; ++level) mesh = subdivided(mesh, std::vector<char>(mesh.face_count(), 1));
  if (!is_within_mesh_bound(cage, mesh, random)) return "a point that is farther from the mesh than its bound";
  return "";
}

SweepResult run_bounds(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) { return fault_of_bounds(family, case_seed); });
}

const bool bounds_known =
    register_sweep({"subdivision-bounds",
                    {"smooth", "valences", "creases", "creases-that-end", "borders", "slivers", "scales"},
                    10'000,
                    20,
                    run_bounds,
                    2'000,
                    4});

}  // namespace
}  // namespace toccata::test
