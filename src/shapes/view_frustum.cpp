#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "math/vec3_measures.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/trigonometry.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {
namespace {

void require_view_number(bool is_right, std::string_view what, double value) {
  if (!is_right || !std::isfinite(value)) throw Error(fmt::format("view_frustum: {}; here it is {}", what, value));
}

void require_view_direction(const Vec3& v, std::string_view what) {
  if (!is_finite(v) || v == Vec3{}) throw Error(fmt::format("view_frustum: {}", what));
}

void require_right(const View& view) {
  const double view_angle = view.field_of_view;
  require_view_number(view_angle > 0 && view_angle < 180, "the field of view is above 0 and below 180 degrees",
                      view_angle);
  require_view_number(view.aspect > 0, "the aspect, width over height, is positive", view.aspect);
  require_view_number(view.nearest > 0, "the nearest plane lies before the eye, at more than 0", view.nearest);
  require_view_number(view.farthest > view.nearest, "the farthest plane lies beyond the nearest", view.farthest);
  require_view_direction(view.direction, "the direction is zero or not finite; give one into the picture");
  require_view_direction(view.up, "the vector up is zero or not finite; give one that is not along the direction");
}

}  // namespace

ConvexHull view_frustum(const View& view) {
  require_right(view);
  const Vec3 ahead = unit_or_zero(view.direction);
  const Vec3 right = unit_or_zero(cross(ahead, unit_or_zero(view.up)));
  if (right == Vec3{})
    throw Error("view_frustum: up is parallel to the direction, so that it tells no side; give another");
  const Vec3 up = cross(right, ahead);
  const SineCosine half = sine_cosine_of_degrees(0.5 * view.field_of_view);
  const double height = half.sine / half.cosine;
  std::vector<Vec3> corners;
  for (const double distance : {view.nearest, view.farthest})
    for (const double y : {-height, height})
      for (const double x : {-view.aspect * height, view.aspect * height})
        corners.push_back(view.eye + distance * ((ahead + x * right) + y * up));
  ConvexHull frustum(corners);
  if (frustum.dimension() < 3)
    throw Error(
        "view_frustum: so far from the origin doubles do not tell its corners apart; move the scene nearer to it");
  return frustum;
}

}  // namespace toccata
