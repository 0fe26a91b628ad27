#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>

#include "toccata/core/index.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// The boundary of a convex polytope as half-edges: every edge is two of them, one in each of its faces. A face is a
/// polygon whose half-edges turn counter-clockwise seen from outside. A flat polygon has two faces, its front and its
/// back; a segment has one face of two half-edges, which are each other's twin; a point has none.
struct HullTopology {
  std::span<const Index>
      face_start;                 ///< one more than faces: face f has the half-edges [face_start[f], face_start[f + 1])
  std::span<const Index> origin;  ///< for each half-edge, its first vertex; the next of its face starts at its last
  std::span<const Index> twin;    ///< for each half-edge, the same edge in the other face, the other way round
  std::span<const Index> face;    ///< for each half-edge, the face it belongs to
  std::span<const Index> leaving;  ///< for each vertex, a half-edge that starts at it
  /// For each cell of a grid of directions a vertex that is far along them, where a walk to the farthest begins. Empty
  /// in a hull of fewer than 512 vertices.
  std::span<const Index> guide{};

  [[nodiscard]] Index face_count() const { return face_start.empty() ? 0 : static_cast<Index>(face_start.size() - 1); }
  [[nodiscard]] Index next(Index half_edge) const {
    const Index end = face_start[face[half_edge] + 1];
    return half_edge + 1 == end ? face_start[face[half_edge]] : half_edge + 1;
  }
  [[nodiscard]] Index target(Index half_edge) const { return origin[twin[half_edge]]; }
};

class HalfSpace;
class TriangleMesh;

/// The points given to a hull are refused when there are more.
inline constexpr Index most_hull_points = 1U << 24;

/// The convex hull of points, exact: its vertices are those points that are extreme, its faces the true faces, coplanar
/// triangles merged. Signs are exact, so nothing is merged, moved or left out because it is nearly something. Shared
/// and immutable; copies share all. Less than 128 bytes a vertex from four vertices on.
///
/// The order is canonical: every face begins at its least vertex, faces are sorted by their first two vertices, and
/// `leaving` is the least half-edge of a vertex. So it does not depend on points that are not vertices.
///
/// A hull may be flat (a polygon, a segment, a point): it is a surface then, else solid.
///
/// Quickhull after C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The quickhull algorithm for convex hulls", 1996.
class ConvexHull {
 public:
  /// Throws Error when there is no point or more than `most_hull_points`, or one is not finite.
  explicit ConvexHull(std::span<const Vec3> points);
  explicit ConvexHull(std::initializer_list<Vec3> points);

  [[nodiscard]] Index vertex_count() const;
  /// A vertex in the shape's own frame. Vertices keep the order of the points; of equal points the first counts.
  [[nodiscard]] Vec3 vertex(Index i) const;
  /// The number that vertex i had among the points given.
  [[nodiscard]] Index source_of(Index vertex) const;

  /// 0: a point, 1: a segment, 2: a flat polygon, 3: a solid.
  [[nodiscard]] int dimension() const;
  [[nodiscard]] HullTopology topology() const;

  /// The coordinates of all vertices along an axis, padded by repeating the last vertex to a multiple of 8.
  [[nodiscard]] std::span<const double> padded_coordinates(int axis) const;

  /// The greatest magnitude of any coordinate of a vertex.
  [[nodiscard]] double largest_coordinate() const;

  /// Bytes that the hull takes, all of them.
  [[nodiscard]] std::size_t memory() const;

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

/// The hull of a mesh's vertices. A mesh that *is* a convex solid may be given where a hull is wanted; this tells when
/// it is not: throws Error when the mesh is open, inside out (its faces turn clockwise seen from outside), or not
/// convex, naming the face.
[[nodiscard]] ConvexHull hull_of_convex_mesh(const TriangleMesh& mesh);

/// The solid that half-spaces have in common. Its vertices are found exactly, by whole numbers, and rounded to the
/// nearest doubles; the hull is that of the rounded ones. So no point of the one lies farther from the other than a
/// vertex is moved: half a unit in the last place of each coordinate. Half-spaces that add nothing, or are there twice,
/// do no harm, and the order does not show. Throws Error when the half-spaces have no point in common, naming at most
/// four that have none; when what they have in common goes on without end, telling a direction; when it is flat, naming
/// in which planes it lies; when it is flat only by rounding; and when it takes more than so many comparisons of
/// vertices with planes and with each other in all, with those that find the four.
///
/// Time grows with half-spaces times vertices (3,000 about a ball: some two seconds), memory with half-spaces and
/// vertices. The usual limit is reached after ten to thirty seconds, by some 8,000 about a ball.
[[nodiscard]] ConvexHull hull_of_half_spaces(std::span<const HalfSpace> half_spaces,
                                             std::uint64_t most_comparisons = 1'000'000'000);

/// What a camera sees, in perspective.
struct View {
  Vec3 eye{};
  Vec3 direction{0, 0, -1};   ///< into the picture, of any length
  Vec3 up{0, 1, 0};           ///< any that is not parallel to the direction: what of it is across that points up
  double field_of_view = 60;  ///< from the bottom of the picture to its top, in degrees, above 0 and below 180
  double aspect = 1;          ///< the picture's width over its height
  double nearest = 0.1;       ///< planes across the direction between which something is seen, by their distance
  double farthest = 1000;     ///< from the eye: 0 < nearest < farthest
};

/// The solid that a camera sees. Its corners are rounded, by a few units in the last place of the distance from the eye
/// (over the sine of the angle between direction and up) and of the eye's coordinates. What it overlaps is in view;
/// `overlapping` of SceneIndex and WorldQueries finds it exactly. Throws Error that names a number out of range.
[[nodiscard]] ConvexHull view_frustum(const View& view);

}  // namespace toccata
