#include "float_mesh.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace toccata::bench {

Vec3 as_floats(const Vec3& v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

TriangleMesh of_floats(const TriangleMesh& mesh) {
  std::vector<Vec3> vertices;
  for (const Vec3& v : mesh.vertices()) vertices.push_back(as_floats(v));
  return {std::move(vertices), {mesh.triangles().begin(), mesh.triangles().end()}};
}

Vec3 random_direction(Random& random) {
  const double z = random.between(-1, 1), turn = random.between(0, 2 * std::numbers::pi), s = std::sqrt(1 - z * z);
  return {s * std::cos(turn), s * std::sin(turn), z};
}

}  // namespace toccata::bench
