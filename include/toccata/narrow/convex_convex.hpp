#pragma once

#include <array>
#include <cstdint>

#include "toccata/core/index.hpp"
#include "toccata/core/status.hpp"
#include "toccata/narrow/posed_polytope.hpp"

// Two bounded convex shapes, whichever they are. Everything is in world coordinates and units.
namespace toccata {

/// How two sets lie (docs/truth.md). Solids: apart, touching, overlapping. A surface involved: apart, touching,
/// crossing.
enum class RelationKind { apart, touching, overlapping, crossing };

/// For overlapping solids, whether one contains the other; for a surface crossing a solid, whether all of it is inside.
enum class Containment { none, a_in_b, b_in_a, equal };

struct Relation {
  RelationKind kind = RelationKind::apart;
  Containment containment = Containment::none;
  /// Two surfaces touch without any pair of faces crossing, so the faces alone do not show whether they pass through
  /// each other. Callers that ignore touching must still count this.
  bool side_unresolved = false;
  bool a_solid = false;  ///< what each shape was taken for
  bool b_solid = false;
  Status status = Status::exact;
  friend constexpr bool operator==(const Relation&, const Relation&) = default;
};

/// Which path answered. Answers never depend on it.
struct ConvexCounts {
  std::uint64_t steps = 0;           ///< steps of searches by GJK
  std::uint64_t support_points = 0;  ///< searched for, over both shapes
  std::uint64_t heights = 0;         ///< heights of vertices along a direction, computed to find these points, and for
                                     ///< proofs
  std::uint64_t closed_forms = 0;    ///< answered by a formula for the pair
  std::uint64_t certificates = 0;    ///< answered by a verified separating direction, simplex or interval
  std::uint64_t exact = 0;           ///< answered by exact arithmetic, because nothing cheaper verified
  friend constexpr bool operator==(const ConvexCounts&, const ConvexCounts&) = default;
};

/// What a caller may keep of a pair from one question to the next: where the last search ended. It saves time when the
/// shapes have moved little, and changes no answer. One thread may use it at a time.
struct SimplexCache {
  Vec3 direction{};  ///< from A to B; zero: nothing is known
  std::array<Index, 4> vertex_a{};
  std::array<Index, 4> vertex_b{};
  int simplex_size = 0;
  Index element_a = 0;  ///< for models of more than one element: the nearest
  Index element_b = 0;
  ConvexCounts counts{};  ///< of all questions asked with it
};

/// A certified distance: the exact one lies in [lower, upper], and upper − lower is at most 10⁻¹² · upper, or they are
/// neighbouring doubles. Both are 0 when the shapes meet; upper is positive when they are apart, and so is lower unless
/// the exact distance is below all positive doubles. The same bits whatever a workspace knows and at every SIMD level;
/// exchanging the shapes exchanges the points, unless even their cores, the shapes without their radii, meet.
struct Distance {
  double lower = 0;
  double upper = 0;
  /// Points of the shapes at that distance; where several pairs are at that distance, the one whose `on_a` is the least
  /// in lexicographic order. When the shapes meet, a point of both. Each is off from the exact one by at most 10⁻¹²
  /// times the greatest magnitude of a coordinate of either shape in the world, the radius included.
  Vec3 on_a{};
  Vec3 on_b{};
  Status status = Status::exact;
  Index element_a = 0;  ///< which element of a model of more than one (see Model), such as triangles
  Index element_b = 0;
  Index face_a = 0;  ///< the file's own face, counted from 0
  Index face_b = 0;
  friend constexpr bool operator==(const Distance&, const Distance&) = default;
};

/// Do they have a point in common? Touching counts. Exact.
[[nodiscard]] bool overlap(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace = nullptr);

[[nodiscard]] Distance distance(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace = nullptr);

/// Exact, with containment.
[[nodiscard]] Relation relation(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace = nullptr);

/// The shortest way to part two solids that meet.
struct Penetration {
  /// The exact depth, the length of the shortest translation after which the interiors do not meet, lies in
  /// [lower, upper]. Both 0 when the shapes are apart or touch; one that rounding has flattened in the world can only
  /// touch.
  double lower = 0;
  double upper = 0;
  /// Unit, from A to B: B moved by upper · direction, or A by −upper · direction, no longer overlaps.
  Vec3 direction{};
  /// The deepest points along the direction: on_a on the boundary of A within B, on_b on that of B within A.
  Vec3 on_a{};
  Vec3 on_b{};
  Status status = Status::exact;
  friend constexpr bool operator==(const Penetration&, const Penetration&) = default;
};

/// Throws Error when one is a surface: it has no interior that another could leave.
[[nodiscard]] Penetration penetration(const PosedPolytope& a, const PosedPolytope& b,
                                      SimplexCache* workspace = nullptr);

/// A feature of a convex shape: a face, a half-edge or a vertex by its number in `HullTopology`.
struct ConvexFeature {
  enum class Kind : std::uint8_t { vertex, edge, face } kind = Kind::vertex;
  Index index = 0;
  friend constexpr bool operator==(const ConvexFeature&, const ConvexFeature&) = default;
};

struct ManifoldPoint {
  Vec3 position;       ///< half way between the two surfaces
  double depth = 0;    ///< how deep the surfaces overlap there along the normal; negative: a gap
  ConvexFeature on_a;  ///< which features meet here; the same from step to step while the contact lasts
  ConvexFeature on_b;
  friend constexpr bool operator==(const ManifoldPoint&, const ManifoldPoint&) = default;
};

/// Where two convex shapes touch or overlap: up to four points that stand for the region of contact.
struct Manifold {
  Vec3 normal{};  ///< unit, from A to B
  std::array<ManifoldPoint, 4> points{};
  int count = 0;  ///< 0: the shapes are apart
  friend constexpr bool operator==(const Manifold&, const Manifold&) = default;
};

/// Empty exactly when the shapes are apart.
[[nodiscard]] Manifold manifold(const PosedPolytope& a, const PosedPolytope& b, SimplexCache* workspace = nullptr);

}  // namespace toccata

