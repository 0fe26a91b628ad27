#include "world/flight.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "query/posed_shape.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "world/body_box.hpp"

namespace toccata {
namespace {

/// Rows of matrices with such numbers add up to no more than six times the largest coordinate.
constexpr double largest_entry = 2;

bool has_small_entries(const Mat3& linear) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) largest = std::max(largest, largest_magnitude(linear[i]));
  return largest <= largest_entry;
}

Mat3 minus(const Mat3& a, const Mat3& b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }

double norm_of(const Mat3& matrix) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += dot(matrix[i], matrix[i]);
  return std::sqrt(sum);
}

/// Poses from floats are off by 2⁻²².
constexpr double most_deformed = 0x1p-20;

/// ‖R Rᵀ − I‖ is ‖RᵀR − I‖.
bool is_nearly_rotation(const Mat3& linear) {
  const auto off = [&](int i, int j) { return dot(linear[i], linear[j]) - (i == j ? 1 : 0); };
  const Vec3 lengths{off(0, 0), off(1, 1), off(2, 2)}, angles{off(0, 1), off(1, 2), off(2, 0)};
  return dot(lengths, lengths) + 2 * dot(angles, angles) <= most_deformed * most_deformed;
}

double magnitude_of(const Aabb& box) {
  return largest_magnitude(magnitudes(box.lower)) + largest_magnitude(magnitudes(box.upper));
}

/// How large the coordinates of a model are. The parts of a compound are placed in it first, each by a pose that is
/// rounded.
double magnitude_of(const Model& model) {
  const auto* compound = std::get_if<Compound>(&model.shape());
  if (compound == nullptr) return magnitude_of(body_box(Body{model}, {}, [] { return std::string("a part"); }));
  double magnitude = 0;
  for (std::size_t i = 0; i < model.parts().size(); ++i) {
    const Pose& pose = compound->parts()[i].pose;
    if (!has_small_entries(pose.linear)) return infinity;
    magnitude = std::max(magnitude, 8 * magnitude_of(model.parts()[i]) + sum_of_magnitudes(pose.offset));
  }
  return magnitude;
}

double way_beyond_velocity(const SpaceTimeMotion& motion, double steps) {
  return steps * (motion.velocity_error + 0.5 * steps * motion.max_acceleration);
}

/// What is said about how a body goes on.
struct ExpectedFlight {
  SpaceTimeMotion motion{};
  Mat3 turning{{Vec3{}, Vec3{}, Vec3{}}};
  double turning_speed = 0;
};

/// Whose ways in a step differ by no more than b from one step to the next goes in the k-th step from now within b k of
/// the last way.
ExpectedFlight expectation_of(const Body& body, const TurningParts& parts, const LastSights& sights, double steps) {
  constexpr double steady = 1.25;  // turning goes on as it was, in another direction at each step
  const Vec3 way = sights.now.centre - sights.before.centre;
  const Vec3 change = way - (sights.before.centre - sights.earlier.centre);
  const Mat3 turning = minus(sights.now.linear, sights.before.linear);
  const double bending = std::isinf(body.max_acceleration) ? 2 * length(change) : body.max_acceleration;
  const double more_turning =
      steady * norm_of(minus(turning, minus(sights.before.linear, sights.earlier.linear))) * parts.radius;
  const double all = bending + more_turning;
  const ExpectedFlight on{{way, 0, 0.5 * all, all}, turning, norm_of(turning) * parts.radius * (1 + 0x1p-20)};
  // Who promises a speed alone may turn at any time.
  const bool is_slower =
      (std::isinf(body.max_acceleration) && !std::isinf(body.max_speed)) ||
      body.max_speed < length(way) + on.turning_speed + way_beyond_velocity(on.motion, steps) / steps;
  return is_slower ? ExpectedFlight{{{}, 0, body.max_speed, 0}} : on;
}

/// The radius of a ball around a point within a convex shape, in its own frame; 0 where none is known.
double inner_radius(const Model& model, const Vec3& centre, double size) {
  if (const auto* box = std::get_if<Box>(&model.shape()))
    return std::min({box->half_extents().x, box->half_extents().y, box->half_extents().z});
  if (const auto* capsule = std::get_if<Capsule>(&model.shape())) return capsule->radius();
  if (const auto* hull = std::get_if<ConvexHull>(&model.shape())) {
    const PosedPolytope posed(*hull, {}), ball(Sphere(size, centre), {});
    return posed.solid() ? std::max(penetration(posed, ball).lower - size, 0.0) : 0;
  }
  return 0;
}

}  // namespace

