#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "toccata/core/parallel.hpp"
#include "toccata/math/vec3.hpp"

// Continuous collision of the two pairs of features by which triangles that deform can meet: a vertex and a face, an
// edge and an edge. Exact for all finite doubles (docs/truth.md, "Features that move").
namespace toccata {

/// A point that moves in a straight line: at time t in [0, 1] it is at (1 − t) · start + t · end, over the reals.
struct MovingPoint {
  Vec3 start;
  Vec3 end;
  friend constexpr bool operator==(const MovingPoint&, const MovingPoint&) = default;
};

/// A point and a closed triangle; where the triangle has no area it is the segment or the point that it has become.
struct VertexFace {
  MovingPoint vertex;
  std::array<MovingPoint, 3> face;
};

/// Two closed segments; where one has no length it is a point.
struct EdgeEdge {
  std::array<MovingPoint, 2> a;
  std::array<MovingPoint, 2> b;
};

/// When two moving features first have a point in common. The exact time lies in [lower, upper], two neighbouring
/// multiples of 2^-40, or is both where it is such a multiple itself; so `upper` is 0 exactly when they meet at the
/// start.
struct TimeOfImpact {
  double lower = 0;
  double upper = 0;
  friend constexpr bool operator==(const TimeOfImpact&, const TimeOfImpact&) = default;
};

/// None where it is proved that they meet at no real time in [0, 1]. Exact, and always answered. Throws Error when a
/// coordinate is not finite. The order of the corners, of the ends of an edge and of the two edges makes no difference.
[[nodiscard]] std::optional<TimeOfImpact> time_of_impact(const VertexFace& pair);
[[nodiscard]] std::optional<TimeOfImpact> time_of_impact(const EdgeEdge& pair);

/// For each pair the same answer as alone.
[[nodiscard]] std::vector<std::optional<TimeOfImpact>> time_of_impact_each(std::span<const VertexFace> pairs,
                                                                           int threads = all_threads);
[[nodiscard]] std::vector<std::optional<TimeOfImpact>> time_of_impact_each(std::span<const EdgeEdge> pairs,
                                                                           int threads = all_threads);

}  // namespace toccata
