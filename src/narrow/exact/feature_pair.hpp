#pragma once

#include <array>
#include <cstddef>

#include "math/bounded_number.hpp"
#include "narrow/exact/vertex_pairs.hpp"
#include "toccata/core/index.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// Vertices of a face of either shape: in all at most four, one and up to three, or two and two.
struct NearestFeatures {
  std::array<Index, 3> a{};
  std::array<Index, 3> b{};
  std::size_t count_a = 0;
  std::size_t count_b = 0;
  friend bool operator==(const NearestFeatures&, const NearestFeatures&) = default;
};

/// Pairs of which the features are made; for two edges some three of the four.
inline VertexPairs pairs_of(const NearestFeatures& f) {
  VertexPairs pairs;
  for (std::size_t i = 0; i < f.count_a; ++i) pairs.append(f.a[i], f.b[0]);
  for (std::size_t i = 1; i < f.count_b; ++i) pairs.append(f.a[0], f.b[i]);
  return pairs;
}

/// Two features with their nearest points. The edges that spread them start at the first vertex of each; as vectors of
/// the Minkowski difference, those of B are turned round.
class FeaturePair {
 public:
  FeaturePair(const PosedPolytope& a, const PosedPolytope& b, const NearestFeatures& features);

  [[nodiscard]] const NearestFeatures& features() const { return features_; }
  [[nodiscard]] const Vec3& first_a() const { return first_a_; }
  [[nodiscard]] const Vec3& first_b() const { return first_b_; }

  /// Spread by two edges: a vertex and a face, or two edges.
  [[nodiscard]] bool is_plane() const { return edges_ == 2; }

  enum class Inside { no, unknown, yes };

  /// For a pair that `is_plane`: whether the nearest points are within the triangle, or within both edges, as far as
  /// doubles can tell.
  [[nodiscard]] Inside likely_inside() const;

  /// Finds the nearest points of the features' affine hulls; tells whether they certainly are inner points of both.
  /// What follows holds only then.
  [[nodiscard]] bool solve();

  [[nodiscard]] const BoundedVector& difference() const { return difference_; }  ///< on_a − on_b
  [[nodiscard]] const BoundedNumber& distance() const { return distance_; }
  [[nodiscard]] BoundedVector on_a() const;
  [[nodiscard]] BoundedVector on_b() const;

  /// For a pair that `is_plane`: the exact sign of how much farther than the feature a vertex is, along on_a − on_b.
  [[nodiscard]] Sign beyond_a(const Vec3& vertex_of_a) const { return height_sign({vertex_of_a, first_a_}); }
  [[nodiscard]] Sign beyond_b(const Vec3& vertex_of_b) const { return height_sign({first_b_, vertex_of_b}); }

 private:
  [[nodiscard]] Sign height_sign(const Difference& vector) const {
    return side_ * triple_product_sign(edge_[0], edge_[1], vector);
  }
  [[nodiscard]] BoundedVector along(std::size_t edge) const;
  [[nodiscard]] bool at_vertices(const BoundedVector& first);
  [[nodiscard]] bool on_edge(const BoundedVector& first);
  [[nodiscard]] bool on_plane(const BoundedVector& first);
  [[nodiscard]] bool certainly_inside(const BoundedVector& first, const BoundedVector& normal,
                                      const BoundedNumber& whole) const;

  NearestFeatures features_;
  Vec3 first_a_, first_b_;
  std::array<Difference, 2> edge_;
  std::size_t edges_ = 0;
  BoundedNumber share_;  // of the first edge
  BoundedVector difference_;
  BoundedNumber distance_;
  Sign side_ = Sign::positive;
};

}  // namespace toccata
