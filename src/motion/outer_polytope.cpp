#include "motion/outer_polytope.hpp"

#include <algorithm>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"
#include "toccata/math/trigonometry.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {
namespace {

constexpr int corners_of_circle = 32;
constexpr int latitudes = 12;
constexpr double margin = 1 + 0x1p-20;  ///< of what is computed here, far more than its roundings

/// A regular polygon around the unit circle: its sides are at the distance cos(1/2 · turn / corners) from the centre.
OuterPolytope around_axis(double top) {
  OuterPolytope outer;
  outer.stretch = margin / sine_cosine_of_turns(0.5 / corners_of_circle).cosine;
  for (int i = 0; i < corners_of_circle; ++i) {
    const SineCosine at = sine_cosine_of_turns(static_cast<double>(i) / corners_of_circle);
    const double x = outer.stretch * at.cosine, y = outer.stretch * at.sine;
    outer.corners.push_back({x, y, -1});
    if (top > 0) outer.corners.push_back({x, y, 1});
  }
  if (top == 0) outer.corners.push_back({0, 0, 1});
  return outer;
}

/// Points of the unit sphere, on circles of latitude that are turned against each other, and the poles.
std::vector<Vec3> points_of_sphere() {
  std::vector<Vec3> points{{0, 0, 1}, {0, 0, -1}};
  for (int i = 1; i < latitudes; ++i) {
    const SineCosine latitude = sine_cosine_of_turns(0.5 * i / latitudes);
    for (int j = 0; j < 2 * latitudes; ++j) {
      const SineCosine longitude = sine_cosine_of_turns((2 * j + i % 2) / (4.0 * latitudes));
      points.push_back({latitude.sine * longitude.cosine, latitude.sine * longitude.sine, latitude.cosine});
    }
  }
  return points;
}

double distance_of_nearest_face(const ConvexHull& hull) {
  const HullTopology topology = hull.topology();
  double nearest = 1;
  for (Index face = 0; face < topology.face_count(); ++face) {
    const Index first = topology.face_start[face];
    const auto corner = [&](Index i) { return hull.vertex(topology.origin[first + i]); };
    const Vec3 normal = plain_unit_or_zero(cross(corner(1) - corner(0), corner(2) - corner(0)));
    nearest = std::min(nearest, dot(normal, corner(0)));
  }
  return nearest;
}

/// A polytope within the unit sphere, grown until its nearest face is as far away as the sphere.
OuterPolytope around_sphere() {
  OuterPolytope outer{points_of_sphere()};
  outer.stretch = margin / distance_of_nearest_face(ConvexHull(outer.corners));
  for (Vec3& corner : outer.corners) corner = outer.stretch * corner;
  outer.stretch *= margin;
  return outer;
}

}  // namespace

OuterPolytope outer_polytope(const PosedQuadric& quadric) {
  OuterPolytope outer = with_kind(quadric.kind(), []<class Kind>(Kind) {
    if constexpr (AxialKind<Kind>)
      return around_axis(Kind::has_tip ? 0 : 1);
    else
      return around_sphere();
  });
  const Vec3& half = quadric.half();
  for (Vec3& p : outer.corners) p = {half.x * p.x, half.y * p.y, half.z * p.z};
  return outer;
}

}  // namespace toccata
