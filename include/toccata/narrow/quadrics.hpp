#pragma once

#include <cstdint>
#include <string_view>

#include "toccata/core/status.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/narrow/casts.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// A cylinder, a cone or an ellipsoid at its place: the image of the shape under its pose taken as real numbers, which
/// need not be rigid (docs/truth.md, "quadric").
class PosedQuadric {
 public:
  /// The place in QuadricShapes.
  enum class Kind : std::uint8_t {};
  template <QuadricShape S>
  static constexpr Kind kind_of = static_cast<Kind>(QuadricShapes::place_of<S>());

  /// Throws Error when the pose is not finite or singular, or the shape reaches beyond the finite doubles.
  template <QuadricShape S>
  explicit PosedQuadric(const S& shape, const Pose& pose = {})
      : PosedQuadric(kind_of<S>, shape.half_axes(), pose, S::name) {}

  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] const Pose& pose() const { return pose_; }
  /// The shape's `half_axes()`.
  [[nodiscard]] const Vec3& half() const { return half_; }

  /// A copy that lies elsewhere; the new place is rounded where the vector is not a step of its last place.
  [[nodiscard]] PosedQuadric moved(const Vec3& by) const;

  friend bool operator==(const PosedQuadric&, const PosedQuadric&) = default;

 private:
  PosedQuadric(Kind kind, const Vec3& half, const Pose& pose, std::string_view name);

  Kind kind_;
  Vec3 half_;
  Pose pose_;
};

}  // namespace toccata

// Cylinders, cones and ellipsoids (affine images included) against each other, every bounded convex shape, and
// half-spaces. Everything is in world coordinates and units, and about the real image of the shape.
namespace toccata {

/// Apart and contact are proved. Undecided: the sets meet, or lie within 10⁻¹² of the size of the quadric of
/// touching (of two, of the larger; docs/truth.md): its depth or its gap is no larger. It counts as contact. What
/// touches exactly is in contact where exact signs find a point of doubles in both, as along the axes. Against
/// half-spaces nothing is undecided: all their answers are exact in what they say of touching, and of lying within.
enum class QuadricContact : std::uint8_t { apart, contact, undecided };

[[nodiscard]] QuadricContact quadric_contact(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] QuadricContact quadric_contact(const PosedQuadric& a, const PosedPolytope& b);
[[nodiscard]] QuadricContact quadric_contact(const PosedPolytope& a, const PosedQuadric& b);
[[nodiscard]] QuadricContact quadric_contact(const PosedQuadric& a, const PosedHalfSpace& b);
[[nodiscard]] QuadricContact quadric_contact(const PosedHalfSpace& a, const PosedQuadric& b);

// Do they have a point in common? Touching counts, and what is undecided.
[[nodiscard]] bool overlap(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] bool overlap(const PosedQuadric& a, const PosedPolytope& b);
[[nodiscard]] bool overlap(const PosedPolytope& a, const PosedQuadric& b);
[[nodiscard]] bool overlap(const PosedQuadric& a, const PosedHalfSpace& b);
[[nodiscard]] bool overlap(const PosedHalfSpace& a, const PosedQuadric& b);

// The exact distance lies in [lower, upper]; on_a and on_b are points of the shapes, rounded, that are no farther apart
// than upper. Status:
//   exact          apart, upper − lower at most 10⁻¹² · upper; or 0 and 0, as the shapes certainly meet
//   undecided      see QuadricContact; lower is 0
//   not_converged  the interval holds, but is wider
// Exchanging the shapes exchanges the points and changes no other bit.
[[nodiscard]] Distance distance(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] Distance distance(const PosedQuadric& a, const PosedPolytope& b);
[[nodiscard]] Distance distance(const PosedPolytope& a, const PosedQuadric& b);
[[nodiscard]] Distance distance(const PosedQuadric& a, const PosedHalfSpace& b);
[[nodiscard]] Distance distance(const PosedHalfSpace& a, const PosedQuadric& b);

}  // namespace toccata

// Where points lie to cylinders, cones and ellipsoids, all affine images included. World coordinates and units; the
// point is finite.
namespace toccata {

/// Negative in the interior, zero on the boundary, positive outside. Exact.
[[nodiscard]] Sign side_of(const Vec3& point, const PosedQuadric& shape);

/// The point of a shape's boundary that is nearest to a given one.
struct BoundaryPoint {
  Sign side = Sign::positive;  ///< as `side_of`
  /// The exact distance lies in [lower, upper]. Both are 0 exactly on the boundary.
  double lower = 0;
  double upper = 0;
  Vec3 point{};  ///< rounded; of several that are as near one
  /// exact: upper − lower is at most 10⁻¹² · upper. not_converged: it is more, as within some 10⁻¹⁵ of the size of the
  /// shape from its boundary, and of shapes that are nearly flat.
  Status status = Status::exact;
  friend bool operator==(const BoundaryPoint&, const BoundaryPoint&) = default;
};

/// Also from within.
[[nodiscard]] BoundaryPoint boundary_point(const Vec3& point, const PosedQuadric& shape);

}  // namespace toccata

