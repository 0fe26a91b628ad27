#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "methods/voronoi/feature_walk.hpp"
#include "narrow/convex/close_rise.hpp"

// Heights along a given direction d, in the shape's own frame, where it is convex exactly. Let x be a vertex of the
// feature. Any other vertex y is higher than x by a rise that the neighbourhood of the feature bounds:
//
// - of a vertex: those no higher than some level hang together by edges, so the lowest other one is a neighbour;
// - of an edge along the unit vector e, with the outward normals n and m of its faces: d = −(αn + βm) + γe. With the
//   depths N and M of y below the two faces, d · (y − x) = αN(y) + βM(y) + γe · (y − x). A corner of the first face
//   beyond the edge has N = 0 and so tells βM of itself; any y has N = 0 or N at least that share of the second face's
//   corner which `Edge::into` has taken into its way, and the same for M, and not both are 0;
// - of a face: d = −λn + what lies in the face, and y is deeper than the clearance of the face.
//
// What is left over, along the edge or in the face, can lower y by its size times |y − x| ≤ 2√3 · extent.
namespace toccata {

enum class Others : std::uint8_t {
  clear,    ///< none is close to the feature
  unknown,  ///< a look at all has to tell
  lower,    ///< some are lower than the feature
};

/// How much higher any other vertex is at least, and at most so much higher one is that was seen.
struct Rise {
  double least = 0;
  double seen = infinity;
};

/// Heights along a direction in the shape's own frame. Inline, as a question to a tracked pair asks for two.
struct Along {
  const VoronoiRegions::Parts& parts;
  Vec3 direction;
  double rounding;  // any two heights differ by less more or less than in exact numbers

  [[nodiscard, gnu::always_inline]] double height(Index i) const { return dot(direction, parts.vertex(i)); }

  [[nodiscard, gnu::always_inline]] Rise rise_from_vertex(Index vertex) const {
    double least = infinity;
    for (const auto& spoke : parts.spokes_at(vertex)) least = std::min(least, height(spoke.vertex));
    const double rise = least - height(vertex);
    return {rise, rise};
  }

  [[nodiscard, gnu::always_inline]] Rise rise_from_edge(const VoronoiRegions::Parts::Edge& edge) const {
    const double left = (std::fabs(height(edge.vertex[1]) - height(edge.vertex[0])) + rounding) * edge.lean;
    const double least = std::min(dot(direction, edge.into[0]), dot(direction, edge.into[1]));
    return {least - 2 * left, least + 2 * left};
  }

  [[nodiscard, gnu::always_inline]] Rise rise_from_face(const VoronoiRegions::Parts::Side& side) const {
    const double unsure = 2 * side.error * sum_of_magnitudes(direction);
    const double against = -dot(direction, side.normal) - unsure;
    const double left = plain_length(cross(direction, side.normal)) + unsure;
    return {against * side.clearance - 4 * parts.extent * left};
  }

  template <ConvexFeature::Kind kind>
  [[nodiscard, gnu::always_inline]] Rise rise_from(Index feature) const {
    if constexpr (kind == ConvexFeature::Kind::edge) return rise_from_edge(parts.edge(feature));
    if constexpr (kind == ConvexFeature::Kind::face) return rise_from_face(parts.sides[feature]);
    return rise_from_vertex(feature);
  }
};

/// Whether vertices that are not of the feature are close to it, as `SupportSearch::close` would find by looking at
/// all: from the planes around the feature alone, whatever the number of vertices. The direction is one of the world,
/// with the spread that goes with it. `clear` is certain.
template <ConvexFeature::Kind kind>
[[nodiscard, gnu::always_inline]] inline Others other_vertices(const WalkBody& body, Index feature,
                                                               const Vec3& direction, double spread) {
  const VoronoiRegions::Parts& parts = *body.parts;
  if (parts.dimension < 3 || has_more_corners(parts, {kind, feature})) return Others::unknown;
  const double close = most_close_rise(*body.pose, parts.extent, spread);
  const Rise rise = Along{parts, body.own(direction), close}.template rise_from<kind>(feature);
  if (rise.least > 2 * close) return Others::clear;
  return rise.seen < -2 * close ? Others::lower : Others::unknown;
}

}  // namespace toccata
