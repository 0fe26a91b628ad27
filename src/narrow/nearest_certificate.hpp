#pragma once

#include <optional>

#include "math/bounded_number.hpp"
#include "narrow/gjk.hpp"

// Proofs of what the search in doubles has found.
namespace toccata {

/// Vertices of a face of either shape: in all at most four, one and up to three, or two and two.
struct NearestFeatures {
  std::array<Index, 3> a{};
  std::array<Index, 3> b{};
  std::size_t count_a = 0;
  std::size_t count_b = 0;
};

/// The nearest points of two shapes, their radii left aside, as bounded numbers.
struct CertainNearest {
  VertexPairs pairs;         ///< a simplex of the features
  BoundedVector difference;  ///< on_a − on_b
  BoundedNumber distance;
  BoundedVector on_a;
  BoundedVector on_b;
};

/// Proves that the nearest points are unique and lie on the features of the simplex, or of one close by. Nothing when
/// there is no proof.
[[nodiscard]] std::optional<CertainNearest> certain_nearest(const SupportSearch& a, const SupportSearch& b,
                                                            const VertexPairs& simplex);

/// No plane across the direction has less than `gap` between the shapes, and more: proved.
[[nodiscard]] bool certainly_farther(const SupportSearch& a, const SupportSearch& b, const Vec3& direction, double gap);

/// The origin is in the hull of four vertices of the Minkowski difference; the signs are exact.
[[nodiscard]] bool contains_origin(const PosedConvex& a, const PosedConvex& b, const VertexPairs& simplex);

/// The point of A that has the same weights among its vertices as the origin among the simplex of four pairs.
[[nodiscard]] BoundedVector common_point(const PosedConvex& a, const PosedConvex& b, const VertexPairs& simplex);

}  // namespace toccata
