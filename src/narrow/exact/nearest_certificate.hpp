#pragma once

#include <optional>

#include "math/bounded_number.hpp"
#include "narrow/convex/gjk.hpp"

// Proofs of what the search in doubles has found.
namespace toccata {

inline constexpr std::size_t most_face_vertices = 12;

struct FaceVertices {
  std::array<Index, most_face_vertices> vertex{};
  std::size_t count = 0;
};

/// The nearest points of two shapes, their radii left aside, as bounded numbers; or those of a facet.
struct CertainNearest {
  VertexPairs pairs;         ///< a simplex of the features
  BoundedVector difference;  ///< on_a − on_b
  BoundedNumber distance;
  /// Where the nearest points may not be unique these are empty, and all vertices of the two faces are told instead.
  BoundedVector on_a;
  BoundedVector on_b;
  FaceVertices face_a;
  FaceVertices face_b;

  [[nodiscard]] bool unique() const { return face_a.count == 0; }
};

/// Proves that nearest points lie on the features of the simplex, or on others that are reached by exchanging a few
/// vertices, and that there are no others or in which faces they are. Nothing when there is no proof.
[[nodiscard]] std::optional<CertainNearest> certain_nearest(const SupportSearch& a, const SupportSearch& b,
                                                            const VertexPairs& simplex);

/// The same for features among the vertices that are the nearest along a direction, but for rounding: where faces are
/// nearly parallel a simplex of the search tells little.
[[nodiscard]] std::optional<CertainNearest> certain_nearest_along(const SupportSearch& a, const SupportSearch& b,
                                                                  const Vec3& direction);

/// For two cores that overlap: proves that all vertices lie behind the plane through the features, or in it, and that
/// the origin's foot is an inner point of them, or of others that are reached by exchanging a few vertices. The plane
/// is then one of the Minkowski difference's facets, and its distance no less than the depth.
[[nodiscard]] std::optional<CertainNearest> certain_facet(const SupportSearch& a, const SupportSearch& b,
                                                          const VertexPairs& simplex);

/// The shapes' cores are farther apart along the direction, which need not have length 1, than `gap`: proved.
[[nodiscard]] bool certainly_farther(const SupportSearch& a, const SupportSearch& b, const Vec3& direction, double gap);

/// A gap that is proved between the shapes' cores along the direction, which need not have length 1: from b to a. Not
/// positive or NaN: none is.
[[nodiscard]] double certain_gap_along(const SupportSearch& a, const SupportSearch& b, const Vec3& direction);

}  // namespace toccata
