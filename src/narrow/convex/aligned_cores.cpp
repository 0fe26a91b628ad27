#include "narrow/convex/aligned_cores.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "math/bounded_number.hpp"
#include "math/constants.hpp"
#include "narrow/convex/rounded_depth.hpp"
#include "narrow/exact/feature_pair.hpp"

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

AxisInterval interval_of(double x, double y) { return {std::min(x, y), std::max(x, y)}; }

AlignedCoordinate aligned(const double* along) {
  for (const int bit : {1, 2, 4}) {
    const auto is_told_by_bit = [=](int corner) { return along[corner] == along[corner & bit]; };
    if (std::ranges::all_of(std::array{1, 2, 3, 4, 5, 6, 7}, is_told_by_bit))
      return {interval_of(along[0], along[bit]), bit};
  }
  return {};
}

/// The extents of a box whose corners have only two coordinates along every axis, whichever of its edges is along
/// which.
std::optional<Extents> extents_of_corners(const PosedPolytope& box) {
  Extents extents;
  int bits = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const AlignedCoordinate coordinate = aligned(box.along(axis));
    if (coordinate.bit == 0) return {};
    bits |= coordinate.bit;
    extents[static_cast<std::size_t>(axis)] = coordinate.interval;
  }
  return bits == 7 ? std::optional(extents) : std::nullopt;
}

/// The extents of a segment along an axis, or of a point.
std::optional<Extents> extents_of_ends(const PosedPolytope& core) {
  Extents extents;
  int turned = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double* const along = core.along(axis);
    extents[static_cast<std::size_t>(axis)] = interval_of(along[0], along[core.vertex_count() - 1]);
    if (along[0] != along[core.vertex_count() - 1]) ++turned;
  }
  return turned <= 1 ? std::optional(extents) : std::nullopt;
}

std::optional<Extents> extents(const PosedPolytope& shape) {
  if (!shape.in_world()) return {};
  if (shape.vertex_count() <= 2) return extents_of_ends(shape);
  return shape.vertex_count() == 8 ? extents_of_corners(shape) : std::nullopt;
}

/// The sum, without an error where it is exact, as it often is for coordinates and radii of a few digits.
BoundedNumber sum(const BoundedNumber& a, double b) {
  const TwoPart high = two_sum(a.value.high, b), low = two_sum(high.low, a.value.low);
  if (a.error == 0 && low.low == 0) return {double_word(two_sum(high.high, low.high)), 0};
  return a + exactly(b);
}

/// Two shapes with the extents of their cores, and the points of these that are the nearest to each other.
struct AlignedPair {
  Extents a;
  Extents b;
  double radius_a;
  double radius_b;
  Vec3 on_a{};
  Vec3 on_b{};
  BoundedVector between{};  ///< on_a − on_b

  [[nodiscard]] bool cores_meet() const { return std::ranges::all_of(between, is_exactly_zero); }
  [[nodiscard]] bool has_radius() const { return radius_a > 0 || radius_b > 0; }
  [[nodiscard]] BoundedNumber reach() const { return exactly(radius_a) + exactly(radius_b); }
  /// The gap between shapes whose cores are so far apart.
  [[nodiscard]] BoundedNumber gap(const BoundedNumber& apart) const { return sum(sum(apart, -radius_a), -radius_b); }
  /// The depth of shapes whose cores are so deep in each other.
  [[nodiscard]] BoundedNumber depth(const BoundedNumber& of_cores) const {
    return sum(sum(of_cores, radius_a), radius_b);
  }
};

/// The least points of two intervals that are as near as possible.
void set_nearest(const AxisInterval& a, const AxisInterval& b, double& on_a, double& on_b) {
  on_a = a.upper < b.lower ? a.upper : b.upper < a.lower ? a.lower : std::max(a.lower, b.lower);
  on_b = a.upper < b.lower ? b.lower : b.upper < a.lower ? b.upper : on_a;
  on_a += 0.0;  // never −0
  on_b += 0.0;
}

