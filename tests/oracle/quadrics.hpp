#pragma once

#include <array>
#include <vector>

#include <boost/container/static_vector.hpp>
#include <boost/multiprecision/gmp.hpp>

#include "toccata/math/pose.hpp"

// The truth about cylinders, cones and ellipsoids: 60 digits, slowly, and nothing of the library but the plain structs
// that hold its input.
namespace toccata::oracle {

using Fine = boost::multiprecision::number<boost::multiprecision::gmp_float<60>, boost::multiprecision::et_off>;

template <class Number>
struct PointOf {
  Number x, y, z;
};

enum class FineKind { ellipsoid, cylinder, cone, hull };

/// A convex set: the image of a quadric, or a hull grown by a radius.
template <class Number>
struct SetOf {
  FineKind kind = FineKind::hull;
  std::array<PointOf<Number>, 3> axis{};  ///< images of the half axes; of the radius twice and the half height
  PointOf<Number> centre{};
  std::vector<PointOf<Number>> vertices;
  Number radius = 0;
};

using FinePoint = PointOf<Fine>;
using FineSet = SetOf<Fine>;

/// `half`: the half axes; of a cylinder and a cone (tip at +z) the radius twice, and the half height.
FineSet quadric_set(FineKind kind, const Vec3& half, const Pose& pose);
FineSet hull_set_of(const std::vector<Vec3>& world_vertices, double radius);

// What follows is there for `Fine` and for `long double`: in these no yes is proved, but what is apart by far more than
// their rounding is seen sooner.

/// Some point of the set that is the farthest along a direction that is not zero.
template <class Number>
PointOf<Number> farthest(const SetOf<Number>& set, const PointOf<Number>& direction);

/// As many points as a simplex has corners.
template <class Number>
using SimplexOf = boost::container::static_vector<PointOf<Number>, 4>;

/// The distance of two sets lies in [lower, upper]. When `meet`, a tetrahedron of points of A − B has the origin
/// inside, at least `depth` from its faces; then so deep they overlap at least.
template <class Number>
struct NearnessOf {
  Number lower = 0;
  Number upper = 0;
  Number depth = 0;
  bool meet = false;
  PointOf<Number> direction{};  ///< that of the lower bound, from B to A
  SimplexOf<Number> around;     ///< that tetrahedron
};
using FineNearness = NearnessOf<Fine>;

/// By the search for the nearest point of A − B (GJK), which is exact but for the rounding of its numbers in what it
/// proves: ends when upper − lower is below `part` of upper, when the origin is inside, or after `most` steps. Where it
/// begins is a guess of the direction from B to A.
template <class Number>
NearnessOf<Number> fine_nearness(const SetOf<Number>& a, const SetOf<Number>& b, double part, int most,
                                 PointOf<Number> direction = {Number(1), Number(0), Number(0)});

}  // namespace toccata::oracle
