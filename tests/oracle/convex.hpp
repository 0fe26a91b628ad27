#pragma once

#include <span>
#include <vector>

#include "oracle/rational.hpp"

namespace toccata::oracle {

enum class RelationKind { apart, touching, overlapping, crossing };
enum class Containment { none, a_in_b, b_in_a, equal };

/// The relation of the truth page.
struct Relation {
  RelationKind kind = RelationKind::apart;
  Containment containment = Containment::none;
  bool side_unresolved = false;
  friend bool operator==(const Relation&, const Relation&) = default;
};

Relation flipped(const Relation& relation);

/// The convex hull of the vertices, grown by the ball of the radius.
struct ConvexSet {
  std::vector<RationalPoint> vertices;
  Rational radius;
};

// The exact classes of the truth page, from world vertices.
ConvexSet point_set(const Vec3& p);
ConvexSet segment_set(const Vec3& p, const Vec3& q);
ConvexSet triangle_set(const Vec3& p, const Vec3& q, const Vec3& r);
ConvexSet box_set(std::span<const Vec3> eight_corners);
ConvexSet hull_set(std::span<const Vec3> vertices);
ConvexSet sphere_set(const Vec3& centre, double radius);
ConvexSet capsule_set(const Vec3& p, const Vec3& q, double radius);
ConvexSet rounded(ConvexSet core, double radius);
HalfSpace half_space_set(const Vec3& point, const Vec3& normal);

/// Has an interior: a positive radius, or vertices that are not coplanar. What has none is a surface.
bool is_solid(const ConvexSet& set);

/// The two points in which the distance of two hulls is attained (radii left aside), and its square.
struct NearestPoints {
  RationalPoint on_a;
  RationalPoint on_b;
  Rational squared_distance;
};

/// Oracle of the nearest points of two polytopes. Proved by its own certificate: with x = on_a − on_b, no vertex pair
/// has (a − b) · x < x · x; throws std::logic_error otherwise.
NearestPoints nearest_points(const ConvexSet& a, const ConvexSet& b);
/// What the search for the nearest points proves besides them.
struct Nearness {
  Rational squared_distance;
  /// The origin lies inside of a tetrahedron of points of A − B, so no plane separates the hulls, not even weakly.
  /// Where this is false, a plane may or may not.
  bool inseparable = false;
};

Nearness nearness(const ConvexSet& a, const ConvexSet& b);
Rational squared_distance(const ConvexSet& a, const ConvexSet& b);

/// How far two sets are apart, for several questions.
class Separation {
 public:
  Separation(const ConvexSet& a, const ConvexSet& b);
  bool overlap() const { return squared_ <= radii_ * radii_; }
  /// The sign of (distance of the sets) − gap, for gap ≥ 0.
  int compare(const Rational& gap) const;

 private:
  Rational squared_;  ///< distance of the cores
  Rational radii_;
};

/// The sign of (distance of the sets) − gap; the sets are grown by their radii, gap ≥ 0. Oracle of distance intervals:
/// lower is right iff this is ≥ 0 there, upper iff ≤ 0.
int compare_distance(const ConvexSet& a, const ConvexSet& b, const Rational& gap);
int compare_distance(const ConvexSet& a, const HalfSpace& b, const Rational& gap);

/// Oracles of overlap: the closed sets have a point in common.
bool overlap(const ConvexSet& a, const ConvexSet& b);
bool overlap(const ConvexSet& a, const HalfSpace& b);
bool overlap(const HalfSpace& a, const HalfSpace& b);

/// The sets have inner points in common; false where one has none.
bool interiors_meet(const ConvexSet& a, const ConvexSet& b);

/// Oracles of relation. A flat set with radius 0 is a surface, everything else is solid.
Relation relation(const ConvexSet& a, const ConvexSet& b);
/// Where what they are taken for is known from their own frames: rounding may bend a flat hull in the world, and
/// flatten a solid.
Relation relation(const ConvexSet& a, bool a_solid, const ConvexSet& b, bool b_solid);
Relation relation(const ConvexSet& a, const HalfSpace& b);
Relation relation(const HalfSpace& a, const HalfSpace& b);

/// Oracle of `inside` for convex shapes: −1 inside, 0 on the boundary (all of a surface), 1 outside.
int side_of(const RationalPoint& p, const ConvexSet& set);

}  // namespace toccata::oracle
