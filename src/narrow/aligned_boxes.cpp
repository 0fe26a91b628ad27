#include "narrow/aligned_boxes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "math/bounded_number.hpp"

namespace toccata {
namespace {

struct Interval {
  double lower = 0;
  double upper = 0;
};

using Extents = std::array<Interval, 3>;

/// Of a box whose corners, numbered as those of Box, have only two coordinates along every axis.
std::optional<Extents> extents(const PosedConvex& box) {
  if (box.vertex_count() != 8 || !box.in_world() || box.radius() != 0) return {};
  Extents extents;
  for (int axis = 0; axis < 3; ++axis) {
    const double* along = box.along(axis);
    const int bit = 1 << axis;
    for (int corner = 0; corner < 8; ++corner)
      if (along[corner] != along[corner & bit]) return {};
    extents[static_cast<std::size_t>(axis)] = {std::min(along[0], along[bit]), std::max(along[0], along[bit])};
  }
  return extents;
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

}  // namespace

std::optional<Distance> aligned_box_distance(const PosedConvex& a, const PosedConvex& b) {
  const auto extents_a = extents(a);
  if (!extents_a) return {};
  const auto extents_b = extents(b);
  if (!extents_b) return {};
  Distance result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    const NearestOnAxis points = nearest((*extents_a)[at], (*extents_b)[at]);
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

std::optional<bool> aligned_boxes_meet(const PosedConvex& a, const PosedConvex& b) {
  const auto extents_a = extents(a);
  if (!extents_a) return {};
  const auto extents_b = extents(b);
  if (!extents_b) return {};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((*extents_a)[axis].upper < (*extents_b)[axis].lower || (*extents_b)[axis].upper < (*extents_a)[axis].lower)
      return false;
  return true;
}

}  // namespace toccata
