#include "world/flight.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "query/posed_shape.hpp"
#include "world/body_box.hpp"

namespace toccata {
namespace {

/// Rows of matrices with such numbers add up to no more than six times the largest coordinate.
constexpr double largest_entry = 2;
/// By no more than this may the matrix of a flight become another: then no entry is larger than 5.
constexpr double most_turned = 3;

bool has_small_entries(const Mat3& linear) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) largest = std::max(largest, largest_magnitude(linear[i]));
  return largest <= largest_entry;
}

double norm_of_difference(const Mat3& a, const Mat3& b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3 row = a[i] - b[i];
    sum += dot(row, row);
  }
  return std::sqrt(sum);
}

double magnitude_of(const Aabb& box) {
  return largest_magnitude(magnitudes(box.lower)) + largest_magnitude(magnitudes(box.upper));
}

/// Of a compound the parts are placed in it first, each by a pose that is rounded.
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

/// Whose ways in a step differ by no more than b from one step to the next is s steps later within b s (s + 1) / 2 of
/// where the last way takes it. Turning adds a way that is no longer than the sum of the ways of the steps.
SpaceTimeMotion expected_motion(const Body& body, const TurningParts& parts, const LastSights& sights, double steps) {
  const Vec3 way = sights.now.centre - sights.before.centre;
  const Vec3 change = way - (sights.before.centre - sights.earlier.centre);
  const double bending = std::isinf(body.max_acceleration) ? 2 * length(change) : body.max_acceleration;
  const double turn = norm_of_difference(sights.now.linear, sights.before.linear) * parts.radius;
  const double last_turn = norm_of_difference(sights.before.linear, sights.earlier.linear) * parts.radius;
  const double more_turn = 2 * std::fabs(turn - last_turn);
  const SpaceTimeMotion on{way, 0, 0.5 * (bending + more_turn) + turn * (1 + 0x1p-20), bending + more_turn};
  // Who promises a speed alone may turn at any time.
  const bool is_slower = (std::isinf(body.max_acceleration) && !std::isinf(body.max_speed)) ||
                         body.max_speed < length(way) + way_beyond_velocity(on, steps) / steps;
  return is_slower ? SpaceTimeMotion{{}, 0, body.max_speed, 0} : on;
}

}  // namespace

TurningParts turning_parts(const Body& body) {
  if (const auto* sphere = std::get_if<Sphere>(&body.model.shape()))
    return {sphere->centre(), 0, sum_of_magnitudes(sphere->centre()) + sphere->radius()};
  const Aabb box = body_box(Body{body.model}, {}, [] { return std::string("a body"); });
  const Vec3 centre = 0.5 * box.lower + 0.5 * box.upper;
  const double radius = length(box.upper - centre) + length(box.lower - centre);
  if (!(radius < 0x1p400)) return {{}, infinity, infinity};
  // Both halves of the diagonal, rounded to nearest: half their sum and a little more is no less than each.
  return {centre, 0.5 * radius * (1 + 0x1p-40), magnitude_of(body.model)};
}

Sight sight_of(const TurningParts& parts, const Pose& pose) { return {transform(pose, parts.centre), pose.linear}; }

bool Flight::is_kept(const TurningParts& parts, const Sight& now, double steps) const {
  if (is_at_rest_ && now == start_) return true;
  const double turned = norm_of_difference(now.linear, start_.linear);
  if (!(turned <= most_turned) || std::isinf(parts.radius)) return false;
  const double moved = length((now.centre - start_.centre) - steps * motion_.velocity);
  const double off = (moved + turned * parts.radius) * (1 + 0x1p-40) + 0x1p-42 * magnitude_;
  return off <= way_beyond_velocity(motion_, steps) * (1 - 0x1p-40) + 0x1p-37 * magnitude_;
}

std::optional<Flight> flight_from(const Body& body, const TurningParts& parts, const LastSights& sights, double steps) {
  Flight flight;
  flight.start_ = sights.now;
  flight.is_at_rest_ = sights.now == sights.before && sights.now == sights.earlier;
  if (std::isinf(parts.magnitude)) return flight.is_at_rest_ ? std::optional(flight) : std::nullopt;
  if (!has_small_entries(sights.now.linear)) return std::nullopt;
  if (!flight.is_at_rest_) flight.motion_ = expected_motion(body, parts, sights, steps);
  const SpaceTimeMotion& motion = flight.motion_;
  flight.magnitude_ = 64 * parts.magnitude + sum_of_magnitudes(sights.now.centre) +
                      steps * sum_of_magnitudes(motion.velocity) + way_beyond_velocity(motion, steps);
  if (!(flight.magnitude_ < 0x1p400)) return std::nullopt;
  flight.motion_.position_error = 0x1p-36 * flight.magnitude_;
  return flight;
}

}  // namespace toccata
