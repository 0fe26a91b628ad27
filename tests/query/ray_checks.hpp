#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "oracle/rays.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata::test {

/// How rays are aimed at a mesh.
inline const std::vector<std::string>& ray_families() {
  static const std::vector<std::string> all{"anywhere", "at faces", "at edges", "at corners",    "along edges",
                                            "axes",     "far",      "long",     "ends on faces", "starts on faces"};
  return all;
}

struct RayCase {
  TriangleMesh mesh;
  Pose pose;
  Vec3 origin;
  Vec3 motion;
};

inline Triangle some_triangle(const RayCase& c, Random& random) {
  const auto& corner = c.mesh.triangles()[random.below(c.mesh.triangle_count())];
  Triangle triangle;
  for (int i = 0; i < 3; ++i) triangle[i] = transform(c.pose, c.mesh.vertices()[corner[static_cast<std::size_t>(i)]]);
  return triangle;
}

inline Vec3 some_point(Random& random, double size) {
  const double x = random.between(-size, size), y = random.between(-size, size);
  return {x, y, random.between(-size, size)};
}

/// A ray of the family at the mesh of the case; its size is about that of the mesh.
inline void aim(const std::string& family, Random& random, RayCase& c) {
  const Triangle t = some_triangle(c, random);
  double size = 0;
  for (const Vec3& p : c.mesh.vertices()) size = std::max(size, std::fabs((transform(c.pose, p) - c.pose.offset).x));
  const Vec3 u = t[1] - t[0], v = t[2] - t[0];
  const double s = random.unit(), r = random.unit() * (1 - s);
  const Vec3 inside = t[0] + s * u + r * v;
  Vec3 aim_at = inside;
  c.origin = inside + some_point(random, 2 * size + 1e-3);
  if (family == "anywhere") aim_at = inside + some_point(random, size);
  if (family == "at edges") aim_at = t[0] + 0.25 * static_cast<double>(random.below(5)) * u;
  if (family == "at corners") aim_at = t[2];
  if (family == "along edges") c.origin = t[0] - 0.5 * static_cast<double>(random.below(4)) * u, aim_at = t[1];
  if (family == "far") c.origin = inside + 1e7 * (c.origin - inside);
  c.motion = 1.5 * (aim_at - c.origin);
  if (family == "axes") {
    c.origin = aim_at = t[1];
    c.motion = {};
    const int axis = static_cast<int>(random.below(3));
    c.motion[axis] = size + 1e-3;
    c.origin[axis] -= 0.5 * static_cast<double>(random.below(3)) * c.motion[axis];
  }
  if (family == "long") c.motion = 1e9 * c.motion;
  if (family == "ends on faces") c.motion = inside - c.origin;
  if (family == "starts on faces") c.origin = inside;
  if (c.motion == Vec3{}) c.motion = {1, 0, 0};
}

inline RayCase ray_case(const std::string& family, Random& random) {
  const double grid = random.below(2) == 0 ? 8 : 0;
  const std::string pose_family = pose_families()[random.below(pose_families().size())];
  RayCase c{random_soup(random, 40, 0.4, grid), {}, {}, {}};
  c.pose = random_poses(pose_family, random).pose_a;
  aim(family, random, c);
  return c;
}

struct ExactHit {
  oracle::Rational time;
  Index triangle;
};

/// The exact hits of every triangle.
inline std::vector<ExactHit> exact_hits(const RayCase& c) {
  std::vector<ExactHit> hits;
  for (Index i = 0; i < c.mesh.triangle_count(); ++i) {
    const auto& corner = c.mesh.triangles()[i];
    oracle::RationalTriangle world;
    for (std::size_t k = 0; k < 3; ++k)
      world.vertex[k] = oracle::exact(oracle::world_vertex(c.pose, c.mesh.vertices()[corner[k]]));
    const auto time = oracle::time_of_hit(oracle::exact(c.origin), oracle::exact(c.motion), world);
    if (time) hits.push_back({*time, i});
  }
  return hits;
}

/// What is wrong with the answer, or nothing.
inline std::string ray_fault(const RayCase& c, const std::optional<RayHit>& hit) {
  const std::vector<ExactHit> hits = exact_hits(c);
  if (hit.has_value() != !hits.empty()) return hit.has_value() ? "a hit where there is none" : "a hit is missed";
  if (!hit) return "";
  oracle::Rational first = hits[0].time;
  std::optional<oracle::Rational> of_named;
  for (const ExactHit& one : hits) {
    first = std::min(first, one.time);
    if (one.triangle == hit->element) of_named = one.time;
  }
  if (!of_named) return "the named triangle is not met";
  if (oracle::exact(hit->lower) > *of_named || oracle::exact(hit->upper) < *of_named) return "not in the interval";
  if (!(hit->upper - hit->lower <= 0x1p-41)) return "the interval is wide";
  // Either of two that are nearer to each other than the interval is wide may be named.
  if (first < oracle::exact(hit->lower)) return "not the first";
  return "";
}

}  // namespace toccata::test
