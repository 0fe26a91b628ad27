#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/shapes/box.hpp"
#include "toccata/shapes/convex_hull.hpp"
#include "toccata/shapes/point.hpp"
#include "toccata/shapes/segment.hpp"
#include "toccata/shapes/triangle.hpp"

namespace toccata {

/// A plane between two Voronoi regions: all x with normal · x = offset, in the shape's own frame and units. Rounded;
/// signs that matter are decided from the vertices.
struct RegionPlane {
  Vec3 normal;  ///< unit
  double offset = 0;
};

/// One plane that bounds a region, and on which side the region lies.
struct RegionBound {
  enum class Kind : std::uint8_t {
    vertex_edge,  ///< between a vertex and an edge at it
    edge_face,    ///< between an edge and a face at it
    face,         ///< the plane of the face itself: in front of it
  } kind = Kind::vertex_edge;
  Index index = 0;    ///< of a half-edge; of `face`, of the face
  bool ahead = true;  ///< the region lies where normal · x > offset, else where it is not more
  RegionPlane plane{};
};

/// The Voronoi regions of a convex polytope: each vertex, edge and face has the region of those points outside that are
/// nearer to it than to any other feature. They are what M. Lin and J. Canny ("A Fast Algorithm for Incremental
/// Distance Calculation", 1991) and B. Mirtich ("V-Clip", 1998) walk through.
///
/// Two kinds of planes bound them all, and each is stored once for the two regions beside it: across every edge at
/// either of its ends (vertex–edge), and through every edge, at right angles to each of its faces (edge–face). A point
/// in a plane belongs to the lower feature: the nearest point of a convex set is unique, and the region is that of the
/// feature which has it in its relative interior. The points of the shape itself belong to the feature they lie on;
/// inner points to none.
///
/// Everything is in the shape's own frame, and stays true under any pose that keeps angles. Shared and immutable.
class VoronoiRegions {
 public:
  explicit VoronoiRegions(const Point& shape);
  explicit VoronoiRegions(const Segment& shape);
  explicit VoronoiRegions(const Triangle& shape);
  explicit VoronoiRegions(const Box& shape);
  explicit VoronoiRegions(const ConvexHull& shape);

  /// 0: a point, 1: a segment, 2: a flat polygon, of which one face is the front and one the back, 3: a solid.
  [[nodiscard]] int dimension() const;
  /// Features are numbered by it; an edge is named by the lesser of its two half-edges.
  [[nodiscard]] const HullTopology& topology() const;
  [[nodiscard]] Index vertex_count() const;
  [[nodiscard]] Vec3 vertex(Index i) const;

  /// All features: vertices, edges, then faces. A corner of a triangle that lies between the others is none.
  [[nodiscard]] std::vector<ConvexFeature> features() const;

  /// Through the vertex at which a half-edge starts, its normal along the edge: behind it the vertex is nearer.
  [[nodiscard]] RegionPlane vertex_edge_plane(Index half_edge) const;
  /// Through a half-edge, its normal in the plane of its face, into the face: behind it the edge is nearer. Of a
  /// segment there is none.
  [[nodiscard]] RegionPlane edge_face_plane(Index half_edge) const;
  /// Of a face, the normal outwards.
  [[nodiscard]] RegionPlane face_plane(Index face) const;

  /// The planes around a region.
  [[nodiscard]] std::vector<RegionBound> bounds(const ConvexFeature& feature) const;

  /// Whether a point, in the shape's own frame, lies in a region. Exact.
  [[nodiscard]] bool contains(const ConvexFeature& feature, const Vec3& point) const;

  /// The feature in whose region a point lies, or nothing inside a solid. Exact. Walks from `start`, a feature the
  /// point is likely to be near, from region to region through planes the point is beyond; each step is to a feature
  /// strictly nearer, so that it ends. Throws Error when the point is not finite.
  [[nodiscard]] std::optional<ConvexFeature> region_of(const Vec3& point, const ConvexFeature& start) const;
  [[nodiscard]] std::optional<ConvexFeature> region_of(const Vec3& point) const;

  /// Bytes that the planes take, without the hull.
  [[nodiscard]] std::size_t memory() const;

  struct Parts;
  /// For the walk.
  [[nodiscard]] const Parts& parts() const { return *parts_; }

 private:
  std::shared_ptr<const Parts> parts_;
};

}  // namespace toccata
