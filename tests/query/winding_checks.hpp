#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/winding.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/query/signed_distance.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata::test {

/// Where points lie to a mesh.
inline const std::vector<std::string>& point_families() {
  static const std::vector<std::string> all{"anywhere", "on faces", "near faces", "near edges", "corners", "far"};
  return all;
}

struct PointCase {
  TriangleMesh mesh;
  Pose pose;
  Vec3 point;
};

inline std::vector<Triangle> world_triangles(const TriangleMesh& mesh, const Pose& pose) {
  std::vector<Triangle> triangles;
  for (const auto& corner : mesh.triangles()) {
    Triangle t;
    for (int i = 0; i < 3; ++i) t[i] = transform(pose, mesh.vertices()[corner[static_cast<std::size_t>(i)]]);
    triangles.push_back(t);
  }
  return triangles;
}

/// A point of the family near one of the triangles; `size` is that of the mesh.
inline Vec3 some_point_at(const std::string& family, const Triangle& t, double size, Random& random) {
  const double s = random.unit(), r = random.unit() * (1 - s);
  const Vec3 on_face = t[0] + s * (t[1] - t[0]) + r * (t[2] - t[0]);
  const Vec3 on_edge = t[0] + 0.25 * static_cast<double>(random.below(5)) * (t[1] - t[0]);
  const double near = size * std::exp2(random.between(-40, 0));
  if (family == "anywhere") return on_face + random_vector(random, size);
  if (family == "on faces") return on_face;
  if (family == "near faces") return on_face + random_vector(random, near);
  if (family == "near edges") return on_edge + random_vector(random, near);
  if (family == "corners") return t[static_cast<int>(random.below(3))];
  return on_face + random_vector(random, size * std::exp2(random.between(1, 30)));
}

inline double size_of(const TriangleMesh& mesh, const Pose& pose) {
  double size = 1e-300;
  for (const Vec3& p : mesh.vertices()) size = std::max(size, std::fabs((transform(pose, p) - pose.offset).x));
  return size;
}

inline PointCase point_case(const std::string& family, Random& random) {
  const auto triangles = static_cast<Index>(random.below(4) == 0 ? 150 : 20);
  PointCase c{random_soup(random, triangles, 0.4, random.below(2) == 0 ? 8 : 0), {}, {}};
  if (random.below(4) != 0) c.pose = random_poses(pose_families()[random.below(pose_families().size())], random).pose_a;
  const std::vector<Triangle> world = world_triangles(c.mesh, c.pose);
  c.point = some_point_at(family, world[random.below(world.size())], size_of(c.mesh, c.pose), random);
  return c;
}

/// What is wrong with the answer, or nothing.
inline std::string winding_fault(double exact, const WindingNumber& found, double tolerance) {
  if (!(found.lower <= found.value && found.value <= found.upper)) return "the value is not in its interval";
  if (!(found.lower <= exact + 1e-15) || !(found.upper >= exact - 1e-15))
    return fmt::format("{} is not in [{}, {}]", exact, found.lower, found.upper);
  const bool is_wide = found.upper - found.lower > 2.001 * tolerance + 1e-14;
  if (is_wide && found.status != Status::not_converged) return "the interval is wider than was asked for";
  return "";
}

inline double exact_winding(const PointCase& c) {
  return oracle::winding_number(c.point, world_triangles(c.mesh, c.pose));
}

}  // namespace toccata::test
