#pragma once

#include <optional>

#include "narrow/feature_pair.hpp"
#include "narrow/gjk.hpp"

// The nearest points of two features by a formula in doubles, with a proof that they are those of the shapes.
namespace toccata {

/// The features of a simplex, vertices ascending: of a pair that a formula can be asked for. The same features come in
/// the same order, however they were found.
[[nodiscard]] std::optional<NearestFeatures> canonical_features(const VertexPairs& simplex);

/// The nearest points of two cores, the radii left aside. Lengths of errors, not of their coordinates.
struct FormulaNearest {
  Vec3 on_a;
  Vec3 on_b;
  double point_error = 0;  ///< of either point, less 2^-48 of the greatest coordinate of the shapes
  Vec3 difference;         ///< on_a − on_b
  double difference_error = 0;
  double distance = 0;
  double distance_error = 0;
};

/// Nothing where rounding leaves any doubt that the two features, which are canonical, are the only nearest ones.
/// Whether there is an answer, and every bit of it, depends on the shapes and the features alone; exchanging the shapes
/// exchanges the points and turns the difference round.
[[nodiscard]] std::optional<FormulaNearest> nearest_by_formula(const SupportSearch& a, const SupportSearch& b,
                                                               const NearestFeatures& features);

/// The answer of `distance`, for shapes with these radii, where the formula's numbers are good enough for what is
/// promised of it.
[[nodiscard]] std::optional<Distance> formula_distance(const FormulaNearest& nearest, double radius_a, double radius_b);

}  // namespace toccata