TurningParts turning_parts(const Body& body) {
  if (const auto* sphere = std::get_if<Sphere>(&body.model.shape()))
    return {sphere->centre(), 0, sum_of_magnitudes(sphere->centre()) + sphere->radius(), {}, sphere->radius()};
  const Aabb box = body_box(Body{body.model}, {}, [] { return std::string("a body"); });
  const Vec3 centre = 0.5 * box.lower + 0.5 * box.upper;
  const double radius = length(box.upper - centre) + length(box.lower - centre);
  if (!(radius < 0x1p400)) return {{}, infinity, infinity};
  // Both halves of the diagonal, rounded to nearest: half their sum and a little more is no less than each.
  const Vec3 half_extents = 0.5 * (1 + 0x1p-40) * ((box.upper - centre) + (centre - box.lower));
  return {centre, 0.5 * radius * (1 + 0x1p-40), magnitude_of(body.model), half_extents,
          inner_radius(body.model, centre, radius)};
}

Sight sight_of(const TurningParts& parts, const Pose& pose) { return {transform(pose, parts.centre), pose.linear}; }

/// A matrix R takes a ball to an ellipsoid whose least half axis is at least 1 − ‖RᵀR − I‖ of the radius. Other
/// roundings are covered by the position errors of flights.
Ball inner_ball(const TurningParts& parts, const Pose& pose) {
  if (parts.inner == 0 || !is_nearly_rotation(pose.linear)) return {{}, 0};
  return {transform(pose, parts.centre), std::max(0.0, parts.inner - 2 * most_deformed * parts.magnitude)};
}

double Flight::turning_speed(const TurningParts& parts, const Vec3& along) const {
  if (turning_speed_ == 0) return 0;
  const Vec3 ways = magnitudes(transpose(turning_) * along);
  return std::min(turning_speed_, dot(ways, parts.half_extents) * (1 + 0x1p-40));
}

bool Flight::goes_on(const TurningParts& parts, const Sight& now, double step) {
  if (is_at_rest_ && now == last_) return true;
  // The numbers of what is nearly a rotation are small.
  if (!(is_rigid_ ? is_nearly_rotation(now.linear) : has_small_entries(now.linear))) return false;
  if (std::isinf(parts.radius)) return false;
  const double moved = plain_length((now.centre - last_.centre) - motion_.velocity);
  const double turned = norm_of(minus(minus(now.linear, last_.linear), turning_));
  const double off = (moved + turned * parts.radius) * (1 + 0x1p-40) + 0x1p-46 * magnitude_;
  const double allowed = motion_.velocity_error + (step - 0.5) * motion_.max_acceleration;
  last_ = now;
  return off <= allowed * (1 - 0x1p-40) + 0x1p-43 * magnitude_;
}

std::optional<Flight> flight_from(const Body& body, const TurningParts& parts, const LastSights& sights, double steps) {
  Flight flight;
  flight.last_ = sights.now;
  flight.is_at_rest_ = sights.now == sights.before && sights.now == sights.earlier;
  if (std::isinf(parts.magnitude)) return flight.is_at_rest_ ? std::optional(flight) : std::nullopt;
  if (!has_small_entries(sights.now.linear)) return std::nullopt;
  flight.is_rigid_ = parts.inner > 0 && is_nearly_rotation(sights.now.linear);
  const ExpectedFlight expected = flight.is_at_rest_ ? ExpectedFlight{} : expectation_of(body, parts, sights, steps);
  flight.motion_ = expected.motion;
  flight.turning_ = expected.turning;
  flight.turning_speed_ = expected.turning_speed;
  flight.magnitude_ = 64 * parts.magnitude + sum_of_magnitudes(sights.now.centre) +
                      steps * (sum_of_magnitudes(expected.motion.velocity) + expected.turning_speed) +
                      way_beyond_velocity(expected.motion, steps);
  // Squares neither overflow nor underflow.
  if (!(flight.magnitude_ < 0x1p400 && flight.magnitude_ > 0x1p-400)) return std::nullopt;
  flight.motion_.position_error = 0x1p-36 * flight.magnitude_;
  return flight;
}

}  // namespace toccata
