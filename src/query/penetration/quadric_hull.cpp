#include "query/penetration/quadric_hull.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "narrow/quadrics/kinds/quadric_kind.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {
namespace {

void add_circle(std::vector<Vec3>& points, double radius, double height, int count) {
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
  }
}

/// Points of the surface of the shape whose half axes are 1.
template <QuadricKind Kind>
std::vector<Vec3> surface_points() {
  constexpr int around = 40, circles = 20;
  std::vector<Vec3> points;
  if constexpr (AxialKind<Kind>) {
    add_circle(points, 1, -1, around);
    if (Kind::has_tip)
      points.push_back({0, 0, 1});
    else
      add_circle(points, 1, 1, around);
    return points;
  }
  points = {{0, 0, -1}, {0, 0, 1}};
  for (int i = 1; i < circles; ++i) {
    const double latitude = std::numbers::pi * i / circles;
    add_circle(points, std::sin(latitude), std::cos(latitude), around);
  }
  return points;
}

}  // namespace

std::optional<ConvexHull> hull_within(const PosedQuadric& shape) {
  const Vec3 middle{0, 0, with_kind(shape.kind(), [](auto kind) { return kind.inner_height; })}, &half = shape.half();
  const std::vector<Vec3> surface = with_kind(shape.kind(), []<class Kind>(Kind) { return surface_points<Kind>(); });
  for (const double less : {0x1p-40, 0x1p-30, 0x1p-20, 0x1p-10, 0x1p-4}) {
    std::vector<Vec3> points;
    for (const Vec3& p : surface) {
      const Vec3 inner = p + less * (middle - p);
      points.push_back(transform(shape.pose(), {half.x * inner.x, half.y * inner.y, half.z * inner.z}));
    }
    const bool all_within = std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
      return quadric_contact(shape, PosedPolytope(Point(p))) == QuadricContact::contact;
    });
    if (!all_within) continue;
    ConvexHull hull(points);
    if (hull.dimension() == 3) return hull;
  }
  return std::nullopt;
}

}  // namespace toccata
