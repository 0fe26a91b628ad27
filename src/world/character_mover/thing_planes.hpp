#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <variant>

#include "math/vec3_measures.hpp"
#include "query/posed_shape.hpp"

namespace toccata {

/// A convex thing of the level: an object, a part of one, or a triangle of it.
using LevelSet = std::variant<PosedPolytope, PosedHalfSpace, PosedQuadric>;

/// The planes of the faces of a small polytope, of a triangle those through its edges too, and that of a half-space: it
/// lies below all of them.
struct ThingPlanes {
  struct Plane {
    Vec3 normal;     ///< unit
    double top = 0;  ///< no vertex is higher along it, but for rounding
  };
  static constexpr std::size_t most = 8;

  std::array<Plane, most> planes{};
  std::size_t count = 0;  ///< 0: of other sets, and of what is flat or nearly so
  double extent = 0;      ///< the greatest coordinate
  double radius = 0;      ///< of a ball by which the polytope is grown
  /// The planes are those of a triangle: the first two are those of its face, and the others at right angles to them.
  bool is_triangle = false;
};

/// The planes of a triangle's face, which take a fifth of the time that all of them do.
struct TriangleFace {
  ThingPlanes::Plane upper, lower;
  double extent = 0;     ///< the greatest coordinate
  bool is_told = false;  ///< no: the triangle is flat to a line, or nearly so
};
[[nodiscard]] TriangleFace face_of(const Triangle& triangle);

[[nodiscard]] ThingPlanes planes_of(const LevelSet& set);
/// The same of the triangle as a set.
[[nodiscard]] ThingPlanes planes_of(const Triangle& triangle);
[[nodiscard]] ThingPlanes planes_of(const Triangle& triangle, const TriangleFace& face);

/// The vertices of a polytope of at most eight; of others none.
struct FewCorners {
  std::array<Vec3, 8> corners{};
  std::size_t count = 0;
  double extent = 0;  ///< the greatest coordinate

  void add(const Vec3& corner) {
    corners[count++] = corner;
    extent = std::max(extent, largest_magnitude(corner));
  }
  [[nodiscard]] double lowest_along(const Vec3& direction) const {
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
      const double height = dot(direction, corners[i]);
      if (height < lowest) lowest = height;
    }
    return lowest;
  }
};

/// How far a polytope is from a thing, by the plane that separates the two the most.
struct PlaneGap {
  double distance = 0;    ///< no more than the true one, of the two without radii; −∞ where nothing is known
  Vec3 normal{};          ///< of that plane
  bool is_exact = false;  ///< it is the distance but for rounding: a lowest vertex is over the face
  Vec3 foot{};            ///< then, where on it
};

/// More than a height along a unit normal, and the difference of two, is off by for coordinates no greater than 1: 4
/// roundings of sums of three products, and a normal whose length is off by 2.
inline constexpr double height_error = 0x1p-48;

/// What heights along unit vectors may be off by, of things whose coordinates are no greater.
[[nodiscard]] inline double height_slack(double extent_above, double extent_below) {
  return height_error * std::max(extent_above, extent_below);
}
[[nodiscard]] double height_slack(const FewCorners& above, const ThingPlanes& planes);

/// By the best plane.
[[nodiscard]] PlaneGap plane_gap(const FewCorners& above, const ThingPlanes& planes);

}  // namespace toccata
