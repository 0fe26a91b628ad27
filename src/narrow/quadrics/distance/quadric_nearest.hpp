#pragma once

#include <optional>

#include "narrow/quadrics/distance/newton_refinement.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// Where exact signs found a point of both shapes, in the world.
struct SharedPoint {
  Vec3 point;
  /// Where they are proved to have no more in common than boundaries: that of a plane through the point which parts
  /// them, a unit vector from A to B. Else zero.
  Vec3 normal;
};

/// What is proved of two bodies, in the pair's frame.
struct QuadricNearest {
  double lower = 0;         ///< no less far apart
  double upper = HUGE_VAL;  ///< no farther, as the two points show
  Vec3 on_a;
  Vec3 on_b;
  /// From B to A, as `NewtonRefinement` has it: across it they are `lower` apart, or what was the best there is.
  FineDirection direction;
  QuadricContact contact = QuadricContact::undecided;
  /// Then, where that was the proof.
  std::optional<SharedPoint> shared;
  bool narrow = false;  ///< the interval is as narrow as is promised
};

/// Proved to have points in common, and no inner points.
[[nodiscard]] inline bool is_touching(const QuadricNearest& found) {
  return found.shared && !(found.shared->normal == Vec3{});
}

/// How much is asked: whether they meet, or how far apart they are.
enum class QuadricQuestion : std::uint8_t { meeting, distance };

/// A is made of a quadric. Where a guess of the nearest points is given, it is looked at first.
[[nodiscard]] QuadricNearest nearest_of(const QuadricBody& a, const QuadricBody& b, QuadricQuestion question,
                                        const FastRefinement* guess = nullptr);

// The same of shapes in their pair's frame. Where this leaves open whether they meet, exact signs tell whether one
// contains the middle of the other (of shapes that are tiny beside it, all simplices may be flat for doubles), whether
// a point next to the nearest ones is in both, and whether they only touch there.
[[nodiscard]] QuadricNearest nearest_of(const PosedQuadric& a, const QuadricBody& body_a, const PosedQuadric& b,
                                        const QuadricBody& body_b, QuadricQuestion question,
                                        const FastRefinement* guess = nullptr);
[[nodiscard]] QuadricNearest nearest_of(const PosedQuadric& a, const QuadricBody& body_a, const PosedPolytope& b,
                                        const QuadricBody& body_b, QuadricQuestion question,
                                        const FastRefinement* guess = nullptr);

}  // namespace toccata
