#include "narrow/boxes/aligned_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "math/bounded_number.hpp"
#include "math/constants.hpp"

namespace toccata {
namespace {

struct AxisInterval {
  double lower = 0;
  double upper = 0;
};

using Extents = std::array<AxisInterval, 3>;

/// A coordinate that depends on one bit of a corner's number only; the bit is 0 where there is none.
struct AlignedCoordinate {
  AxisInterval interval;
  int bit = 0;
};

AlignedCoordinate aligned(const double* along) {
  for (const int bit : {1, 2, 4}) {
    const auto is_told_by_bit = [=](int corner) { return along[corner] == along[corner & bit]; };
    if (std::ranges::all_of(std::array{1, 2, 3, 4, 5, 6, 7}, is_told_by_bit))
      return {{std::min(along[0], along[bit]), std::max(along[0], along[bit])}, bit};
  }
  return {};
}

/// Of a box whose corners have only two coordinates along every axis, whichever of its edges is along which.
std::optional<Extents> extents(const PosedPolytope& box) {
  if (box.vertex_count() != 8 || !box.in_world() || box.radius() != 0) return {};
  Extents extents;
  int bits = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const AlignedCoordinate coordinate = aligned(box.along(axis));
    bits |= coordinate.bit;
    extents[static_cast<std::size_t>(axis)] = coordinate.interval;
  }
  return bits == 7 ? std::optional(extents) : std::nullopt;
}

/// The least points of two intervals that are as near as possible.
struct NearestOnAxis {
  double on_a = 0;
  double on_b = 0;
};

NearestOnAxis nearest(const AxisInterval& a, const AxisInterval& b) {
  if (a.upper < b.lower) return {a.upper, b.lower};
  if (b.upper < a.lower) return {a.lower, b.upper};
  const double common = std::max(a.lower, b.lower);
  return {common, common};
}

/// Of two doubles, and by what it was rounded.
struct RoundedDifference {
  double rounded;
  double rest = 0;

  [[nodiscard]] double lower() const { return rest < 0 ? std::nextafter(rounded, -HUGE_VAL) : rounded; }
  [[nodiscard]] double upper() const { return rest > 0 ? std::nextafter(rounded, HUGE_VAL) : rounded; }
};

/// The rest after D. E. Knuth, "The Art of Computer Programming", volume 2, section 4.2.2.
RoundedDifference rounded_difference(double x, double y) {
  const double rounded = x - y, back = rounded - x;
  return {rounded, (x - (rounded - back)) - (y + back)};
}

double middle_of(double lower, double upper) { return std::max(lower, std::min(upper, 0.5 * lower + 0.5 * upper)); }

}  // namespace

std::optional<Distance> aligned_box_distance(const PosedPolytope& a, const PosedPolytope& b) {
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

std::optional<bool> aligned_boxes_meet(const PosedPolytope& a, const PosedPolytope& b) {
  const auto extents_a = extents(a);
  if (!extents_a) return {};
  const auto extents_b = extents(b);
  if (!extents_b) return {};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((*extents_a)[axis].upper < (*extents_b)[axis].lower || (*extents_b)[axis].upper < (*extents_a)[axis].lower)
      return false;
  return true;
}

// The difference of two such boxes is one too, so that the depth is the least of six differences of coordinates.
std::optional<Penetration> aligned_box_penetration(const PosedPolytope& a, const PosedPolytope& b) {
  const auto extents_a = extents(a);
  if (!extents_a) return {};
  const auto extents_b = extents(b);
  if (!extents_b) return {};
  Penetration result;
  RoundedDifference least{infinity};
  result.lower = least.rounded;
  for (int axis = 0; axis < 3; ++axis) {
    const AxisInterval &of_a = (*extents_a)[static_cast<std::size_t>(axis)],
                       &of_b = (*extents_b)[static_cast<std::size_t>(axis)];
    const RoundedDifference forwards = rounded_difference(of_a.upper, of_b.lower),
                            backwards = rounded_difference(of_b.upper, of_a.lower);
    result.lower = std::min({result.lower, forwards.lower(), backwards.lower()});
    const bool is_backwards = backwards.rounded < forwards.rounded;
    const RoundedDifference& here = is_backwards ? backwards : forwards;
    const double middle = middle_of(std::max(of_a.lower, of_b.lower), std::min(of_a.upper, of_b.upper));
    result.on_a[axis] = result.on_b[axis] = middle;
    if (!(here.rounded < least.rounded)) continue;
    least = here;
    result.direction = {};
    result.direction[axis] = is_backwards ? -1 : 1;
  }
  if (!(result.lower > 0) || !std::isfinite(least.rounded)) return {};
  result.upper = least.upper();
  for (int axis = 0; axis < 3; ++axis) {
    if (result.direction[axis] == 0) continue;
    const AxisInterval &of_a = (*extents_a)[static_cast<std::size_t>(axis)],
                       &of_b = (*extents_b)[static_cast<std::size_t>(axis)];
    result.on_a[axis] = result.direction[axis] > 0 ? of_a.upper : of_a.lower;
    result.on_b[axis] = result.direction[axis] > 0 ? of_b.lower : of_b.upper;
  }
  return result;
}

}  // namespace toccata
