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

double rise_from_vertex(const Along& d, Index vertex) {
  double least = std::numeric_limits<double>::infinity();
  for (const Parts::Spoke& spoke : d.parts.spokes_at(vertex))
    least = std::min(least, dot(d.direction, spoke.plane.normal) * spoke.length);
  return least - d.rounding;
}

double rise_from_edge(const Along& d, Index edge) {
  const Parts::Spoke& spoke = d.parts.spokes[d.parts.spoke_of[edge]];
  const double left = 4 * d.parts.extent * std::fabs(dot(d.direction, spoke.plane.normal)) + d.rounding;
  const Parts::Rim &one = d.parts.rims[edge], &other = d.parts.rims[d.parts.topology.twin[edge]];
  const double of_one = one.least_share * (dot(d.direction, one.into) - left);
  const double of_other = other.least_share * (dot(d.direction, other.into) - left);
  return std::min(of_one, of_other) - left;
}

double rise_from_face(const Along& d, Index face) {
  const Parts::Side& side = d.parts.sides[face];
  const double unsure = 2 * side.error * sum_of_magnitudes(d.direction);
  const double against = -dot(d.direction, side.plane.normal) - unsure;
  const double left = plain_length(cross(d.direction, side.plane.normal)) + unsure;
  return against * side.clearance - (4 * d.parts.extent * left + d.rounding);
}

double rise_from(const Along& d, const ConvexFeature& feature) {
  if (feature.kind == ConvexFeature::Kind::vertex) return rise_from_vertex(d, feature.index);
  return feature.kind == ConvexFeature::Kind::edge ? rise_from_edge(d, feature.index)
                                                   : rise_from_face(d, feature.index);
}

}  // namespace

bool others_clear(const SupportSearch& shape, const Parts& parts, const ConvexFeature& feature, Index first,
                  const Vec3& direction, double slack) {
  if (parts.dimension < 3 || has_more_corners(parts, feature)) return false;
  const SupportSearch::Level level = shape.close_level(direction, slack, shape.vertex(first));
  const Along along{parts, level.direction, 0x1p-47 * (sum_of_magnitudes(level.direction) * parts.extent)};
  const double base = dot(level.direction, parts.vertices[first]);
  return base + rise_from(along, feature) > level.height;
}

}  // namespace toccata
