// Distances of two meshes: CGAL's squared_distance of all pairs of triangles, in exact numbers.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "support/mesh_soups.hpp"
#include "support/sweep.hpp"
#include "toccata/query/distance.hpp"

namespace toccata::test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalTriangles = std::vector<Kernel::Triangle_3>;

/// The triangles in the world; none where a triangle has no area, which CGAL does not take.
std::optional<CgalTriangles> triangles_of(const TriangleMesh& mesh, const Pose& pose) {
  const auto vertices = mesh.vertices();
  const auto world = [&](Index i) {
    const Vec3 w = transform(pose, vertices[i]);
    return Kernel::Point_3(w.x, w.y, w.z);
  };
  CgalTriangles triangles;
  for (const auto& [i, j, k] : mesh.triangles()) {
    triangles.emplace_back(world(i), world(j), world(k));
    if (triangles.back().is_degenerate()) return std::nullopt;
  }
  return triangles;
}

Kernel::FT least_squared_distance(const CgalTriangles& a, const CgalTriangles& b) {
  std::optional<Kernel::FT> least;
  for (const Kernel::Triangle_3& s : a)
    for (const Kernel::Triangle_3& t : b) {
      const Kernel::FT square = CGAL::squared_distance(s, t);
      if (!least || square < *least) least = square;
    }
  return *least;
}

std::string fault(const Distance& d, const Kernel::FT& square) {
  const Kernel::FT lower(d.lower), upper(d.upper);
  if (lower * lower > square) return "lower is too large";
  if (upper * upper < square) return "upper is too small";
  if ((d.upper == 0) != (square == Kernel::FT(0))) return "0 exactly when they meet";
  return "";
}

SweepResult run(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  SweepResult result;
  Random random(seed);
  while (result.cases < cases) {
    PairQuery query = random_poses(family, random);
    query.pose_b.offset = query.pose_b.offset + std::exp2(random.between(-8, 4)) * Vec3{1, random.between(-1, 1), 0};
    const auto soup = [&] { return random_soup(random, static_cast<Index>(1 + random.below(10)), 0.5, 0); };
    const TriangleMesh a = soup(), b = soup();
    const auto triangles_a = triangles_of(a, query.pose_a), triangles_b = triangles_of(b, query.pose_b);
    if (!triangles_a || !triangles_b) continue;
    ++result.cases;
    const Distance found = distance(Model(a), Model(b), query);
    const std::string wrong = fault(found, least_squared_distance(*triangles_a, *triangles_b));
    if (!wrong.empty() && result.wrong++ == 0)
      result.first_failure = fmt::format("seed {} case {}: {}", seed, result.cases, wrong);
  }
  return result;
}

const bool known = register_sweep({"mesh-distances-cgal", pose_families(), 10'000, 30, run});

}  // namespace
}  // namespace toccata::test
