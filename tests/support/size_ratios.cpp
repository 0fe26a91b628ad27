#include "support/size_ratios.hpp"

#include <cmath>

#include "support/mesh_soups.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata::test {
namespace {

Vec3 random_point_of(const Triangle& triangle, Random& random) {
  // On a corner, on an edge or within, in turn.
  double u = random.unit(), v = random.unit();
  if (random.below(3) == 0) u = 0;
  if (random.below(3) == 0) v = 0;
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  return triangle[0] + u * (triangle[1] - triangle[0]) + v * (triangle[2] - triangle[0]);
}

TriangleMesh small_mesh(double ratio, Random& random) {
  switch (random.below(3)) {
    case 0:
      return scaled_mesh(icosphere_mesh(0.5, static_cast<int>(random.below(3))), ratio);
    case 1:
      return scaled_mesh(box_mesh({0.5, 0.3, 0.2}), ratio);
    default:
      return scaled_mesh(random_soup(random, static_cast<Index>(1 + random.below(150)), 0.3, 0), ratio);
  }
}

}  // namespace

UnlikeSizes random_unlike_sizes(const std::string& family, double ratio, Random& random) {
  const double grid = random.below(2) == 0 ? 0 : 8;
  TriangleMesh large = random_soup(random, static_cast<Index>(1 + random.below(12)), 1.0, grid);
  TriangleMesh small = small_mesh(ratio, random);
  PairQuery query = random_poses(family, random);
  query.solid_a = query.solid_b = Solid::none;
  const auto corner = large.triangles()[random.below(large.triangle_count())];
  const Triangle place{{large.vertices()[corner[0]], large.vertices()[corner[1]], large.vertices()[corner[2]]}};
  const Vec3 vertex = small.vertices()[random.below(small.vertices().size())];
  const Vec3 off = random.below(2) == 0 ? Vec3{} : random_vector(random, ratio);
  query.pose_b.offset =
      transform(query.pose_a, random_point_of(place, random)) - transform({query.pose_b.linear, {}}, vertex + off);
  return {Model(std::move(large)), Model(std::move(small)), query, ratio};
}

UnlikeSizes random_unlike_sizes(const std::string& family, Random& random) {
  const double ratio = std::pow(10, random.between(-6, 0));
  return random_unlike_sizes(family, ratio, random);
}

}  // namespace toccata::test
