#pragma once

#include <array>
#include <cstddef>
#include <variant>

#include "query/posed_shape.hpp"

namespace toccata {

/// A convex thing of the level: an object, a part of one, or a triangle of it.
using LevelSet = std::variant<PosedPolytope, PosedHalfSpace, PosedQuadric>;

/// The planes of the faces of a small polytope, and of a triangle those through its edges too: it lies below all of
/// them.
struct ThingPlanes {
  struct Plane {
    Vec3 normal;     ///< unit
    double top = 0;  ///< no vertex is higher along it, but for rounding
  };
  static constexpr std::size_t most = 8;

  std::array<Plane, most> planes{};
  std::size_t count = 0;  ///< 0: of other sets, and of what is flat
  double extent = 0;      ///< the greatest coordinate
  double radius = 0;      ///< of a ball by which the polytope is grown
};

[[nodiscard]] ThingPlanes planes_of(const LevelSet& set);

/// How far a polytope is from a thing, by the plane that separates the two the most.
struct PlaneGap {
  double distance = 0;  ///< no more than the true one, of the two without radii; negative where no plane separates them
  Vec3 normal{};        ///< of that plane
  bool is_exact = false;  ///< it is the distance but for rounding: a lowest vertex is over the face
  Vec3 foot{};            ///< then, where on it
};

/// With no plane it tells nothing: a distance below 0.
[[nodiscard]] PlaneGap plane_gap(const PosedPolytope& above, const ThingPlanes& planes);

}  // namespace toccata
