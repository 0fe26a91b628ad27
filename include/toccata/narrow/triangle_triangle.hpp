#pragma once

#include <array>
#include <compare>
#include <cstdint>

#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// A part of a triangle. Vertex i; edge i, from vertex i to vertex (i + 1) % 3 without its ends; face, without its
/// boundary. A triangle without area has fewer parts: those of its segment (two vertices, of equal ones the one of
/// least index; the edge between these two, on which the middle vertex lies, if any) or of its point (vertex 0).
enum class FeatureKind : std::uint8_t { vertex, edge, face };

struct Feature {
  FeatureKind kind = FeatureKind::face;
  std::uint8_t index = 0;
  /// Features are ordered by kind, then by index.
  friend constexpr auto operator<=>(const Feature&, const Feature&) = default;
};

enum class IntersectionKind : std::uint8_t {
  none,     ///< the triangles have no point in common
  point,    ///< exactly one
  segment,  ///< a segment of positive length
  polygon,  ///< a piece of area: the triangles are coplanar and overlap
};

/// One extreme point of an intersection: the single point in which these two features meet.
struct IntersectionPoint {
  Feature on_a;
  Feature on_b;
  friend constexpr auto operator<=>(const IntersectionPoint&, const IntersectionPoint&) = default;
};

/// The exact common set of two closed triangles, described by features, without a rounded coordinate.
struct Intersection {
  IntersectionKind kind = IntersectionKind::none;
  bool coplanar = false;  ///< all six vertices lie in one plane
  bool crossing = false;  ///< the relative interiors meet and the six vertices are not coplanar
  Feature on_a;           ///< the smallest feature of each triangle that contains the whole intersection
  Feature on_b;
  std::uint8_t count = 0;  ///< of extreme points: 0, 1, 2, or up to 6
  /// The ends of a segment are listed with the lesser first, by (on_a, on_b); the corners of a polygon in cyclic order,
  /// from the least towards the lesser of its two neighbours.
  std::array<IntersectionPoint, 6> points{};
  friend constexpr bool operator==(const Intersection&, const Intersection&) = default;
};

/// The extreme points of an intersection as coordinates. Each number is the double nearest to the exact one, so it is
/// off by at most half a unit in the last place, and by nothing where the point is a vertex.
struct IntersectionPoints {
  std::uint8_t count = 0;
  std::array<Vec3, 6> points{};
};

/// Do the closed triangles have a point in common? Exact for all finite doubles, triangles without area included. Two
/// methods that share nothing but the predicates; each is the oracle of the other.
///
/// The penetration method: vertices on both sides of the other's plane, and the segment in which the triangle cuts that
/// plane meets the other triangle (T. Möller, "A fast triangle-triangle intersection test", 1997; P. Guigue,
/// O. Devillers, "Fast and robust triangle-triangle overlap test using orientation predicates", 2003).
[[nodiscard]] bool overlap_by_penetration(const Triangle& a, const Triangle& b);

/// The separating-axes method: eleven axes where the six vertices span space, the edges' normals where they are
/// coplanar (S. Gottschalk, "Separating axis theorem", 1996).
[[nodiscard]] bool overlap_by_separating_axes(const Triangle& a, const Triangle& b);

/// The one the queries use (penetration).
[[nodiscard]] bool overlap(const Triangle& a, const Triangle& b);

/// What the two triangles have in common.
[[nodiscard]] Intersection intersect(const Triangle& a, const Triangle& b);

/// The points of `m = intersect(a, b)`.
[[nodiscard]] IntersectionPoints intersection_points(const Intersection& m, const Triangle& a, const Triangle& b);

/// The same with the roles of a and b exchanged.
[[nodiscard]] Intersection flipped(const Intersection& m);

}  // namespace toccata
