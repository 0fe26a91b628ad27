#pragma once

#include <array>
#include <vector>

#include <boost/multiprecision/gmp.hpp>

#include "toccata/math/pose.hpp"

// The truth about cylinders, cones and ellipsoids: 60 digits, slowly, and nothing of the library but the plain structs
// that hold its input.
namespace toccata::oracle {

using Fine = boost::multiprecision::number<boost::multiprecision::gmp_float<60>, boost::multiprecision::et_off>;

struct FinePoint {
  Fine x, y, z;
};

enum class FineKind { ellipsoid, cylinder, cone, hull };

/// A convex set: the image of a quadric, or a hull grown by a radius.
struct FineSet {
  FineKind kind = FineKind::hull;
  std::array<FinePoint, 3> axis;  ///< images of the half axes; of the radius twice and the half height
  FinePoint centre;
  std::vector<FinePoint> vertices;
  Fine radius = 0;
};

/// `half`: the half axes; of a cylinder and a cone (tip at +z) the radius twice, and the half height.
FineSet quadric_set(FineKind kind, const Vec3& half, const Pose& pose);
FineSet hull_set_of(const std::vector<Vec3>& world_vertices, double radius);

/// Some point of the set that is the farthest along a direction that is not zero.
FinePoint farthest(const FineSet& set, const FinePoint& direction);

/// The distance of two sets lies in [lower, upper]. When `meet`, a tetrahedron of points of A − B has the origin
/// inside, at least `depth` from its faces; then so deep they overlap at least.
struct FineNearness {
  Fine lower = 0;
  Fine upper = 0;
  Fine depth = 0;
  bool meet = false;
  FinePoint direction;  ///< that of the lower bound
};

/// By the search for the nearest point of A − B (GJK), which is exact but for 60 digits in what it proves: ends when
/// upper − lower is below `part` of upper, when the origin is inside, or after `most` steps.
FineNearness fine_nearness(const FineSet& a, const FineSet& b, double part, int most);

}  // namespace toccata::oracle
