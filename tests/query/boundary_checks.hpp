#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "oracle/penetration.hpp"
#include "support/convex_cases.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata::test {

/// A convex shape at its place and a point in it, on it or near it.
struct BoundaryCase {
  PlacedPolytope placed;
  Vec3 point;
};

inline double size_of(const PosedPolytope& shape, const Vec3& point) {
  double size = shape.radius();
  const auto see = [&](const Vec3& v) { size = std::max({size, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); };
  see(point);
  for (Index i = 0; i < shape.vertex_count(); ++i) see(shape.vertex(i));
  return size;
}

inline Vec3 point_about(const PosedPolytope& shape, Random& random) {
  const auto any = [&] { return shape.vertex(static_cast<Index>(random.below(shape.vertex_count()))); };
  Vec3 p = any();
  for (std::uint64_t i = random.below(4); i > 0; --i) {
    const double share = random.below(2) == 0 ? 0.5 : random.unit();
    p = p + share * (any() - p);
  }
  if (random.below(3) == 0) return p;
  const double reach = std::max({shape.radius(), std::fabs(p.x - any().x), std::fabs(p.z - any().z)});
  const double off = reach * (random.below(2) == 0 ? 1 : std::exp2(random.between(-50, 1)));
  const double x = random.between(-off, off), y = random.between(-off, off);
  // Along an axis some lie exactly on what a radius reaches.
  return random.below(4) == 0 ? p + Vec3{0, off, 0} : p + Vec3{x, y, random.between(-off, off)};
}

inline BoundaryCase boundary_case(const std::string& kind, const std::string& regime, Random& random) {
  const std::string& other = convex_kinds()[random.below(convex_kinds().size())];
  BoundaryCase c{convex_case(kind, other, regime, random).a, {}};
  c.point = point_about(posed(c.placed), random);
  return c;
}

/// What is wrong with the signed distance of the point, or nothing.
inline std::string boundary_fault(const BoundaryCase& c) {
  const auto model = std::visit([](const auto& shape) { return Model(shape); }, c.placed.shape);
  const SignedDistance found = signed_distance(c.point, model, c.placed.pose);
  const std::optional<SurfacePoint> surface = nearest_point(c.point, model, {.pose = c.placed.pose});
  const oracle::ConvexSet set = set_of(c.placed), at = oracle::point_set(c.point);
  const int side =
      is_solid(c.placed) ? oracle::side_of(oracle::exact(c.point), set) : static_cast<int>(!oracle::overlap(at, set));
  if (found.status != Status::exact || found.sign_by != SignBy::winding_number) return "not exact";
  if (found.side != (side < 0 ? Side::inside : side == 0 ? Side::boundary : Side::outside)) return "the side";
  const double lower = side < 0 ? -found.upper : found.lower, upper = side < 0 ? -found.lower : found.upper;
  if (lower != surface->lower || upper != surface->upper || !(found.nearest == surface->point)) return "two answers";
  if (side == 0) return lower == 0 && upper == 0 ? "" : "not 0 on the surface";
  if (!(lower >= 0 && upper > 0)) return "the sign";
  if (!(upper - lower <= 1e-12 * upper) && std::nextafter(lower, HUGE_VAL) < upper) return "the interval is wide";
  const oracle::Rational least = oracle::exact(lower), greatest = oracle::exact(upper);
  if (side < 0) {
    const oracle::Depth depth(at, set);
    if (depth.compare(least) < 0 || depth.compare(greatest) > 0) return "the depth is not in its interval";
  } else if (oracle::compare_distance(at, set, least) < 0 || oracle::compare_distance(at, set, greatest) > 0) {
    return "the distance is not in its interval";
  }
  // And a few of the least doubles, in which the tiniest shapes are counted.
  const double off = 4e-12 * size_of(posed(c.placed), c.point) + 4 * 5e-324;
  const Vec3 way = found.nearest - c.point;
  if (std::fabs(std::hypot(way.x, way.y, way.z) - upper) > off) return "the point is not so far away";
  const SignedDistance again = signed_distance(found.nearest, model, c.placed.pose);
  return std::max(-again.lower, again.upper) <= off ? "" : "the point is not on the boundary";
}

}  // namespace toccata::test
