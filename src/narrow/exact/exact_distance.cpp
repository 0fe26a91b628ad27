#include "narrow/exact/exact_distance.hpp"

#include <algorithm>
#include <cmath>

#include "math/double_search.hpp"

namespace toccata {
namespace {

/// The sign of (core distance) − (radius_a + radius_b + (x + y) / 2), where that sum is not negative.
Sign compare_distance(const ExactNearest& nearest, double radius_a, double radius_b, double x, double y) {
  const std::initializer_list<double> parts = {radius_a, radius_b, radius_a, radius_b, x, y};
  const int exponent = std::min(common_exponent(parts), nearest.exponent);
  WideInteger twice = 0;
  for (const double part : parts) twice += scaled_wide(part, exponent);
  const auto shift = static_cast<unsigned>(2 * (nearest.exponent - exponent) + 2);
  const WideInteger core = nearest.squared_numerator << shift, reach = nearest.squared_denominator * twice * twice;
  return static_cast<Sign>(core.compare(reach) < 0 ? -1 : core.compare(reach) > 0 ? 1 : 0);
}

/// One coordinate of the point on a grown surface: that of the core's point, `radius` further along the direction.
class SurfaceCoordinate {
 public:
  SurfaceCoordinate(const HomogeneousVector& core, std::size_t axis, int exponent, double radius,
                    const IntegerVector& direction)
      : numerator_(core.numerator[axis]),
        denominator_(core.denominator),
        exponent_(exponent),
        radius_(radius),
        along_(direction[axis]),
        length_squared_(dot(direction, direction)) {}

  /// The sign of the coordinate less (x + y) / 2.
  [[nodiscard]] Sign operator()(double x, double y) const {
    const int unit = std::min(common_exponent({x, y, radius_}), exponent_);
    const WideInteger core = numerator_ << static_cast<unsigned>(exponent_ - unit + 1);
    const WideInteger rest = core - denominator_ * (scaled_wide(x, unit) + scaled_wide(y, unit));
    const WideInteger grown = 2 * scaled_wide(radius_, unit) * along_ * denominator_;
    // The sign of rest + grown / √length_squared.
    if (rest.sign() * grown.sign() >= 0) return static_cast<Sign>(rest.sign() != 0 ? rest.sign() : grown.sign());
    const int larger = WideInteger(rest * rest * length_squared_).compare(grown * grown);
    return static_cast<Sign>(larger == 0 ? 0 : larger > 0 ? rest.sign() : grown.sign());
  }

 private:
  WideInteger numerator_, denominator_;
  int exponent_;
  double radius_;
  WideInteger along_, length_squared_;
};

Vec3 rounded(const HomogeneousVector& point, int exponent) {
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis)
    result[axis] = nearest_double(point.numerator[static_cast<std::size_t>(axis)], point.denominator, exponent);
  return result;
}

/// The core's point moved by `radius` along a direction that is not zero.
Vec3 rounded_surface_point(const HomogeneousVector& core, int exponent, double radius, const IntegerVector& direction) {
  Vec3 result = rounded(core, exponent);
  if (radius == 0) return result;
  const Vec3 towards = rounded_direction(direction);
  const double length = std::sqrt(dot(towards, towards));
  for (int axis = 0; axis < 3; ++axis) {
    const SurfaceCoordinate coordinate(core, static_cast<std::size_t>(axis), exponent, radius, direction);
    result[axis] = nearest_double_by(coordinate, result[axis] + radius * (towards[axis] / length));
  }
  return result;
}

/// Between the cores, dividing the way from A to B as the radii do; they are not both zero.
HomogeneousVector dividing_point(const ExactNearest& nearest, double radius_a, double radius_b) {
  const int exponent = common_exponent({radius_a, radius_b});
  const WideInteger share_a = scaled_wide(radius_b, exponent), share_b = scaled_wide(radius_a, exponent);
  const HomogeneousVector &a = nearest.on_a, &b = nearest.on_b;
  return {(share_a * b.denominator) * a.numerator + (share_b * a.denominator) * b.numerator,
          a.denominator * b.denominator * (share_a + share_b)};
}

Distance at_common_point(const HomogeneousVector& point, int exponent) {
  const Vec3 common = rounded(point, exponent);
  return {0, 0, common, common, Status::exact};
}

/// Near enough to start the search for the exact one.
double likely_distance(const ExactNearest& nearest, double radius_a, double radius_b) {
  const double squared = nearest_double(nearest.squared_numerator, nearest.squared_denominator, 2 * nearest.exponent);
  return std::fmax(0, (std::sqrt(squared) - radius_a) - radius_b);
}

}  // namespace

bool offset_shapes_meet(const ExactNearest& nearest, double radius_a, double radius_b) {
  return nearest.meet || compare_distance(nearest, radius_a, radius_b, 0, 0) != Sign::positive;
}

Sign compare_core_distance(const ExactNearest& nearest, double x, double y) {
  return compare_distance(nearest, x, y, 0, 0);
}

Sign compare_offset_distance(const ExactNearest& nearest, double radius_a, double radius_b, double length) {
  return compare_distance(nearest, radius_a, radius_b, length, length);
}

Distance rounded_distance(const ExactNearest& nearest, double radius_a, double radius_b) {
  if (nearest.meet) return at_common_point(nearest.on_a, nearest.exponent);
  if (offset_shapes_meet(nearest, radius_a, radius_b))
    return at_common_point(dividing_point(nearest, radius_a, radius_b), nearest.exponent);
  const auto compare = [&](double x, double y) { return compare_distance(nearest, radius_a, radius_b, x, y); };
  Distance result;
  result.lower = greatest_double_below(compare, likely_distance(nearest, radius_a, radius_b));
  const bool is_double = compare(result.lower, result.lower) == Sign::zero;
  result.upper = is_double ? result.lower : of_rank(rank_of(result.lower) + 1);
  result.on_a = rounded_surface_point(nearest.on_a, nearest.exponent, radius_a, -nearest.direction);
  result.on_b = rounded_surface_point(nearest.on_b, nearest.exponent, radius_b, nearest.direction);
  return result;
}

}  // namespace toccata
