#include "io/cases/ask_nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/cases/asked_of.hpp"
#include "toccata/core/error.hpp"

namespace toccata::io {
namespace {

/// A distance beyond the doubles is not told by one.
void check_finite(std::span<const SceneInstance> models, const std::vector<ReportedPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const ReportedSurfacePoint& one : points[i].nearest)
      if (!std::isfinite(one.nearest.upper))
        throw Error(fmt::format("'{}': point {}: it is farther away than a double can tell (1.8e308)",
                                models[one.object].name, i));
}

/// The distance to an element, with the sign of the side on which the point is of the whole object.
SignedDistance with_side(const SurfacePoint& nearest, SignedDistance from) {
  const bool inside = from.side == Side::inside;
  from.lower = inside ? -nearest.upper : nearest.lower;
  from.upper = !inside || from.status == Status::undecided ? nearest.upper : -nearest.lower;
  from.nearest = nearest.point;
  from.element = nearest.element;
  from.face = nearest.face;
  return from;
}

/// Which points have something of the object among what is nearest to them.
std::vector<std::size_t> points_near(Index object, const std::vector<ReportedPoint>& points) {
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::any_of(points[i].nearest.begin(), points[i].nearest.end(),
                    [&](const ReportedSurfacePoint& one) { return one.object == object; }))
      near.push_back(i);
  return near;
}

/// On which side of each object found every point is, once for each.
void find_sides(std::span<const SceneInstance> models, const BatchOptions& batch, std::vector<ReportedPoint>& points) {
  for (std::size_t place = 0; place < models.size(); ++place) {
    const auto object = static_cast<Index>(place);
    const std::vector<std::size_t> near = points_near(object, points);
    if (near.empty()) continue;
    std::vector<Vec3> asked;
    for (const std::size_t i : near) asked.push_back(points[i].point);
    const SceneInstance& surface = models[place];
    const auto sides = asked_of(surface.name, [&] {
      return signed_distance_each(asked, surface.model, surface.pose, SignBy::automatic, batch);
    });
    for (std::size_t n = 0; n < near.size(); ++n)
      for (ReportedSurfacePoint& one : points[near[n]].nearest)
        if (one.object == object) one.signed_distance = with_side(one.nearest, sides[n]);
  }
}

}  // namespace

NearestReport ask_nearest(std::span<const SceneInstance> models, const NearestQuestion& question,
                          const BatchOptions& batch) {
  const auto found = nearest_points_each(question.points, question.k, models, question.within, batch);
  std::vector<ReportedPoint> points;
  for (std::size_t i = 0; i < found.size(); ++i) {
    points.push_back({question.points[i], {}});
    for (const ScenePoint& one : found[i]) points.back().nearest.push_back({one.nearest, one.object});
  }
  check_finite(models, points);
  if (!question.sides) return {std::move(points), false};
  find_sides(models, batch, points);
  const auto of_scene = signed_distance_each(question.points, models, SignBy::automatic, batch);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].in_scene = of_scene[i];
  return {std::move(points), true};
}

}  // namespace toccata::io