std::optional<AlignedPair> aligned_pair(const PosedPolytope& a, const PosedPolytope& b) {
  const auto extents_a = extents(a);
  if (!extents_a) return {};
  const auto extents_b = extents(b);
  if (!extents_b) return {};
  AlignedPair pair{*extents_a, *extents_b, a.radius(), b.radius()};
  for (int axis = 0; axis < 3; ++axis)
    set_nearest(pair.a[static_cast<std::size_t>(axis)], pair.b[static_cast<std::size_t>(axis)], pair.on_a[axis],
                pair.on_b[axis]);
  pair.between = bounded_difference(pair.on_a, pair.on_b);
  return pair;
}

/// The core's point moved by a length along a vector, rounded. Along an axis that is one sum, whose ties are rounded
/// as any sum's.
std::optional<Vec3> surface_point(const Vec3& point, double by, const BoundedVector& along,
                                  const BoundedNumber& length) {
  if (by == 0) return point;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    if (!is_exactly_zero(along[(at + 1) % 3]) || !is_exactly_zero(along[(at + 2) % 3])) continue;
    Vec3 moved = point;
    moved[axis] += std::copysign(by, along[at].value.high * by);
    return moved;
  }
  return nearest_doubles(exactly(point) + (exactly(by) / length) * along);
}

/// A common point of shapes whose cores are apart and whose radii reach.
std::optional<Distance> common_point(const AlignedPair& pair) {
  const auto at = [](const Vec3& point) { return Distance{0, 0, point, point, Status::exact}; };
  if (pair.radius_a == 0) return at(pair.on_a);
  if (pair.radius_b == 0) return at(pair.on_b);
  const auto common = nearest_doubles(exactly(pair.on_a) - (exactly(pair.radius_a) / pair.reach()) * pair.between);
  return common ? std::optional(at(*common)) : std::nullopt;
}

/// The distance of shapes whose cores are that far apart, and of which one has a radius.
std::optional<Distance> offset_distance(const AlignedPair& pair, const BoundedNumber& apart) {
  const BoundedNumber gap = pair.gap(apart);
  if (gap.is_negative()) return common_point(pair);
  if (!gap.is_positive()) return {};
  const auto rounded = bracket(gap);
  const auto on_a = surface_point(pair.on_a, -pair.radius_a, pair.between, apart),
             on_b = surface_point(pair.on_b, pair.radius_b, pair.between, apart);
  if (!rounded || !on_a || !on_b) return {};
  return Distance{rounded->lower, rounded->upper, *on_a, *on_b, Status::exact};
}

/// Up to three vertices of the least face of a core that holds one of its points. How many they are.
std::size_t set_face_at(const Vec3& point, const PosedPolytope& core, const Extents& extents,
                        std::array<Index, 3>& vertices) {
  const auto is_of_face = [&](const Vec3& vertex) {
    for (int axis = 0; axis < 3; ++axis) {
      const AxisInterval& along = extents[static_cast<std::size_t>(axis)];
      const bool is_end = point[axis] == along.lower || point[axis] == along.upper;
      if (is_end && vertex[axis] != point[axis]) return false;
    }
    return true;
  };
  std::size_t found = 0;
  const bool is_point = core.vertex(0) == core.vertex(core.vertex_count() - 1);  // a segment's, too
  const Index count = is_point ? 1 : core.vertex_count();
  for (Index i = 0; i < count && found < 3; ++i)
    if (is_of_face(core.vertex(i))) vertices[found++] = i;
  return found;
}

double middle_of(double lower, double upper) { return std::max(lower, std::min(upper, 0.5 * lower + 0.5 * upper)); }

