#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "math/constants.hpp"
#include "math/double_word.hpp"
#include "math/wide_integer.hpp"
#include "narrow/convex/support_scan.hpp"
#include "toccata/narrow/posed_polytope.hpp"

// The Minkowski difference D = A − B of two cores, the convex hull of all a − b: what penetration is measured in. B
// moved by t meets A exactly when t lies in D; so the shortest way out of D's interior parts the two.
namespace toccata {

/// The world vertices of a core: as they are, and for the search for supports once more, relative to the first and
/// scaled.
class CoreVertices {
 public:
  explicit CoreVertices(const PosedPolytope& shape);
  CoreVertices(const CoreVertices&) = delete;
  CoreVertices& operator=(const CoreVertices&) = delete;

  /// Fills the coordinates for the supports. The factors are powers of two.
  void scale(double first, double second);

  [[nodiscard]] Index count() const { return count_; }
  [[nodiscard]] Vec3 operator[](Index i) const { return {world_[0][i], world_[1][i], world_[2][i]}; }
  [[nodiscard]] const Vec3& least() const { return least_; }
  [[nodiscard]] const Vec3& greatest() const { return greatest_; }
  /// The least exponent of all coordinates (wide_integer.hpp).
  [[nodiscard]] int least_exponent() const;

  /// Height of vertex i along n, above the first vertex, scaled. Off by at most 2^-50 of the shape's scaled extent, for
  /// a unit vector n.
  [[nodiscard]] double height(Index i, const Vec3& n) const {
    return (relative_[0][i] * n.x + relative_[1][i] * n.y) + relative_[2][i] * n.z;
  }

  /// Vertex i from the first one, scaled.
  [[nodiscard]] Vec3 relative(Index i) const { return {relative_[0][i], relative_[1][i], relative_[2][i]}; }

  /// For the vertex of the least height along a direction; repeats the last vertex up to a multiple of eight.
  [[nodiscard]] SupportScan scan(const Vec3& direction) const {
    return {relative_[0], relative_[1], relative_[2], padded_, direction, {}, count_};
  }

 private:
  static constexpr Index few = 64;
  Index count_;
  Index padded_;
  Vec3 least_;
  Vec3 greatest_;
  std::array<double*, 3> world_;
  std::array<double*, 3> relative_;
  alignas(64) std::array<std::array<double, few>, 6> few_;
  std::unique_ptr<double[]> many_;
};

/// A vertex pair of the difference, a − b, scaled. Each coordinate is rounded once: off by at most 2^-53 of itself.
struct DifferencePoint {
  Vec3 value;
  Index on_a = 0;
  Index on_b = 0;
};

/// The same with about twice the digits.
struct PrecisePoint {
  DoubleWord x, y, z;
};

inline PrecisePoint operator-(const PrecisePoint& p, const PrecisePoint& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}
inline DoubleWord dot(const PrecisePoint& p, const PrecisePoint& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
inline PrecisePoint cross(const PrecisePoint& p, const PrecisePoint& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

class DifferenceBody {
 public:
  DifferenceBody(const PosedPolytope& a, const PosedPolytope& b);
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
  /// For a depth along a direction that is a unit vector up to 2^-50: what parts in the world's unit, and no more than
  /// the depth, which is positive. The way back to that unit may round.
  [[nodiscard]] double upper_in_world(double depth) const {
    return std::nextafter(unscaled(depth + 0x1p-49 * depth), infinity);
  }
  [[nodiscard]] double lower_in_world(double depth) const { return std::nextafter(unscaled(depth), 0.0); }
  [[nodiscard]] double scaled_length(double length) const { return length * first_ * second_; }

  /// Roughly from the middle of A to that of B, scaled.
  [[nodiscard]] Vec3 from_a_to_b() const;

  /// a − b, scaled, without rounding.
  [[nodiscard]] PrecisePoint precise_point(Index on_a, Index on_b) const;
  /// a − b without rounding, in units of 2^exact_exponent().
  [[nodiscard]] IntegerVector exact_point(Index on_a, Index on_b) const;
  [[nodiscard]] int exact_exponent() const;

 private:
  CoreVertices a_;
  CoreVertices b_;
  double first_ = 1;
  double second_ = 1;
  double extent_ = 0;
  SupportKernels kernels_ = support_kernels();
  mutable std::optional<int> exact_exponent_;
};

}  // namespace toccata
