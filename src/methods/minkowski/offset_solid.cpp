#include "toccata/methods/minkowski.hpp"

#include <cmath>

#include "math/vec3_measures.hpp"
#include "math/wide_integer.hpp"
#include "methods/minkowski/sum_operand.hpp"
#include "narrow/convex/vertices_of.hpp"
#include "narrow/near.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// All points x with normal · x ≤ height.
struct Bevel {
  Vec3 normal;
  double height = 0;
};

/// Touches the offset solid, or lies beyond it by rounding: by less than 2^-48 of the coordinates and the distance.
Bevel bevel_across(const Vec3& direction, std::span<const Vec3> points, double distance) {
  double height = -HUGE_VAL, size = distance;
  for (const Vec3& p : points) {
    height = std::max(height, dot(direction, p));
    size = std::max(size, largest_magnitude(p));
  }
  return {direction, height + distance * plain_length(direction) + 0x1p-48 * size * sum_of_magnitudes(direction)};
}

std::vector<Bevel> bevels_of(const SumOperand& solid, double distance) {
  std::vector<Bevel> bevels;
  std::vector<Vec3> at_corner(solid.points().size());
  const auto unit = [&](Index face) { return unit_or_zero(solid.faces()[face].normal); };
  for (Index h = 0; h < solid.half_edges().size(); ++h) {
    const SumOperand::HalfEdge& edge = solid.half_edges()[h];
    at_corner[edge.origin] = at_corner[edge.origin] + unit(edge.face);
    if (h < edge.twin)
      bevels.push_back(
          bevel_across(unit(edge.face) + unit(solid.half_edges()[edge.twin].face), solid.points(), distance));
  }
  for (const Vec3& direction : at_corner) bevels.push_back(bevel_across(direction, solid.points(), distance));
  return bevels;
}

}  // namespace

struct OffsetSolid::Parts {
  ConvexHull hull;
  PosedPolytope convex;
  SumOperand solid;
  double distance = 0;
  std::vector<Bevel> bevels;

  Parts(const PosedPolytope& of, double by)
      : hull(vertices_of(of)), convex(hull), solid(convex, false), distance(by), bevels(bevels_of(solid, by)) {}
};

OffsetSolid::OffsetSolid(const PosedPolytope& solid, double distance) {
  if (!solid.solid() || solid.radius() > 0)
    throw Error("only a solid with flat faces is grown by moving its planes; use Rounded for other shapes");
  if (!(distance >= 0) || !std::isfinite(distance))
    throw Error("the distance by which a solid is grown is negative or not finite; give 0 or more");
  const auto parts = std::make_shared<Parts>(solid, distance);
  if (parts->solid.dimension() < 3) throw Error("rounding has flattened the solid in the world; use a larger scale");
  parts_ = parts;
}

namespace {

/// Whether the point is not beyond the plane of a face moved outwards by the distance: n · (p − v) ≤ distance · |n|,
/// exactly.
bool is_behind_exactly(const SumOperand& solid, Index face, const Vec3& point, double distance) {
  const auto [u, v] = solid.plane_of(face);
  const std::array all{u.head, u.tail, v.head, point};
  const int exponent = std::min(common_exponent(all), common_exponent({distance}));
  const auto at = [&](const Vec3& p) { return scaled_wide(p, exponent); };
  const IntegerVector normal = cross(at(u.head) - at(u.tail), at(v.head) - at(v.tail));
  const WideInteger height = dot(normal, at(point) - at(u.tail)), reach = scaled_wide(distance, exponent);
  return height <= 0 || height * height <= reach * reach * dot(normal, normal);
}

bool is_behind(const SumOperand& solid, Index face, const Vec3& point, double distance) {
  const SumOperand::Face& f = solid.faces()[face];
  const Vec3 from = point - solid.points()[f.corners[0]];
  const double height = dot(f.normal, from), limit = distance * plain_length(f.normal);
  const double error = 0x1p-48 * f.magnitude * (largest_magnitude(from) + distance) + 0x1p-1000;
  if (height < limit - error) return true;
  if (height > limit + error) return false;
  return is_behind_exactly(solid, face, point, distance);
}

}  // namespace

bool OffsetSolid::in_moved_planes(const Vec3& point) const {
  if (!is_finite(point))
    throw Error("a point asked about has a coordinate that is not finite; give finite coordinates");
  for (Index f = 0; f < parts_->solid.faces().size(); ++f)
    if (!is_behind(parts_->solid, f, point, parts_->distance)) return false;
  return true;
}

bool OffsetSolid::in_beveled_planes(const Vec3& point) const {
  if (!in_moved_planes(point)) return false;
  const double rounding = 0x1p-48 * largest_magnitude(point);
  for (const Bevel& bevel : parts_->bevels)
    if (dot(bevel.normal, point) > bevel.height + rounding * sum_of_magnitudes(bevel.normal)) return false;
  return true;
}

bool OffsetSolid::contains(const Vec3& point) const {
  return nearby(PosedPolytope(Point{point}), parts_->convex, WantedDistance::within(parts_->distance)).has_value();
}

}  // namespace toccata
