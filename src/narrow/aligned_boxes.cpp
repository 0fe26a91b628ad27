#include "narrow/aligned_boxes.hpp"

#include <algorithm>

#include "math/bounded_number.hpp"

namespace toccata {
namespace {

struct Interval {
  double lower = 0;
  double upper = 0;
};

/// What the box is along an axis, if its corners, numbered as those of Box, have only two coordinates there.
std::optional<Interval> extent(const PosedConvex& box, int axis) {
  const double* along = box.along(axis);
  const int bit = 1 << axis;
  for (int corner = 0; corner < 8; ++corner)
    if (along[corner] != along[corner & bit]) return {};
  return Interval{std::min(along[0], along[bit]), std::max(along[0], along[bit])};
}

/// The least points of two intervals that are as near as possible.
struct NearestOnAxis {
  double on_a = 0;
  double on_b = 0;
};

NearestOnAxis nearest(const Interval& a, const Interval& b) {
  if (a.upper < b.lower) return {a.upper, b.lower};
  if (b.upper < a.lower) return {a.lower, b.upper};
  const double common = std::max(a.lower, b.lower);
  return {common, common};
}

bool may_be_aligned(const PosedConvex& shape) {
  return shape.vertex_count() == 8 && shape.in_world() && shape.radius() == 0;
}

}  // namespace

std::optional<Distance> aligned_box_distance(const PosedConvex& a, const PosedConvex& b) {
  if (!may_be_aligned(a) || !may_be_aligned(b)) return {};
  Distance result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto extent_a = extent(a, axis), extent_b = extent(b, axis);
    if (!extent_a || !extent_b) return {};
    const NearestOnAxis points = nearest(*extent_a, *extent_b);
    result.on_a[axis] = points.on_a + 0.0;  // never −0
    result.on_b[axis] = points.on_b + 0.0;
  }
  const BoundedVector between = bounded_difference(result.on_a, result.on_b);
  if (std::ranges::all_of(between, is_exactly_zero)) return result;
  const auto rounded = bracket(length(between));
  if (!rounded) return {};
  result.lower = rounded->lower;
  result.upper = rounded->upper;
  return result;
}

}  // namespace toccata
