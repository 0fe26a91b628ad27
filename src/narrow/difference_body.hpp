#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "math/wide_integer.hpp"
#include "toccata/narrow/posed_convex.hpp"

// The Minkowski difference D = A − B of two cores, the convex hull of all a − b: what penetration is measured in. B
// moved by t meets A exactly when t lies in D; so the shortest way out of D's interior parts the two.
namespace toccata {

/// The world vertices of a core: as they are, and for the search for supports once more along each axis, relative to
/// the first and scaled.
class CoreVertices {
 public:
  explicit CoreVertices(const PosedConvex& shape);

  /// Fills the coordinates for the supports. The factors are powers of two.
  void scale(double first, double second);

  [[nodiscard]] Index count() const { return count_; }
  [[nodiscard]] const Vec3& operator[](Index i) const { return world_[i]; }
  [[nodiscard]] std::span<const Vec3> world() const { return {world_, count_}; }
  [[nodiscard]] const Vec3& least() const { return least_; }
  [[nodiscard]] const Vec3& greatest() const { return greatest_; }

  /// Height of vertex i along n, above the first vertex, scaled. Off by at most 2^-50 of the shape's scaled extent, for
  /// a unit vector n.
  [[nodiscard]] double height(Index i, const Vec3& n) const {
    return (along_[0][i] * n.x + along_[1][i] * n.y) + along_[2][i] * n.z;
  }

  /// The vertex of the greatest height; of several that compute to the same, the first.
  [[nodiscard]] Index farthest(const Vec3& n) const;

 private:
  static constexpr Index few = 64;
  Index count_;
  Index padded_;
  Vec3 least_;
  Vec3 greatest_;
  Vec3* world_;
  std::array<double*, 3> along_;
  std::array<Vec3, few> few_world_;
  alignas(64) std::array<std::array<double, few>, 3> few_along_;
  std::unique_ptr<Vec3[]> many_world_;
  std::unique_ptr<double[]> many_along_;
};

/// A vertex pair of the difference, a − b, scaled. Each coordinate is rounded once: off by at most 2^-53 of itself.
struct DifferencePoint {
  Vec3 value;
  Index on_a = 0;
  Index on_b = 0;
};

class DifferenceBody {
 public:
  DifferenceBody(const PosedConvex& a, const PosedConvex& b);
  DifferenceBody(const DifferenceBody&) = delete;
  DifferenceBody& operator=(const DifferenceBody&) = delete;

  [[nodiscard]] const CoreVertices& a() const { return a_; }
  [[nodiscard]] const CoreVertices& b() const { return b_; }

  [[nodiscard]] DifferencePoint point(Index on_a, Index on_b) const;
  /// The point of D that is farthest along the unit vector n, up to 2^-48 · extent().
  [[nodiscard]] DifferencePoint support(const Vec3& n) const;

  /// The greatest magnitude of a coordinate of D, scaled: in [1, 2] for all but the tiniest.
  [[nodiscard]] double extent() const { return extent_; }
  /// From scaled lengths back: multiply by the first, then by the second. Exact but for over- and underflow.
  [[nodiscard]] double unscaled(double length) const { return length / second_ / first_; }
  [[nodiscard]] double scaled_length(double length) const { return length * first_ * second_; }

  /// Roughly from the middle of A to that of B, scaled.
  [[nodiscard]] Vec3 from_a_to_b() const;

  /// a − b without rounding, in units of 2^exact_exponent().
  [[nodiscard]] IntegerVector exact_point(Index on_a, Index on_b) const;
  [[nodiscard]] int exact_exponent() const;

 private:
  CoreVertices a_;
  CoreVertices b_;
  double first_ = 1;
  double second_ = 1;
  double extent_ = 0;
  mutable std::optional<int> exact_exponent_;
};

}  // namespace toccata
