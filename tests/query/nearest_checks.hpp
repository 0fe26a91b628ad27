#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "oracle/convex.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/nearest.hpp"

namespace toccata::test {

/// Where points lie that are asked about.
inline const std::vector<std::string>& nearest_families() {
  static const std::vector<std::string> all{"anywhere", "over faces", "over edges", "on faces",
                                            "on edges", "on corners", "hair off",   "far"};
  return all;
}

struct NearestCase {
  TriangleMesh mesh;
  Pose pose;
  Vec3 point;
  double size = 0;  ///< of the posed mesh, about
};

inline Triangle world_triangle(const NearestCase& c, Index number) {
  const auto& corner = c.mesh.triangles()[number];
  Triangle triangle;
  for (int i = 0; i < 3; ++i) triangle[i] = transform(c.pose, c.mesh.vertices()[corner[static_cast<std::size_t>(i)]]);
  return triangle;
}

inline Vec3 in_cube(Random& random, double size) {
  const double x = random.between(-size, size), y = random.between(-size, size);
  return {x, y, random.between(-size, size)};
}

inline Vec3 point_near(const std::string& family, Random& random, const NearestCase& c) {
  const Triangle t = world_triangle(c, static_cast<Index>(random.below(c.mesh.triangle_count())));
  const Vec3 u = t[1] - t[0], v = t[2] - t[0];
  const double s = random.unit(), r = random.unit() * (1 - s);
  const Vec3 inside = t[0] + s * u + r * v, on_edge = t[0] + 0.25 * static_cast<double>(random.below(5)) * u;
  if (family == "on faces") return inside;
  if (family == "on edges") return on_edge;
  if (family == "on corners") return t[2];
  const double gap = c.size * std::exp2(random.between(-10, 0));
  if (family == "over faces") return inside + (random.below(2) == 0 ? gap : -gap) * cross(u, v);
  if (family == "over edges") return on_edge + in_cube(random, gap);
  if (family == "hair off") return inside + in_cube(random, c.size * std::exp2(random.between(-60, -20)));
  if (family == "far") return inside + in_cube(random, c.size * std::exp2(random.between(3, 60)));
  return inside + in_cube(random, 2 * c.size);
}

inline NearestCase nearest_case(const std::string& family, Random& random) {
  const double grid = random.below(2) == 0 ? 8 : 0;
  const std::string pose_family = pose_families()[random.below(pose_families().size())];
  NearestCase c{random_soup(random, 40, 0.4, grid), {}, {}};
  c.pose = random_poses(pose_family, random).pose_a;
  for (const Vec3& p : c.mesh.vertices()) {
    const Vec3 from = transform(c.pose, p) - c.pose.offset;
    c.size = std::max({c.size, std::fabs(from.x), std::fabs(from.y), std::fabs(from.z)});
  }
  c.point = point_near(family, random, c);
  if (grid != 0 && random.below(2) == 0)
    for (int axis = 0; axis < 3; ++axis) c.point[axis] = std::round(c.point[axis] * 16) / 16;  // many are equally near
  return c;
}

/// Every triangle asked by itself, in order.
inline std::vector<SurfacePoint> each_triangle(const NearestCase& c) {
  std::vector<SurfacePoint> all;
  for (Index i = 0; i < c.mesh.triangle_count(); ++i) {
    const Distance d = distance(PosedPolytope(Point{c.point}), PosedPolytope(world_triangle(c, i)));
    all.push_back({d.lower, d.upper, d.on_b, i, c.mesh.face_of(i), d.status});
  }
  std::sort(all.begin(), all.end(), [](const SurfacePoint& a, const SurfacePoint& b) {
    return std::tie(a.upper, a.element) < std::tie(b.upper, b.element);
  });
  return all;
}

inline bool is_narrow(const SurfacePoint& p) {
  return p.upper - p.lower <= 1e-12 * p.upper || std::nextafter(p.lower, p.upper) == p.upper;
}

/// What is wrong with the k nearest, beside those of every triangle by itself; nothing where all is right.
inline std::string fault_of_nearest(const NearestCase& c, std::span<const SurfacePoint> found, std::size_t k) {
  const std::vector<SurfacePoint> all = each_triangle(c);
  if (found.size() != std::min(k, all.size())) return "the number";
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].upper != all[i].upper || found[i].element != all[i].element) return fmt::format("the order at {}", i);
    if (!(found[i].point == all[i].point) || found[i].face != all[i].face) return fmt::format("the point {}", i);
    if (!is_narrow(found[i])) return fmt::format("the width of {}", i);
  }
  return "";
}

/// What is wrong with the nearest one in rational arithmetic.
inline std::string fault_by_oracle(const NearestCase& c, const SurfacePoint& found) {
  const auto point = oracle::point_set(c.point);
  const auto of = [&](Index i) {
    const Triangle t = world_triangle(c, i);
    return oracle::nearest_points(point, oracle::triangle_set(t[0], t[1], t[2]));
  };
  const oracle::NearestPoints named = of(found.element);
  const oracle::Rational lower = oracle::exact(found.lower), upper = oracle::exact(found.upper);
  for (Index i = 0; i < c.mesh.triangle_count(); ++i)
    if (of(i).squared_distance < lower * lower) return fmt::format("triangle {} is nearer", i);
  if (named.squared_distance < lower * lower || named.squared_distance > upper * upper) return "the interval";
  if ((found.upper == 0) != (named.squared_distance == 0)) return "zero";
  const Triangle t = world_triangle(c, found.element);
  double size = 0;
  for (const Vec3& v : {c.point, t[0], t[1], t[2]})
    size = std::max({size, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  const Vec3 off = found.point - Vec3{static_cast<double>(named.on_b.x), static_cast<double>(named.on_b.y),
                                      static_cast<double>(named.on_b.z)};
  return std::max({std::fabs(off.x), std::fabs(off.y), std::fabs(off.z)}) <= 1e-12 * size ? "" : "the point";
}

}  // namespace toccata::test
