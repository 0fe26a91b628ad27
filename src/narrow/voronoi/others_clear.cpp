#include "narrow/voronoi/others_clear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/vec3_measures.hpp"

// Heights along a given direction d, in the shape's own frame, where it is convex exactly. Let x be a vertex of the
// feature. Any other vertex y is higher than x by a rise that the neighbourhood of the feature bounds:
//
// - of a vertex: those no higher than some level hang together by edges, so the lowest other one is a neighbour;
// - of an edge along the unit vector e, with the outward normals n and m of its faces: d = −(αn + βm) + γe. With the
//   depths N and M of y below the two faces, d · (y − x) = αN(y) + βM(y) + γe · (y − x). A corner of the first face
//   beyond the edge has N = 0 and so tells βM of itself; any y has N = 0 or N at least the share of it that `Rim` knows
//   of the second face's corner, and the same for M, and not both are 0;
// - of a face: d = −λn + what lies in the face, and y is deeper than the clearance of the face.
//
// What is left over, along the edge or in the face, can lower y by its size times |y − x| ≤ 2√3 · extent.
namespace toccata {
namespace {

using Parts = VoronoiRegions::Parts;

struct Along {
  const Parts& parts;
  const Vec3& direction;
  double rounding;  // of any product of the direction and a way between vertices
};

/// How much higher any other vertex is at least, and a height that one has, both from that of the feature.
struct Rise {
  double least = -std::numeric_limits<double>::infinity();
  double seen = 0;
};

Rise rise_from_vertex(const Along& d, Index vertex) {
  double least = std::numeric_limits<double>::infinity();
  for (const Parts::Spoke& spoke : d.parts.spokes_at(vertex))
    least = std::min(least, dot(d.direction, spoke.plane.normal) * spoke.length);
  return {least - d.rounding, least};
}

Rise rise_from_edge(const Along& d, Index edge) {
  const Vec3& unit = d.parts.spokes[d.parts.spoke_of[edge]].plane.normal;
  const double left = 4 * d.parts.extent * std::fabs(dot(d.direction, unit)) + d.rounding;
  const Parts::Rim &one = d.parts.rims[edge], &other = d.parts.rims[d.parts.topology.twin[edge]];
  const double in_one = dot(d.direction, one.into), in_other = dot(d.direction, other.into);
  const double least = std::min(one.least_share * (in_one - left), other.least_share * (in_other - left));
  return {least - left, std::min(in_one, in_other) + left};
}

Rise rise_from_face(const Along& d, Index face) {
  const Parts::Side& side = d.parts.sides[face];
  const double unsure = 2 * side.error * sum_of_magnitudes(d.direction);
  const double against = -dot(d.direction, side.plane.normal) - unsure;
  const double left = plain_length(cross(d.direction, side.plane.normal)) + unsure;
  return {against * side.clearance - (4 * d.parts.extent * left + d.rounding)};
}

Rise rise_from(const Along& d, const ConvexFeature& feature) {
  if (feature.kind == ConvexFeature::Kind::vertex) return rise_from_vertex(d, feature.index);
  return feature.kind == ConvexFeature::Kind::edge ? rise_from_edge(d, feature.index)
                                                   : rise_from_face(d, feature.index);
}

}  // namespace

Others other_vertices(const SupportSearch& shape, const Parts& parts, const ConvexFeature& feature, Index first,
                      const Vec3& first_in_world, const Vec3& direction, double slack) {
  if (parts.dimension < 3 || has_more_corners(parts, feature)) return Others::unknown;
  const SupportSearch::Level level = shape.close_level(direction, slack, first_in_world);
  const Along along{parts, level.direction, 0x1p-47 * (sum_of_magnitudes(level.direction) * parts.extent)};
  const double above = level.height - dot(level.direction, parts.vertices[first]);
  const Rise rise = rise_from(along, feature);
  if (rise.least > above + along.rounding) return Others::clear;
  // The scan that this saves would find a vertex lower, too, and it does not matter when not.
  return rise.seen < -std::fabs(above) ? Others::lower : Others::unknown;
}

}  // namespace toccata
