#include "narrow/voronoi/others_clear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/vec3_measures.hpp"
#include "narrow/convex/gjk.hpp"

// Heights along a given direction d, in the shape's own frame, where it is convex exactly. Let x be a vertex of the
// feature. Any other vertex y is higher than x by a rise that the neighbourhood of the feature bounds:
//
// - of a vertex: those no higher than some level hang together by edges, so the lowest other one is a neighbour;
// - of an edge along the unit vector e, with the outward normals n and m of its faces: d = −(αn + βm) + γe. With the
//   depths N and M of y below the two faces, d · (y − x) = αN(y) + βM(y) + γe · (y − x). A corner of the first face
//   beyond the edge has N = 0 and so tells βM of itself; any y has N = 0 or N at least that share of the second face's
//   corner which `Rim` has taken into its way, and the same for M, and not both are 0;
// - of a face: d = −λn + what lies in the face, and y is deeper than the clearance of the face.
//
// What is left over, along the edge or in the face, can lower y by its size times |y − x| ≤ 2√3 · extent.
namespace toccata {
namespace {

using Parts = VoronoiRegions::Parts;

/// How much higher any other vertex is at least, and at most so much higher one is that was seen.
struct Rise {
  double least = 0;
  double seen = std::numeric_limits<double>::infinity();
};

struct Along {
  const Parts& parts;
  Vec3 direction;   // in the shape's own frame
  double rounding;  // any product of it and a way between vertices is off by less

  [[nodiscard]] Rise rise_from_vertex(Index vertex) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Parts::Spoke& spoke : parts.spokes_at(vertex)) least = std::min(least, dot(direction, spoke.along));
    return {least, least};
  }

  [[nodiscard]] Rise rise_from_edge(Index edge) const {
    const Parts::Rim &one = parts.rims[edge], &other = parts.rims[parts.topology.twin[edge]];
    const Vec3& along = parts.spokes[parts.spoke_of[edge]].along;
    const double left = 4 * parts.extent * std::fabs(dot(direction, along)) * one.per_length + rounding;
    const double least = std::min(dot(direction, one.into), dot(direction, other.into));
    return {least - 2 * left, least + 2 * left};
  }

  [[nodiscard]] Rise rise_from_face(Index face) const {
    const Parts::Side& side = parts.sides[face];
    const double unsure = 2 * side.error * sum_of_magnitudes(direction);
    const double against = -dot(direction, side.plane.normal) - unsure;
    const double left = plain_length(cross(direction, side.plane.normal)) + unsure;
    return {against * side.clearance - 4 * parts.extent * left};
  }

  [[nodiscard]] Rise rise_from(const ConvexFeature& feature) const {
    if (feature.kind == ConvexFeature::Kind::vertex) return rise_from_vertex(feature.index);
    return feature.kind == ConvexFeature::Kind::edge ? rise_from_edge(feature.index) : rise_from_face(feature.index);
  }
};

}  // namespace

Others other_vertices(const WalkBody& body, const ConvexFeature& feature, const Vec3& direction, double slack) {
  const Parts& parts = *body.parts;
  if (parts.dimension < 3 || has_more_corners(parts, feature)) return Others::unknown;
  const double close = most_close_rise(*body.pose, parts.extent, direction, slack);
  const Rise rise = Along{parts, body.own(direction), close}.rise_from(feature);
  if (rise.least > 2 * close) return Others::clear;
  return rise.seen < -2 * close ? Others::lower : Others::unknown;
}

}  // namespace toccata