// The ways to the penetration of two convex shapes, each for itself. `penetration` chooses among them; they agree in
// what they promise, and each is a test of the others. All throw Error when one of the shapes is a surface.
namespace toccata {

/// Finds the penetration by expanding a polytope within the Minkowski difference of the cores (G. van den Bergen,
/// "Proximity queries and penetration depth computation on 3D game objects", 2001), with exact signs: for shapes of any
/// size. The width of [lower, upper] is at most 2^-40 · upper.
[[nodiscard]] Penetration penetration_by_expansion(const PosedPolytope& a, const PosedPolytope& b);

/// Do they have a point in common? By separating axes of polyhedra: the normals of the faces of both, and the cross
/// products of those pairs of edges whose arcs cross on the Gauss map (D. Gregorius, "The Separating Axis Test between
/// Convex Polyhedra", 2013; of two boxes the fifteen axes of S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree", 1996).
/// Exact: where the rounded axes leave a doubt, and about radii, `overlap` decides. The axis kept in the workspace is
/// tried first. The cost grows with the product of the numbers of edges.
[[nodiscard]] bool overlap_by_separating_axes(const PosedPolytope& a, const PosedPolytope& b,
                                              SimplexCache* workspace = nullptr);

/// Penetration as the least overlap along one of these axes, without iteration. [lower, upper] is as narrow as that of
/// `penetration_by_expansion`, which takes over where rounding makes the axes' bracket wider. Throws Error when one of
/// the shapes is a surface.
[[nodiscard]] Penetration penetration_by_separating_axes(const PosedPolytope& a, const PosedPolytope& b);

}  // namespace toccata

