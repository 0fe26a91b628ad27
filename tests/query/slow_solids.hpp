#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "support/mesh_soups.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

// What regions of contact of two solids are compared with: slow and obvious, in doubles.
namespace toccata::test {

/// The solid angle of a triangle as seen from a point (A. Van Oosterom, J. Strackee, 1983), over 4 π.
inline double slow_winding_number(const Vec3& p, const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
    const double x = std::sqrt(dot(a, a)), y = std::sqrt(dot(b, b)), z = std::sqrt(dot(c, c));
    sum += 2 * std::atan2(dot(a, cross(b, c)), x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
  }
  return sum / (4 * std::acos(-1.0));
}

inline double distance_from_segment(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double length = dot(along, along), at = length > 0 ? std::clamp(dot(p - from, along) / length, 0.0, 1.0) : 0;
  const Vec3 gap = p - from - at * along;
  return std::sqrt(dot(gap, gap));
}

inline double distance_from(const Vec3& p, const Triangle& t) {
  double least = std::min({distance_from_segment(p, t[0], t[1]), distance_from_segment(p, t[1], t[2]),
                           distance_from_segment(p, t[2], t[0])});
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  bool is_over = dot(normal, normal) > 0;
  for (int i = 0; i < 3; ++i) is_over = is_over && dot(normal, cross(t[(i + 1) % 3] - t[i], p - t[i])) >= 0;
  if (is_over) least = std::min(least, std::abs(dot(normal, p - t[0])) / std::sqrt(dot(normal, normal)));
  return least;
}

/// A solid asked in the slow and obvious way.
struct SlowSolid {
  SlowSolid(const TriangleMesh& mesh, const Pose& pose) {
    for (const auto& corner : mesh.triangles())
      triangles.push_back({{transform(pose, mesh.vertices()[corner[0]]), transform(pose, mesh.vertices()[corner[1]]),
                            transform(pose, mesh.vertices()[corner[2]])}});
  }
  double distance(const Vec3& p) const {
    double least = 1e300;
    for (const Triangle& t : triangles) least = std::min(least, distance_from(p, t));
    return least;
  }
  bool holds(const Vec3& p) const { return std::abs(slow_winding_number(p, triangles)) > 0.75; }

  std::vector<Triangle> triangles;
};

inline std::vector<TriangleMesh> some_solids() {
  const std::vector<Vec2> corner = {{-1, -1}, {1, -1}, {1, -0.4}, {-0.4, -0.4}, {-0.4, 1}, {-1, 1}};
  const std::vector<Vec2> slit = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, 0.03}, {0, 0.03}, {0, -0.03}, {-1, -0.03}};
  return {extruded_mesh(slit, 1.2),
          box_mesh({0.7, 0.8, 0.9}),
          icosphere_mesh(0.9, 1),
          extruded_mesh(corner, 0.8),
          torus_mesh({.radius = 0.7, .tube_radius = 0.25, .around = 12, .sides = 8}),
          noise_sphere_mesh({.subdivisions = 1})};
}

/// Two of the solids, placed so that they often meet.
struct Meeting {
  TriangleMesh a, b;
  PairQuery query;
};

inline Meeting random_meeting(const std::vector<TriangleMesh>& solids, Random& random) {
  return {solids[random.below(solids.size())],
          solids[random.below(solids.size())],
          {.pose_a = {random_rotation(random), {}}, .pose_b = {random_rotation(random), random_vector(random, 1.2)}}};
}

/// What of a convex polygon is on the inner side of a plane through three points, from which `inside` is not seen
/// across it.
inline std::vector<Vec3> clipped_by(const std::vector<Vec3>& polygon, const Triangle& plane, const Vec3& inside) {
  const Vec3 across = cross(plane[1] - plane[0], plane[2] - plane[0]);
  const double side = dot(across, inside - plane[0]) < 0 ? -1 : 1;
  const auto height = [&](const Vec3& p) { return side * dot(across, p - plane[0]); };
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = height(p), at_q = height(q);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.push_back(p + (at_p / (at_p - at_q)) * (q - p));
  }
  return kept;
}

/// The area of the triangle within the solid, which is a sum of signed tetrahedra from its first corner.
inline double area_within(const Triangle& t, const SlowSolid& solid) {
  const Vec3 apex = solid.triangles[0][0];
  double area = 0;
  for (const Triangle& base : solid.triangles) {
    const double volume = dot(cross(base[0] - apex, base[1] - apex), base[2] - apex);
    if (std::abs(volume) < 1e-14) continue;
    std::vector<Vec3> part{t[0], t[1], t[2]};
    part = clipped_by(part, base, apex);
    for (int i = 0; i < 3 && !part.empty(); ++i)
      part = clipped_by(part, {{apex, base[i], base[(i + 1) % 3]}}, base[(i + 2) % 3]);
    double twice = 0;
    for (std::size_t i = 1; i + 1 < part.size(); ++i) {
      const Vec3 across = cross(part[i] - part[0], part[i + 1] - part[0]);
      twice += std::sqrt(dot(across, across));
    }
    area += (volume > 0 ? 0.5 : -0.5) * twice;
  }
  return std::abs(area);
}

/// Half the area of the surface of what both solids have in common, as it is seen along a direction. No faces of the
/// two lie in one plane.
inline double slow_shadow(const SlowSolid& a, const SlowSolid& b, const Vec3& along) {
  double twice = 0;
  for (const auto& [surface, solid] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const Triangle& t : surface->triangles) {
      const Vec3 across = cross(t[1] - t[0], t[2] - t[0]);
      const double size = std::sqrt(dot(across, across));
      if (size > 0) twice += std::abs(dot(along, across)) / size * area_within(t, *solid);
    }
  return twice / 2;
}

}  // namespace toccata::test