/// The penetration of shapes whose cores meet. The difference of two such cores is a box with edges parallel to the
/// axes, so that its depth is the least of six differences of coordinates.
std::optional<Penetration> penetration_of_cores_that_meet(const AlignedPair& pair) {
  Penetration result;
  result.lower = result.upper = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    const AxisInterval &of_a = pair.a[static_cast<std::size_t>(axis)], &of_b = pair.b[static_cast<std::size_t>(axis)];
    const auto forwards = bracket(pair.depth(bounded_difference(of_a.upper, of_b.lower))),
               backwards = bracket(pair.depth(bounded_difference(of_b.upper, of_a.lower)));
    if (!forwards || !backwards) return {};
    result.lower = std::min({result.lower, forwards->lower, backwards->lower});
    const double middle = middle_of(std::max(of_a.lower, of_b.lower), std::min(of_a.upper, of_b.upper));
    result.on_a[axis] = result.on_b[axis] = middle;
    const bool is_backwards = backwards->upper < forwards->upper;
    const double least = is_backwards ? backwards->upper : forwards->upper;
    if (!(least < result.upper)) continue;
    result.upper = least;
    result.direction = {};
    result.direction[axis] = is_backwards ? -1 : 1;
  }
  if (!(result.lower > 0) || !std::isfinite(result.upper)) return {};
  for (int axis = 0; axis < 3; ++axis) {
    if (result.direction[axis] == 0) continue;
    const AxisInterval &of_a = pair.a[static_cast<std::size_t>(axis)], &of_b = pair.b[static_cast<std::size_t>(axis)];
    result.on_a[axis] = result.direction[axis] > 0 ? of_a.upper + pair.radius_a : of_a.lower - pair.radius_a;
    result.on_b[axis] = result.direction[axis] > 0 ? of_b.lower - pair.radius_b : of_b.upper + pair.radius_b;
  }
  return result;
}

}  // namespace

std::optional<Distance> distance_of_aligned_cores(const PosedPolytope& a, const PosedPolytope& b) {
  const auto pair = aligned_pair(a, b);
  if (!pair) return {};
  if (pair->cores_meet()) return Distance{0, 0, pair->on_a, pair->on_b, Status::exact};
  const BoundedNumber apart = length(pair->between);
  if (pair->has_radius()) return offset_distance(*pair, apart);
  const auto rounded = bracket(apart);
  if (!rounded) return {};
  return Distance{rounded->lower, rounded->upper, pair->on_a, pair->on_b, Status::exact};
}

std::optional<bool> aligned_cores_meet(const PosedPolytope& a, const PosedPolytope& b) {
  const auto pair = aligned_pair(a, b);
  if (!pair) return {};
  if (pair->cores_meet()) return true;
  if (!pair->has_radius()) return false;
  const BoundedNumber gap = pair->gap(length(pair->between));
  if (gap.is_positive()) return false;
  if (gap.is_negative() || is_exactly_zero(gap)) return true;
  return {};
}

std::optional<ConvexSeparation> part_aligned_cores(const PosedPolytope& a, const PosedPolytope& b) {
  const auto pair = aligned_pair(a, b);
  if (!pair) return {};
  if (pair->cores_meet()) {
    const auto deep = penetration_of_cores_that_meet(*pair);
    return deep ? std::optional(ConvexSeparation{*deep, {}}) : std::nullopt;
  }
  if (!pair->has_radius()) return {};
  CertainNearest nearest;
  nearest.difference = pair->between;
  nearest.distance = length(pair->between);
  nearest.on_a = exactly(pair->on_a);
  nearest.on_b = exactly(pair->on_b);
  const auto depth = rounded_depth(nearest, pair->radius_a, pair->radius_b);
  if (!depth) return {};
  NearestFeatures features;
  features.count_a = set_face_at(pair->on_a, a, pair->a, features.a);
  features.count_b = set_face_at(pair->on_b, b, pair->b, features.b);
  return ConvexSeparation{*depth, pairs_of(features)};
}

}  // namespace toccata