// Where cylinders, cones and ellipsoids touch or overlap other convex shapes.
namespace toccata {

// Empty exactly when the shapes are apart (`quadric_contact`). The normal is the direction of the penetration, which is
// found for surfaces too, or of touching. Along it each shape has a face, a line or a point: a face where one turns to
// the normal within two degrees (a cap, a polygon), a line where one lies across it as closely (an edge, a line of a
// round side), else the farthest point. The points are up to four of what the two have in common when seen along the
// normal, a gap of 2⁻¹⁰ of its extent included: the deepest first, then such that they span it. A face and a face have
// up to four (a standing cylinder: four points of its rim), a line with a line along it or with a face two (a lying
// cylinder), everything else one.
//
// Each position is half way between a point of A and one of B that are |depth| apart along the normal; both are off
// from their shapes by at most 10⁻¹¹ of the size of the pair (of the quadric, and how far the other reaches from
// its middle), and mostly by 10⁻¹⁵. No point is deeper than the shapes are along the normal, and the first is as deep
// as that, but for 2⁻²⁰ of it.
//
// The features of a quadric, for `ConvexFeature`:
//   cylinder   face 0 the cap at −z, 1 that at +z, 2 the side; edges 0 to 3 the quarters of the rim at −z, from the
//              local +x on to +y, 4 to 7 those of the rim at +z
//   cone       face 0 the cap, 1 the side; edges 0 to 3 the quarters of the rim; vertex 0 the tip
//   ellipsoid  face 0
//
// Exchanging the shapes turns the normal round, exchanges the features and changes no other bit. For two equal shapes
// at one place both orders are the same question, and have the same answer.
[[nodiscard]] Manifold manifold(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] Manifold manifold(const PosedQuadric& a, const PosedPolytope& b);
[[nodiscard]] Manifold manifold(const PosedPolytope& a, const PosedQuadric& b);
[[nodiscard]] Manifold manifold(const PosedQuadric& a, const PosedHalfSpace& b);
[[nodiscard]] Manifold manifold(const PosedHalfSpace& a, const PosedQuadric& b);

}  // namespace toccata

// How cylinders, cones and ellipsoids lie to other convex shapes, and how far they overlap.
namespace toccata {

// Apart and overlapping (crossing: a surface) are proved, and containment. Touching is exact where a point of doubles
// in both and a plane between them prove it, as along the axes, and against half-spaces; else it has the status
// undecided, and stands for what QuadricContact calls so, or for a contact without such a plane. For two that overlap,
// undecided says: within 10⁻¹² of the size of one holding the other; not_converged: a search ended, near a capsule or a
// rounded shape. Containment is none then.
[[nodiscard]] Relation relation(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] Relation relation(const PosedQuadric& a, const PosedPolytope& b);
[[nodiscard]] Relation relation(const PosedPolytope& a, const PosedQuadric& b);
[[nodiscard]] Relation relation(const PosedQuadric& a, const PosedHalfSpace& b);
[[nodiscard]] Relation relation(const PosedHalfSpace& a, const PosedQuadric& b);

// The exact depth lies in [lower, upper]: both ends are proved, upper by the plane that is left between the shapes when
// B has moved by upper · direction, lower by a polytope, round at its corners, within the Minkowski difference. The
// status is exact where upper − lower is at most 10⁻¹² · upper, as it mostly is, else not_converged: where the depth is
// less than 10⁻⁴ of the size, rounding of the direction alone may be more; and where the shapes are as deep in ever so
// many directions (balls around one centre, bars along one axis), lower is at least 0.9 · upper. A depth below 10⁻¹² of
// the size may have the lower end 0. Both are 0 when the shapes are apart; when touching is exact, with the normal of
// the plane between them for direction; and, with the status undecided, within the bound of touching. Throws Error when
// one is a surface.
[[nodiscard]] Penetration penetration(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] Penetration penetration(const PosedQuadric& a, const PosedPolytope& b);
[[nodiscard]] Penetration penetration(const PosedPolytope& a, const PosedQuadric& b);
/// The bracket is as narrow as that of a distance.
[[nodiscard]] Penetration penetration(const PosedQuadric& a, const PosedHalfSpace& b);
[[nodiscard]] Penetration penetration(const PosedHalfSpace& a, const PosedQuadric& b);

}  // namespace toccata

// Straight casts at and of cylinders, cones and ellipsoids.
namespace toccata {

// The exact first time in [0, 1] lies in [lower, upper]; a miss is proved. Status: exact, when upper − lower is at most
// 2⁻⁴⁰ and both ends are proved; undecided, when the way grazes and whether they meet could not be proved: a
// hit is told then, and [lower, upper] is where they would; not_converged, when the interval holds but is wider. A ray
// goes from `origin` to `origin + motion`; of two shapes A moves and B stands. Throws Error when a number is not
// finite, or the motion of a ray is zero.
[[nodiscard]] std::optional<Cast> cast_ray(const Vec3& origin, const Vec3& motion, const PosedQuadric& target);

[[nodiscard]] std::optional<Cast> cast_shape(const PosedQuadric& a, const Vec3& motion, const PosedQuadric& b);
[[nodiscard]] std::optional<Cast> cast_shape(const PosedQuadric& a, const Vec3& motion, const PosedPolytope& b);
[[nodiscard]] std::optional<Cast> cast_shape(const PosedPolytope& a, const Vec3& motion, const PosedQuadric& b);
[[nodiscard]] std::optional<Cast> cast_shape(const PosedQuadric& a, const Vec3& motion, const PosedHalfSpace& b);
[[nodiscard]] std::optional<Cast> cast_shape(const PosedHalfSpace& a, const Vec3& motion, const PosedQuadric& b);

}  // namespace toccata
