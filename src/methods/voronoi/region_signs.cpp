#include <algorithm>
#include <cmath>

#include "math/exact.hpp"
#include "math/filter.hpp"
#include "methods/voronoi/feature_walk.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// (to − from) · (p − from), and with what its products add up to.
Filtered filtered_along(const Vec3& from, const Vec3& to, const Vec3& p) {
  const Vec3 e = to - from, q = p - from;
  const double magnitude = ((std::fabs(e.x * q.x) + std::fabs(e.y * q.y)) + std::fabs(e.z * q.z)) + filter::floor;
  // Each product meets two differences, itself and two sums: five roundings.
  return {dot(e, q), 0x1p-50 * magnitude};
}

/// The side of a vertex–edge plane on which a point lies: positive, ahead of the vertex along the edge.
Sign side_of_vertex(const RegionParts& parts, Index half_edge, const Vec3& p) {
  const Vec3 from = parts.vertex(parts.topology.origin[half_edge]);
  const Vec3 to = parts.vertex(parts.topology.target(half_edge));
  const Filtered along = filtered_along(from, to, p);
  if (along.is_positive()) return Sign::positive;
  if (along.is_negative()) return Sign::negative;
  const RationalPoint start = to_rational(from);
  return sign_of(dot(to_rational(to) - start, to_rational(p) - start));
}

double magnitude_of_product(const Vec3& u, const Vec3& v) {
  return ((std::fabs(u.x * v.x) + std::fabs(u.y * v.y)) + std::fabs(u.z * v.z)) + filter::floor;
}

/// The side of an edge–face plane on which a point lies: positive, ahead of the edge into the face. With the edge e and
/// another edge f of the face from the same corner, both from the edge's end, the way into the face is (e × f) × e = (e
/// · e) f − (e · f) e turned as e and f turn.
Sign side_of_edge(const RegionParts& parts, Index half_edge, const Vec3& p) {
  const HullTopology& t = parts.topology;
  const Vec3 from = parts.vertex(t.origin[half_edge]), to = parts.vertex(t.target(half_edge));
  const Vec3 third = parts.vertex(t.target(t.next(half_edge)));
  const Vec3 e = to - from, f = third - from, q = p - from;
  const double value = dot(e, e) * dot(f, q) - dot(e, f) * dot(e, q);
  const double magnitude =
      magnitude_of_product(e, e) * magnitude_of_product(f, q) + magnitude_of_product(e, f) * magnitude_of_product(e, q);
  // Each term meets four differences, three products, four sums and the last difference: twelve roundings.
  const Filtered side{value, 0x1p-48 * magnitude + filter::floor};
  if (side.is_positive()) return Sign::positive;
  if (side.is_negative()) return Sign::negative;
  const RationalPoint start = to_rational(from), along = to_rational(to) - start;
  const RationalPoint other = to_rational(third) - start, point = to_rational(p) - start;
  return sign_of(Rational(dot(along, along) * dot(other, point) - dot(along, other) * dot(along, point)));
}

/// Positive in front.
Sign side_of_face(const RegionParts& parts, Index face, const Vec3& p) {
  const HullTopology& t = parts.topology;
  const Index h = t.face_start[face];
  const auto corner = [&](Index half_edge) { return parts.vertex(t.origin[half_edge]); };
  return orient3d(corner(h), corner(h + 1), corner(h + 2), p);
}

bool vertex_contains(const RegionParts& parts, Index vertex, const Vec3& p) {
  return std::ranges::all_of(parts.spokes_at(vertex), [&](const RegionParts::Spoke& spoke) {
    return side_of_vertex(parts, spoke.half_edge, p) != Sign::positive;
  });
}

bool edge_contains(const RegionParts& parts, Index edge, const Vec3& p) {
  for (const Index h : {edge, parts.topology.twin[edge]}) {
    if (side_of_vertex(parts, h, p) != Sign::positive) return false;
    if (parts.has_faces() && side_of_edge(parts, h, p) == Sign::positive) return false;
  }
  return true;
}

/// A point in the plane of a flat polygon belongs to the front.
bool face_contains(const RegionParts& parts, Index face, const Vec3& p) {
  const Sign side = side_of_face(parts, face, p);
  const bool counts = parts.dimension == 3 || face == 0;
  if (side == Sign::negative || (side == Sign::zero && !counts)) return false;
  const HullTopology& t = parts.topology;
  for (Index h = t.face_start[face]; h < t.face_start[face + 1]; ++h)
    if (side_of_edge(parts, h, p) != Sign::positive) return false;
  return true;
}

bool lies_inside(const RegionParts& parts, const Vec3& p) {
  if (parts.dimension < 3) return false;
  for (Index f = 0; f < parts.topology.face_count(); ++f)
    if (side_of_face(parts, f, p) != Sign::negative) return false;
  return true;
}

/// What the walk in doubles has found, that is likely.
FeatureWalk walk_to_point(const VoronoiRegions& regions, const Vec3& point, const ConvexFeature& start) {
  static const VoronoiRegions origin{Point{}};
  static const Pose unmoved;
  const Pose at{{}, point};
  return walk_features({&regions.parts(), &unmoved}, {&origin.parts(), &at}, start, {});
}

}  // namespace

bool VoronoiRegions::contains(const ConvexFeature& feature, const Vec3& point) const {
  if (feature.kind == ConvexFeature::Kind::vertex) return vertex_contains(*parts_, feature.index, point);
  if (feature.kind == ConvexFeature::Kind::edge) return edge_contains(*parts_, feature.index, point);
  return face_contains(*parts_, feature.index, point);
}

std::optional<ConvexFeature> VoronoiRegions::region_of(const Vec3& point, const ConvexFeature& start) const {
  if (!is_finite(point)) throw Error("a point asked about is not finite");
  const FeatureWalk walk = walk_to_point(*this, point, start);
  const ConvexFeature& found = walk.near.feature[0];
  if (contains(found, point)) return found;
  if (lies_inside(*parts_, point)) return {};
  // Rounding has hidden the last step, or several: exactly one region has it.
  for (const ConvexFeature& feature : features())
    if (contains(feature, point)) return feature;
  return {};
}

std::optional<ConvexFeature> VoronoiRegions::region_of(const Vec3& point) const {
  return region_of(point, {ConvexFeature::Kind::vertex, parts_->any_vertex()});
}

}  // namespace toccata
