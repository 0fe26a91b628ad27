#include "narrow/quadrics/pair_frame.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

double reach_of(const PosedQuadric& shape) {
  double largest = 0;
  for (const Vec3& row : shape.pose().linear.row) largest = std::max(largest, dot(magnitudes(row), shape.half()));
  return largest;
}

/// How far a shape reaches from a point. Only the own box of a hull is looked at.
double reach_from(const PosedPolytope& shape, const Vec3& origin) {
  double largest = 0;
  if (shape.in_world()) {
    for (Index i = 0; i < shape.vertex_count(); ++i)
      largest = std::max(largest, largest_magnitude(shape.vertex(i) - origin));
  } else {
    for (const Vec3& row : shape.pose().linear.row)
      largest = std::max(largest, shape.stored_extent() * sum_of_magnitudes(row));
    largest += largest_magnitude(shape.pose().offset - origin);
  }
  return largest + shape.radius();
}

/// Not less than what a coordinate loses below the range of doubles, and nothing beside what products round in the
/// frame, where sizes are about 1. Within the range itself: a product with what is below it takes a processor fifty
/// times as long.
constexpr double lost_below_range = 0x1p-900;

/// Brings the size to about 1.
PairFrame frame_of(const Vec3& origin, double size) {
  if (!std::isfinite(size)) return {origin, 0x1p-1000};
  return {origin, std::scalbn(1.0, std::clamp(-std::ilogb(size), -1000, 1000))};
}

}  // namespace

PairFrame pair_frame(const PosedQuadric& a, const PosedQuadric& b) {
  const double between = largest_magnitude(b.pose().offset - a.pose().offset);
  return frame_of(a.pose().offset, std::max(reach_of(a), reach_of(b) + between));
}

PairFrame pair_frame(const PosedQuadric& a, const PosedPolytope& b) {
  return frame_of(a.pose().offset, std::max(reach_of(a), reach_from(b, a.pose().offset)));
}

PairFrame pair_frame(const PosedQuadric& a, const PosedHalfSpace& b) {
  const double between = largest_magnitude(0x1p-700 * b.point - 0x1p-700 * a.pose().offset);
  return frame_of(a.pose().offset, std::max(reach_of(a), between));
}

Vec3 scaled_normal(const PosedHalfSpace& half_space) {
  const Vec3& n = half_space.normal;
  const int down = -std::ilogb(largest_magnitude(n));
  return {std::scalbn(n.x, down), std::scalbn(n.y, down), std::scalbn(n.z, down)};
}

BoundedVector PairFrame::place(const Vec3& world) const {
  // What is multiplied first may lose its last digits below the range, what is multiplied last not.
  BoundedVector placed;
  for (int i = 0; i < 3; ++i) {
    BoundedNumber& x = placed[static_cast<std::size_t>(i)];
    x = factor < 1 ? bounded_difference(factor * world[i], factor * origin[i])
                   : bounded_difference(world[i], origin[i]);
    if (factor > 1) x.value = {factor * x.value.high, factor * x.value.low};
    if (factor < 1) x.error = lost_below_range;
  }
  return placed;
}

BoundedVector PairFrame::scaled(const Vec3& world) const {
  BoundedVector result = exactly(factor * world);
  for (BoundedNumber& x : result) x.error = factor < 1 ? lost_below_range : 0;
  return result;
}

Vec3 PairFrame::back(const Vec3& placed) const {
  if (factor < 1) return (1 / factor) * (placed + factor * origin);
  return origin + (1 / factor) * placed;
}

}  // namespace toccata
