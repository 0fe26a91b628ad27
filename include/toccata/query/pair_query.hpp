#pragma once

#include "toccata/math/pose.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata {

/// How a question about two models is asked: where each is, and what each is taken for. Both poses are general 3×3
/// matrices with a translation; (A, B) under (P, Q) and under (I, P⁻¹Q) are different inputs (docs/truth.md).
struct PairQuery {
  Pose pose_a{};
  Pose pose_b{};
  Solid solid_a = Solid::automatic;
  Solid solid_b = Solid::automatic;
  int threads = 1;  ///< `contacts` is searched on up to so many, 0: as many as the machine has; it changes no answer
};

}  // namespace toccata
