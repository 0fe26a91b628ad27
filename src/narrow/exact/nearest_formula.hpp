#pragma once

#include <array>
#include <optional>

#include "narrow/convex/gjk.hpp"
#include "narrow/exact/feature_pair.hpp"
#include "narrow/exact/formula_numbers.hpp"

// The nearest points of two features by a formula in doubles, with a proof that they are those of the shapes.
namespace toccata {

/// The features of a simplex, vertices ascending: of a pair that a formula can be asked for. The same features come in
/// the same order, however they were found.
[[nodiscard]] std::optional<NearestFeatures> canonical_features(const VertexPairs& simplex);

struct VertexBefore {
  bool of_a = false;
  Index vertex = 0;
};

/// The features with another vertex in place of their own number i, those of A counted first; nothing where one shape
/// would be left without a vertex, or with more than three.
[[nodiscard]] std::optional<NearestFeatures> exchanged(const NearestFeatures& features, std::size_t i,
                                                       const VertexBefore& before);

/// The vertices of features in the world, in their order.
struct FeaturePoints {
  std::array<Vec3, 3> a;
  std::array<Vec3, 3> b;
};

[[nodiscard]] FeaturePoints points_of(const NearestFeatures& features, const SupportSearch& a, const SupportSearch& b);

/// The formula of two features. Edges start at the first vertex of each shape, those of B turned round, so that
/// exchanging the shapes turns the first difference and all edges round, exactly.
class NearestFormula {
 public:
  /// The features are canonical. Both are referred to.
  NearestFormula(const NearestFeatures& features, const FeaturePoints& points);
  NearestFormula(const NearestFeatures& features, const FeaturePoints&& points) = delete;

  /// No where rounding leaves any doubt that the two features are the only nearest ones. Whether they are proved to be,
  /// and every bit of the numbers, depends on the shapes and the features alone; exchanging the shapes exchanges the
  /// points and turns the difference round.
  [[nodiscard]] bool prove(const SupportSearch& a, const SupportSearch& b) { return solve() && others_beyond(a, b); }

  /// The two halves of the proof: that the nearest points lie inside the features, and, after that, that every other
  /// vertex lies beyond them.
  [[nodiscard]] bool solve();
  [[nodiscard]] bool others_beyond(const SupportSearch& a, const SupportSearch& b);

  /// After `solve`: a positive multiple of the exact difference, and what each of its coordinates may be off by. Where
  /// `close` finds no vertex of A along it and none of B against it, but those of the features, all others are beyond.
  [[nodiscard]] const Vec3& across() const { return numbers_.across; }
  [[nodiscard]] double slack() const { return numbers_.slack; }

  /// After a proof that failed because a vertex lies just before the plane through the features, as on a face that
  /// rounding has bent: which.
  [[nodiscard]] const std::optional<VertexBefore>& before() const { return before_; }

  [[nodiscard]] const NearestFeatures& features() const { return features_; }

  /// After a proof.
  [[nodiscard]] const FormulaNearest& nearest() const { return numbers_.nearest; }

  /// After a proof: the answer of `distance` for the shapes' radii, if the numbers are good enough for what is promised
  /// of it.
  [[nodiscard]] std::optional<Distance> distance(double radius_a, double radius_b) const;

 private:
  /// One of the edges that spread the features, those of A before those of B.
  [[nodiscard]] Difference edge(std::size_t i) const {
    const std::size_t of_a = features_.count_a - 1;
    return i < of_a ? Difference{points_.a[i + 1], points_.a[0]} : Difference{points_.b[0], points_.b[i - of_a + 1]};
  }
  [[nodiscard]] Vec3 along(std::size_t i) const {
    const Difference e = edge(i);
    return e.head - e.tail;
  }
  [[nodiscard]] Sign height_sign(const Difference& vector) const;

  const NearestFeatures& features_;
  const FeaturePoints& points_;
  std::size_t edges_;
  FormulaNumbers numbers_;
  std::optional<VertexBefore> before_;
};

}  // namespace toccata
