#include "generate/subdivided_sphere.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "generate/mesh_building.hpp"
#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

SubdividedSphere icosahedron() {
  const double golden = 0.5 * (1 + std::sqrt(5.0));
  SubdividedSphere sphere;
  for (int axis = 0; axis < 3; ++axis)
    for (const double s : {-1.0, 1.0})
      for (const double t : {-golden, golden}) {
        Vec3 v;
        v[(axis + 1) % 3] = s;
        v[(axis + 2) % 3] = t;
        sphere.directions.push_back(plain_unit_or_zero(v));
      }
  // Faces join three directions that are pairwise nearest; of each triple, the order that turns outward.
  const auto near = [&](Index a, Index b) { return dot(sphere.directions[a], sphere.directions[b]) > 0.4; };
  for (Index a = 0; a < 12; ++a)
    for (Index b = a + 1; b < 12; ++b)
      for (Index c = b + 1; c < 12; ++c) {
        if (!near(a, b) || !near(b, c) || !near(c, a)) continue;
        const auto& d = sphere.directions;
        const bool outward = dot(cross(d[b] - d[a], d[c] - d[a]), d[a]) > 0;
        sphere.triangles.push_back(outward ? std::array{a, b, c} : std::array{a, c, b});
      }
  return sphere;
}

SubdividedSphere cut_into_four(const SubdividedSphere& coarse) {
  SubdividedSphere fine{coarse.directions, {}};
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<Index>(fine.directions.size()));
    if (is_new) fine.directions.push_back(plain_unit_or_zero(coarse.directions[a] + coarse.directions[b]));
    return found->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return fine;
}

}  // namespace

SubdividedSphere subdivided_sphere(int times) {
  require_range("the number of subdivisions", times, 0, 8);
  SubdividedSphere sphere = icosahedron();
  for (int i = 0; i < times; ++i) sphere = cut_into_four(sphere);
  return sphere;
}

}  // namespace toccata
