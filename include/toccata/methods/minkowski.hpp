#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "toccata/core/index.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/shapes/convex_hull.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// A vertex of a sum is the sum of one vertex of each operand, and of no other two.
struct SumVertex {
  Index on_a = 0;  ///< as `PosedPolytope::vertex` numbers them
  Index on_b = 0;
  friend constexpr bool operator==(const SumVertex&, const SumVertex&) = default;
};

/// What a face of a sum is made of.
enum class SumFaceKind : std::uint8_t {
  of_a,      ///< a face of A, moved by a vertex of B or swept along an edge of B
  of_b,      ///< the same the other way round
  of_both,   ///< the sum of two parallel faces
  of_edges,  ///< the parallelogram of an edge of each
};

/// The Minkowski sum A + B of two bounded convex shapes, all points a + b, or the difference A − B, all points a − b,
/// as a polytope with its boundary. World coordinates and units. Immutable; copies share all.
///
/// Certified is the boundary of the exact sum of the hulls of the world vertices: which pairs of vertices are its
/// vertices, which of these make a face, which faces meet in an edge. Every sign behind that is exact: parallel faces
/// make one face, parallel edges one edge, and no vertex lies within a face or an edge. Rounded are only the
/// coordinates: `vertex` is the exact a ± b to the nearest doubles, off by half a unit in the last place of each
/// coordinate at most; so the polyhedron of the rounded vertices may be bent by as much. All questions are answered
/// about the exact sum.
///
/// Operands with a radius: the polytope is the sum of the cores, and the sum of the radii grows it.
///
/// By overlaying the Gauss maps (M. de Berg, M. van Kreveld, M. Overmars, O. Schwarzkopf, "Computational geometry", ch.
/// 13; E. Fogel, D. Halperin, "Exact and efficient construction of Minkowski sums of convex polyhedra", 2007): a face
/// of the sum belongs to a face of A, to a face of B, or to an edge of each whose arcs cross. In time proportional to
/// the faces of the sum times the degree of vertices.
class MinkowskiSum {
 public:
  [[nodiscard]] Index vertex_count() const;
  /// The pair of vertices that this vertex is the sum of; pairs are in ascending order of (on_a, on_b).
  [[nodiscard]] SumVertex pair(Index vertex) const;
  /// The exact point, each coordinate to the nearest double.
  [[nodiscard]] Vec3 vertex(Index i) const;

  /// 0: a point, 1: a segment, 2: a flat polygon, 3: a solid.
  [[nodiscard]] int dimension() const;
  /// Faces: first those of A (kinds of_a and of_both), then of B, then of edges.
  [[nodiscard]] HullTopology topology() const;
  [[nodiscard]] SumFaceKind face_kind(Index face) const;

  /// The sum of the operands' radii, rounded to nearest.
  [[nodiscard]] double radius() const;

  /// Where a point lies: negative inside, zero on the boundary, positive outside. Exact for every finite point, the
  /// radii included. What has no interior has nothing but boundary. Looks at every face; SumLocator is quicker where
  /// many points are asked. Throws Error when the point is not finite.
  [[nodiscard]] Sign side_of(const Vec3& point) const;
  /// The point lies in the sum or on its boundary. Where the sum is a difference A − B, B moved by exactly this vector
  /// meets A; at zero that is `overlap(A, B)`.
  [[nodiscard]] bool contains(const Vec3& point) const { return side_of(point) != Sign::positive; }

  /// The hull of the rounded vertices, without the radius. Vertices may be fewer where rounding made a face bend.
  [[nodiscard]] ConvexHull as_hull() const;
  /// The sum as a shape, its vertices rounded: a point, a segment, a hull, or with a radius these grown by it.
  [[nodiscard]] Shape as_shape() const;
  /// The faces as fans of triangles over the rounded vertices: closed, with this boundary's own faces and edges;
  /// without the radius. Throws Error when the sum is a point or a segment.
  [[nodiscard]] TriangleMesh as_mesh() const;

  struct Parts;
  explicit MinkowskiSum(std::shared_ptr<const Parts> parts);
  [[nodiscard]] const Parts& parts() const { return *parts_; }

 private:
  std::shared_ptr<const Parts> parts_;
};

/// Throws Error when a vertex of the sum is not finite.
[[nodiscard]] MinkowskiSum minkowski_sum(const PosedPolytope& a, const PosedPolytope& b);

/// A − B: B moved by a vector meets A exactly when the vector is in it.
[[nodiscard]] MinkowskiSum minkowski_difference(const PosedPolytope& a, const PosedPolytope& b);

/// Where points lie in a Minkowski sum, for many points: of a difference A − B, whether B meets A after many
/// translations. The same answers as `MinkowskiSum::side_of`, exact, in time that grows with the logarithm of the
/// number of faces. Immutable; copies share all, and any number of threads may ask.
///
/// Seen from a point inside, every direction leaves through one face. Directions are divided as the sides of a cube
/// are into squares, the squares into four where they have many faces, down to 1/1024 of a side; a point is compared
/// with the planes of the faces in its square. Around a vertex in which k faces meet the last squares have k. A sum
/// that is flat, or a thousand times longer than thick, is searched through face by face.
class SumLocator {
 public:
  /// Takes a hundred times as long as a question about the sum itself.
  explicit SumLocator(const MinkowskiSum& sum);

  /// The same answer as that of `MinkowskiSum::side_of`.
  [[nodiscard]] Sign side_of(const Vec3& point) const;
  [[nodiscard]] bool contains(const Vec3& point) const { return side_of(point) != Sign::positive; }

  /// Bytes beside those of the sum.
  [[nodiscard]] std::size_t memory() const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

/// All points within a distance of a convex solid, asked in the ways of point-in-offset-solid tests: the lecture's one
/// by planes that are moved outwards, the same with bevels, and the exact one. World coordinates and units. Immutable;
/// copies share all.
class OffsetSolid {
 public:
  /// Its own hull is kept: `solid` need not outlive it. Throws Error when it is a surface or has a radius itself, has
  /// been flattened by rounding, or the distance is negative or not finite.
  OffsetSolid(const PosedPolytope& solid, double distance);

  // All three throw Error when the point is not finite.

  /// Whether the point is behind all face planes, each moved outwards by the distance: exact as that, but it accepts
  /// more than the offset solid. Where two faces meet at the inner angle α it reaches 1 / sin(α / 2) times as far as it
  /// should, at a box's corner √3 times; at sharp edges any number of times.
  [[nodiscard]] bool in_moved_planes(const Vec3& point) const;

  /// Whether the point is behind these and behind one more plane across each edge and each corner, which touches the
  /// offset solid there: it still accepts all of it, and less beside it. For a box the error is at most 13 % of the
  /// distance instead of 73 %. The planes of bevels are rounded, to the accepting side.
  [[nodiscard]] bool in_beveled_planes(const Vec3& point) const;

  /// Whether the point is at most that far from the solid. Exact.
  [[nodiscard]] bool contains(const Vec3& point) const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace toccata
