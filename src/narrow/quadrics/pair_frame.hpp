#pragma once

#include "math/bounded_number.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// Where the searches and proofs for a pair happen: the world moved by −origin and multiplied by a power of two, so
/// that neither a place far from the origin nor tiny or huge lengths cost digits.
struct PairFrame {
  Vec3 origin;
  double factor = 1;

  [[nodiscard]] Vec3 plainly_placed(const Vec3& world) const {
    return factor < 1 ? factor * world - factor * origin : factor * (world - origin);
  }
  [[nodiscard]] BoundedVector place(const Vec3& world) const;
  [[nodiscard]] BoundedVector scaled(const Vec3& world) const;
  [[nodiscard]] Vec3 back(const Vec3& placed) const;
};

[[nodiscard]] PairFrame pair_frame(const PosedQuadric& a, const PosedQuadric& b);
[[nodiscard]] PairFrame pair_frame(const PosedQuadric& a, const PosedPolytope& b);
/// That of the quadric, but of one so far from the plane's point that numbers would leave the range.
[[nodiscard]] PairFrame pair_frame(const PosedQuadric& a, const PosedHalfSpace& b);
/// The greatest coordinate is at least 1 and less than 2 in magnitude.
[[nodiscard]] Vec3 scaled_normal(const PosedHalfSpace& half_space);

}  // namespace toccata
