#include "reports/pair_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "bounds/box_corners.hpp"
#include "query/posed_shape.hpp"
#include "toccata/bounds/volume.hpp"

namespace toccata::io {
namespace {

/// The same object with what its pose scales by in its box: so it may be written in another unit.
FormerObject without_scale(FormerObject object) {
  const Mat3& m = object.pose.linear;
  const double scale = std::cbrt(std::abs(dot(m[0], cross(m[1], m[2]))));
  if (!(scale > 0) || !std::isfinite(scale) || !object.box) return object;
  object.pose.linear = scaled(object.pose, 1 / scale).linear;
  object.box = Aabb{scale * object.box->lower, scale * object.box->upper};
  return object;
}

/// In its own frame; of what has no box the origin.
std::vector<Vec3> own_points(const FormerObject& object) {
  return object.box ? corners_of(*object.box) : std::vector<Vec3>{Vec3{}};
}

/// Its frame, moved to the middle of its box.
Pose middle_frame(const FormerObject& object) {
  return object.box ? object.pose * Pose::translation(middle(*object.box)) : object.pose;
}

/// How far the second is from where it would be if it had moved as the first has.
double left_behind(const FormerObject& first_then, const FormerObject& first_now, const FormerObject& then,
                   const FormerObject& now) {
  const bool can_carry = !is_singular(first_then.pose.linear);
  const Pose back = can_carry ? inverse(middle_frame(first_then)) : Pose{};
  const Pose forth = can_carry ? middle_frame(first_now) : Pose{};
  const std::vector<Vec3> before = own_points(then), after = own_points(now);
  double farthest = 0;
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
    const Vec3 carried = forth * (back * (then.pose * before[i]));
    const double distance = length(carried - now.pose * after[i]);
    if (!std::isfinite(distance)) return std::numeric_limits<double>::infinity();
    farthest = std::max(farthest, distance);
  }
  return farthest;
}

/// What is no more may be due to coordinates that were rounded to floats, and to poses that were to doubles.
double rounding_of(const FormerObject& object) {
  constexpr double of_floats = 1e-6, of_doubles = 1e-12;
  double rounding = of_doubles * length(object.pose.offset);
  for (const Vec3& point : own_points(object))
    rounding = std::max(rounding, of_floats * length(object.pose.linear * point));
  return rounding;
}

}  // namespace

FormerObject placed(const SceneInstance& object) {
  FormerObject result{object.name, object.pose, std::nullopt};
  if (const auto* half_space = std::get_if<HalfSpace>(&object.model.shape())) {
    const Vec3 normal = normalized(half_space->normal());
    const Vec3 foot = dot(half_space->point(), normal) * normal;
    result.box = Aabb{foot, foot};
    return result;
  }
  const Aabb box = object.model.has_mesh() ? object.model.bounds()
                                           : world_box(pose_model(object.model, Pose{}, Solid::automatic, object.name));
  if (!is_empty(box) && is_finite(box.lower) && is_finite(box.upper)) result.box = box;
  return result;
}

std::optional<double> moved_by(const PlacedPair& told_then, const PlacedPair& told_now, double tolerance) {
  const PlacedPair then{without_scale(told_then.a), without_scale(told_then.b)};
  const PlacedPair now{without_scale(told_now.a), without_scale(told_now.b)};
  const double distance =
      std::max({left_behind(then.a, now.a, then.b, now.b), left_behind(then.b, now.b, then.a, now.a),
                left_behind(then.a, now.a, then.a, now.a), left_behind(then.b, now.b, then.b, now.b)});
  const double rounding = std::max({rounding_of(then.a), rounding_of(then.b), rounding_of(now.a), rounding_of(now.b)});
  if (distance <= std::max(tolerance, rounding)) return std::nullopt;
  return std::isfinite(distance) ? distance : std::numeric_limits<double>::max();
}

}  // namespace toccata::io
