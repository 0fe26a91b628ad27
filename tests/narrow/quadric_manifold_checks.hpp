#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "oracle/quadric_contact.hpp"
#include "toccata/narrow/quadrics.hpp"

// What is promised of a manifold of a quadric, against 60 digits.
namespace toccata::test {

inline oracle::FinePoint fine_of(const Vec3& p) { return {oracle::Fine(p.x), oracle::Fine(p.y), oracle::Fine(p.z)}; }

inline const Vec3& position_of(const Manifold& m, int i) { return m.points[static_cast<std::size_t>(i)].position; }

/// The area of the hull of the points, seen along the normal: the greatest triangle, or the quadrilateral of two
/// diagonals.
inline double hull_area(const Manifold& m) {
  const auto twice = [&](int i, int j, int k, int l) {
    const Vec3 u = position_of(m, j) - position_of(m, i), v = position_of(m, l) - position_of(m, k);
    return std::fabs(dot(m.normal, cross(u, v)));
  };
  if (m.count < 3) return 0;
  if (m.count == 3) return 0.5 * twice(0, 1, 0, 2);
  return 0.5 * std::max({twice(0, 1, 0, 2), twice(0, 1, 0, 3), twice(0, 2, 0, 3), twice(1, 2, 1, 3), twice(0, 1, 2, 3),
                         twice(0, 2, 1, 3), twice(0, 3, 1, 2)});
}

/// The sets meet. `size`: of the pair.
inline std::string quadric_manifold_fault(const Manifold& m, const oracle::FineSet& a, const oracle::FineSet& b,
                                          double size) {
  using oracle::Fine;
  if (std::fabs(dot(m.normal, m.normal) - 1) > 1e-14) return "the normal is not unit";
  const oracle::FinePoint normal = fine_of(m.normal);
  const Fine depth = oracle::depth_along(a, b, normal);
  const Fine first = m.points[0].depth;
  if (first < depth - Fine(0x1p-19) * abs(depth) - Fine(2e-12 * size))
    return fmt::format("the first is {} deep, not {}", m.points[0].depth, depth.str(20));
  for (int i = 0; i < m.count; ++i) {
    const ManifoldPoint& p = m.points[static_cast<std::size_t>(i)];
    if (Fine(p.depth) > depth + Fine(1e-12 * size)) return fmt::format("{} deep, more than {}", p.depth, depth.str(20));
    const oracle::FinePoint at = fine_of(p.position);
    const Fine half = Fine(p.depth) / 2, reach = abs(at.x) + abs(at.y) + abs(at.z);
    const Fine slack = Fine(1e-11 * size) + Fine(0x1p-50) * reach;
    const auto moved = [&](const Fine& by) -> oracle::FinePoint {
      return {at.x + by * normal.x, at.y + by * normal.y, at.z + by * normal.z};
    };
    const Fine from_a = oracle::at_most_from(a, moved(half), slack),
               from_b = oracle::at_most_from(b, moved(-half), slack);
    if (from_a > slack) return fmt::format("point {} is {} from A, in a pair of size {}", i, from_a.str(6), size);
    if (from_b > slack) return fmt::format("point {} is {} from B, in a pair of size {}", i, from_b.str(6), size);
  }
  return "";
}

/// Up to four points hold at least a quarter of where the shapes are as deep as anywhere, but for cells of the grid.
inline std::string contact_extent_fault(const Manifold& m, const oracle::FineSet& a, const oracle::FineSet& b,
                                        double size) {
  const oracle::ContactArea region = oracle::contact_area(a, b, fine_of(m.normal), 1e-9 * size);
  if (hull_area(m) >= 0.25 * region.area - 4 * region.cell) return "";
  return fmt::format("they hold {} of {}", hull_area(m), region.area);
}

}  // namespace toccata::test
