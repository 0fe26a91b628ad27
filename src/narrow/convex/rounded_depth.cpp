#include "narrow/convex/rounded_depth.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/double_search.hpp"

namespace toccata {
namespace {

/// The sign of the depth less (x + y) / 2.
class DepthComparison {
 public:
  DepthComparison(const ExactNearest& nearest, double radius_a, double radius_b)
      : nearest_(nearest), radius_a_(radius_a), radius_b_(radius_b) {}

  [[nodiscard]] Sign operator()(double x, double y) const {
    const int exponent = std::min(common_exponent({radius_a_, radius_b_, x, y}), nearest_.exponent);
    const auto whole = [&](double value) { return scaled_wide(value, exponent); };
    // Twice what the cores' distance would have to be.
    const WideInteger twice = 2 * whole(radius_a_) + 2 * whole(radius_b_) - whole(x) - whole(y);
    if (twice < 0) return Sign::negative;
    if (nearest_.meet) return sign_of(twice);
    const auto shift = static_cast<unsigned>(2 * (nearest_.exponent - exponent) + 2);
    const WideInteger core = nearest_.squared_numerator << shift;
    return sign_of(WideInteger(nearest_.squared_denominator * twice * twice - core));
  }

 private:
  const ExactNearest& nearest_;
  double radius_a_;
  double radius_b_;
};

double likely_distance(const ExactNearest& nearest) {
  if (nearest.meet) return 0;
  return std::sqrt(nearest_double(nearest.squared_numerator, nearest.squared_denominator, 2 * nearest.exponent));
}

Vec3 rounded_point(const HomogeneousVector& p, int exponent) {
  const auto along = [&](std::size_t axis) { return nearest_double(p.numerator[axis], p.denominator, exponent); };
  return {along(0), along(1), along(2)};
}

/// The doubles around a depth, 0 and 0 where it is not positive; nothing where its sign is not known.
std::optional<DoubleBracket> bracket_above_zero(const BoundedNumber& depth) {
  if (depth.is_positive()) return bracket(depth);
  if (depth.is_negative() || is_exactly_zero(depth)) return DoubleBracket{0, 0};
  return {};
}

}  // namespace

double enough_along(const Vec3& direction, double depth) {
  const double most = std::max({std::fabs(direction.x), std::fabs(direction.y), std::fabs(direction.z)});
  if (most == 1 && dot(direction, direction) == 1) return depth;
  return std::nextafter(depth + 0x1p-50 * depth, infinity);
}

Penetration rounded_depth(const ExactNearest& nearest, double radius_a, double radius_b,
                          const Vec3& direction_when_touching) {
  Penetration result;
  result.direction = direction_when_touching;
  if (!nearest.meet) {
    const Vec3 from_b = rounded_direction(nearest.direction);
    result.direction = (-1 / std::sqrt(dot(from_b, from_b))) * from_b;
  }
  const DepthComparison depth(nearest, radius_a, radius_b);
  result.on_a = rounded_point(nearest.on_a, nearest.exponent) + radius_a * result.direction;
  result.on_b = rounded_point(nearest.on_b, nearest.exponent) - radius_b * result.direction;
  if (depth(0, 0) != Sign::positive) return result;
  result.lower = greatest_double_below(depth, (radius_a + radius_b) - likely_distance(nearest));
  const bool is_exact = depth(result.lower, result.lower) == Sign::zero;
  result.upper = is_exact ? result.lower : std::nextafter(result.lower, infinity);
  result.upper = enough_along(result.direction, result.upper);
  return result;
}

/// It is known so well that its high parts are its direction but for their rounding. Where cores nearly touch it is the
/// difference of much larger numbers.
bool tells_direction(const BoundedVector& difference, double squared) {
  const double most = std::max({difference[0].error, difference[1].error, difference[2].error});
  return squared > 0x1p-900 && squared < 0x1p900 && 4 * most <= 0x1p-54 * std::sqrt(squared);
}

std::optional<Penetration> rounded_depth(const CertainNearest& nearest, double radius_a, double radius_b) {
  const auto depth = bracket_above_zero((exactly(radius_a) + exactly(radius_b)) - nearest.distance);
  if (!depth) return {};
  const Vec3 from_b = high_parts(nearest.difference);
  const double squared = dot(from_b, from_b);
  if (!tells_direction(nearest.difference, squared)) return {};
  Penetration result;
  result.direction = (-1 / std::sqrt(squared)) * from_b;
  result.on_a = high_parts(nearest.on_a) + radius_a * result.direction;
  result.on_b = high_parts(nearest.on_b) - radius_b * result.direction;
  result.lower = depth->lower;
  result.upper = depth->upper > 0 ? enough_along(result.direction, depth->upper) : 0;
  return result;
}

}  // namespace toccata