// The search of E. G. Gilbert, D. W. Johnson, S. S. Keerthi, "A fast procedure for computing the distance between
// complex objects in three-dimensional space", 1988, for itself: without formulas for single pairs of kinds, and in the
// manner that is asked for. `distance` and `overlap` choose the manner themselves.
namespace toccata {

/// How the vertex that is the farthest along a direction is found.
enum class GjkSupport : std::uint8_t {
  automatic,      ///< the faster of the two for so many vertices, as measured
  scan,           ///< all vertices are looked at, with vector instructions
  hill_climbing,  ///< on a hull along edges to ever farther neighbours, from the last vertex found; others are scanned
};

/// Whether the search aims along the nearest point so far, or farther ahead.
enum class GjkAcceleration : std::uint8_t {
  none,
  /// With momentum, after L. Montaut, Q. Le Lidec, V. Petrik, J. Sivic, J. Carpentier, "Collision Detection
  /// Accelerated: An Optimization Perspective", 2022. Goes on without where it stalls.
  nesterov,
};

struct GjkOptions {
  GjkSupport support = GjkSupport::automatic;
  GjkAcceleration acceleration = GjkAcceleration::none;
};

/// What `overlap` and `distance` promise, holds here too; where these use a formula for the pair, other numbers of the
/// same interval may be answered. Every bit of the answers is the same whatever the options are; the counts of the
/// workspace show what they save: `steps` and `heights`.
[[nodiscard]] bool overlap_by_gjk(const PosedPolytope& a, const PosedPolytope& b, const GjkOptions& options = {},
                                  SimplexCache* workspace = nullptr);
[[nodiscard]] Distance distance_by_gjk(const PosedPolytope& a, const PosedPolytope& b, const GjkOptions& options = {},
                                       SimplexCache* workspace = nullptr);

}  // namespace toccata

// Answers about (A, B) as the answers about (B, A).
namespace toccata {

[[nodiscard]] constexpr bool flipped(bool overlap) { return overlap; }

[[nodiscard]] constexpr Containment flipped(Containment containment) {
  if (containment == Containment::a_in_b) return Containment::b_in_a;
  if (containment == Containment::b_in_a) return Containment::a_in_b;
  return containment;
}

[[nodiscard]] constexpr Relation flipped(Relation r) {
  return {r.kind, flipped(r.containment), r.side_unresolved, r.b_solid, r.a_solid, r.status};
}

[[nodiscard]] constexpr Distance flipped(const Distance& d) {
  return {d.lower, d.upper, d.on_b, d.on_a, d.status, d.element_b, d.element_a, d.face_b, d.face_a};
}

[[nodiscard]] constexpr Penetration flipped(const Penetration& p) {
  return {p.lower, p.upper, -p.direction, p.on_b, p.on_a, p.status};
}

[[nodiscard]] constexpr Manifold flipped(Manifold m) {
  m.normal = -m.normal;
  for (ManifoldPoint& point : m.points) point = {point.position, point.depth, point.on_b, point.on_a};
  return m;
}

}  // namespace toccata

// A half-space and a bounded convex shape, or two half-spaces.
namespace toccata {

/// A half-space at its place: all world points p with (p − point) · normal ≤ 0, for the world point and the rotated
/// normal as rounded (docs/truth.md).
struct PosedHalfSpace {
  Vec3 point;
  Vec3 normal;

  /// Throws Error when the pose is not finite or deforms (as for a sphere), or a rounded number is not finite, or the
  /// normal becomes zero.
  explicit PosedHalfSpace(const HalfSpace& shape, const Pose& pose = {});
};

[[nodiscard]] bool overlap(const PosedPolytope& a, const PosedHalfSpace& b);
[[nodiscard]] bool overlap(const PosedHalfSpace& a, const PosedHalfSpace& b);

[[nodiscard]] Distance distance(const PosedPolytope& a, const PosedHalfSpace& b);
[[nodiscard]] Distance distance(const PosedHalfSpace& a, const PosedHalfSpace& b);

[[nodiscard]] Relation relation(const PosedPolytope& a, const PosedHalfSpace& b);
[[nodiscard]] Relation relation(const PosedHalfSpace& a, const PosedHalfSpace& b);

/// Throws Error when the convex shape is a surface.
[[nodiscard]] Penetration penetration(const PosedPolytope& a, const PosedHalfSpace& b);

[[nodiscard]] Manifold manifold(const PosedPolytope& a, const PosedHalfSpace& b);

}  // namespace toccata
