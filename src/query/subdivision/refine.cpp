#include <algorithm>
#include <array>
#include <utility>

#include "query/subdivision/adaptive_levels.hpp"
#include "query/subdivision/level_triangles.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

void check_refinement(const RefinementOptions& options) {
  if (!(options.tolerance > 0)) throw Error("the tolerance of a refinement must be positive");
  if (options.levels < 0 || options.levels > 30) throw Error("the levels of a refinement must be 0 … 30");
}

}  // namespace

SubdividedMesh refine(const SubdivisionCage& cage, const RefinementOptions& options) {
  check_refinement(options);
  const AdaptiveLevels levels = adaptive_levels(cage, options);
  LevelTriangles leaves(levels);
  std::vector<Vec3> points = std::move(leaves).points();
  std::vector<LimitTriangle> triangles = std::move(leaves).triangles();
  std::stable_sort(triangles.begin(), triangles.end(),
                   [](const LimitTriangle& a, const LimitTriangle& b) { return a.cage_face < b.cage_face; });

  std::vector<std::array<Index, 3>> corners;
  std::vector<Index> faces;
  std::vector<double> distances;
  for (const LimitTriangle& triangle : triangles) {
    corners.push_back(triangle.corners);
    faces.push_back(triangle.cage_face);
    distances.push_back(triangle.distance);
  }
  const double farthest = *std::max_element(distances.begin(), distances.end());
  return {.mesh = TriangleMesh(std::move(points), std::move(corners), std::move(faces)),
          .distance_to_limit = farthest,
          .triangle_distances = std::move(distances),
          .deepest_level = levels.meshes.back().level,
          .status = levels.are_complete && farthest <= options.tolerance ? Status::exact : Status::not_converged};
}

}  // namespace toccata
