#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/shapes/convex_hull.hpp"
#include "toccata/shapes/primitives.hpp"

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
  Index index = 0;    ///< the number of a half-edge; for `face`, that of the face
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

  /// The plane through the vertex at which a half-edge starts, its normal along the edge: behind it the vertex is
  /// nearer.
  [[nodiscard]] RegionPlane vertex_edge_plane(Index half_edge) const;
  /// The plane through a half-edge, its normal in the plane of its face, into the face: behind it the edge is nearer. A
  /// segment has none.
  [[nodiscard]] RegionPlane edge_face_plane(Index half_edge) const;
  /// The plane of a face, its normal outwards.
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

/// How questions about a tracked pair were answered.
struct VoronoiCounts {
  std::uint64_t questions = 0;
  std::uint64_t kept = 0;      ///< questions for which the features of the time before were still the nearest
  std::uint64_t walked = 0;    ///< others, or the first, were found by walking
  std::uint64_t searched = 0;  ///< rounding left a doubt, or the cores meet: by GJK
  std::uint64_t steps = 0;     ///< from region to region
  friend constexpr bool operator==(const VoronoiCounts&, const VoronoiCounts&) = default;
};

/// Two convex shapes that move, and what the caller keeps of them from one question to the next: the last nearest
/// features. Anything may be in it; it saves time and changes no answer. One thread may use it at a time.
struct TrackedPair {
  ConvexFeature on_a{};
  ConvexFeature on_b{};
  enum class State : std::uint8_t {
    unknown,  ///< never asked: the first walk begins at the vertices that face each other
    apart,    ///< at the last question
    meeting,  ///< at the last question the shapes met; the features are what is known
  } state = State::unknown;
  bool cores_meet = false;  ///< at the last question, the shapes without their radii
  SimplexCache workspace{};
  VoronoiCounts counts{};
};

/// Where a walk has ended.
enum class WalkEnd : std::uint8_t {
  nearest,     ///< no plane of either region is violated
  tie,         ///< one is, but beyond it nothing is nearer in doubles
  below,       ///< a feature has come to lie behind a face: the shapes seem to meet
  not_walked,  ///< the cores met at the last question, so that GJK was asked at once
};

/// A place on the way of a walk: a feature of each shape, and their nearest points, which lie inside both, as far as
/// doubles show; in the world.
struct VoronoiVisit {
  ConvexFeature on_a;
  ConvexFeature on_b;
  Vec3 point_a;
  Vec3 point_b;
  double distance_squared = 0;  ///< less at each visit than at the one before
};

/// The way of a walk, from the features it began at to those it ended at. Empty where it found itself below at once.
struct VoronoiPath {
  std::vector<VoronoiVisit> visits{};
  WalkEnd end = WalkEnd::not_walked;
};

/// The distance by walking from one Voronoi region to the next, from the nearest features of the last question: where
/// shapes move little, a few steps lead to the present ones, however many features there are (M. Lin, J. Canny, "A Fast
/// Algorithm for Incremental Distance Calculation", 1991; B. Mirtich, "V-Clip: Fast and Robust Polyhedral Collision
/// Detection", 1998). A walk cannot loop: each step counts only if the distance falls. What it finds is proved, with
/// the planes around the features; where that fails, and where shapes penetrate, GJK takes over.
///
/// All that `distance_by_gjk` promises, bit by bit. `regions_a` and `regions_b` are those of the shapes, without radii,
/// in their own frames; throws Error where they are of another number of vertices. Regions of another shape cost a
/// search and change nothing; those of an equal hull that was built apart, a look at its vertices.
[[nodiscard]] Distance distance_by_voronoi_walk(const PosedPolytope& a, const VoronoiRegions& regions_a,
                                                const PosedPolytope& b, const VoronoiRegions& regions_b,
                                                TrackedPair& tracked);

/// The same, and reports the way, for pictures and teaching. It is walked from what is kept even where a proof would
/// have shown at once that nothing has changed; the answer is the same.
[[nodiscard]] Distance distance_by_voronoi_walk(const PosedPolytope& a, const VoronoiRegions& regions_a,
                                                const PosedPolytope& b, const VoronoiRegions& regions_b,
                                                TrackedPair& tracked, VoronoiPath& path);

}  // namespace toccata
