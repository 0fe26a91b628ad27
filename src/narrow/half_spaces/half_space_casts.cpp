#include "narrow/half_spaces/half_space_casts.hpp"

#include <cmath>

#include "math/double_search.hpp"
#include "math/root_sign.hpp"
#include "narrow/half_spaces/half_space_gap.hpp"
#include "narrow/seen_from_target.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// A ball that moves: when does it reach the plane?
class FallingBall {
 public:
  FallingBall(const Vec3& centre, double radius, const Vec3& motion, const PosedHalfSpace& h)
      : radius_(radius),
        height_(exact_height(h, centre)),
        motion_exponent_(common_exponent({motion.x, motion.y, motion.z})) {
    climb_ = dot(scaled_wide(motion, motion_exponent_), height_.normal);
  }

  [[nodiscard]] bool falls() const { return climb_ < 0; }

  /// The sign of the time of arrival less (x + y) / 2: that of the gap which is left at that time.
  [[nodiscard]] Sign compare(double x, double y) const {
    const int time_unit = common_exponent({x, y}) == std::numeric_limits<int>::max() ? 0 : common_exponent({x, y});
    const WideInteger twice_time = scaled_wide(x, time_unit) + scaled_wide(y, time_unit);
    const int radius_unit = radius_ == 0 ? 0 : binary_fraction(radius_).exponent;
    const int unit = std::min({height_.length_exponent, motion_exponent_ + time_unit, radius_unit});
    const auto shifted = [unit](const WideInteger& value, int exponent) {
      return WideInteger(value << static_cast<unsigned>(exponent - unit));
    };
    const WideInteger height = shifted(2 * height_.height, height_.length_exponent) +
                               shifted(twice_time * climb_, motion_exponent_ + time_unit);
    const WideInteger reach = shifted(2 * scaled_wide(radius_, radius_unit), radius_unit);
    return root_sum_sign(height, -reach, height_.normal_squared);
  }

 private:
  double radius_;
  ExactHeight height_;
  int motion_exponent_;
  WideInteger climb_;  // motion · normal
};

}  // namespace

std::optional<Cast> cast_shape(const PosedPolytope& a, const Vec3& motion, const PosedHalfSpace& b) {
  if (!is_finite(motion)) throw Error("a cast: the motion has a coordinate that is not finite");
  const Vec3 lowest = extreme_vertex(a, b, Reach::below).position;
  Cast cast;
  if (overlap(a, b)) {
    cast.point = distance(a, b).on_b;
    return cast;
  }
  if (motion == Vec3{}) return {};
  const FallingBall ball(lowest, a.radius(), motion, b);
  if (!ball.falls() || ball.compare(1, 1) == Sign::positive) return {};
  const auto compare = [&](double x, double y) { return ball.compare(x, y); };
  const Vec3 normal = unit_normal(b);
  const double guess = (dot(normal, lowest - b.point) - a.radius()) / -dot(normal, motion);
  cast.lower = greatest_double_below(compare, std::fmin(std::fmax(guess, 0), 1));
  cast.upper = compare(cast.lower, cast.lower) == Sign::zero ? cast.lower : of_rank(rank_of(cast.lower) + 1);
  cast.point = (lowest + cast.lower * motion) - a.radius() * normal;
  cast.normal = normal;
  return cast;
}

std::optional<Cast> cast_shape(const PosedHalfSpace& a, const Vec3& motion, const PosedPolytope& b) {
  return seen_from_target(cast_shape(b, -motion, a), motion);
}

std::optional<Cast> cast_ray(const Vec3& origin, const Vec3& motion, const PosedHalfSpace& target) {
  if (!is_finite(origin)) throw Error("a ray: its origin has a coordinate that is not finite");
  if (motion == Vec3{}) throw Error("a ray: its motion is zero; ask whether the point overlaps");
  return cast_shape(PosedPolytope(Point(origin)), motion, target);
}

}  // namespace toccata
