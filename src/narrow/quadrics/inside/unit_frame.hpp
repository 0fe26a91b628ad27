#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "narrow/quadrics/quadric_body.hpp"

namespace toccata {

/// What is known of one set in another. The greatest counts for several sets together.
enum class Within : std::uint8_t {
  yes,         ///< proved
  unfinished,  ///< a bounded search ended early
  undecided,   ///< the boundaries lie within rounding of each other
  no,          ///< proved
};

/// What is known of a set that reaches so far beyond the other.
inline Within from_sign(const BoundedNumber& excess) {
  if (excess.is_negative()) return Within::yes;
  return excess.is_positive() ? Within::no : Within::undecided;
}

inline Within both(Within a, Within b) { return std::max(a, b); }

/// A point, disc or ellipsoid in unit coordinates: the centre and all Σ_j w_j column_j with |w| ≤ 1.
struct UnitGenerator {
  BoundedVector centre;
  std::array<BoundedVector, 3> column;
  std::size_t columns = 0;
};

/// The coordinates y in which a quadric is plain: the ball |y| ≤ 1; the cylinder y₁² + y₂² ≤ 1, |y₃| ≤ 1; of a
/// cone those from its tip, y₁² + y₂² ≤ y₃², 0 ≤ y₃ ≤ 1. So each is what a quadric, y₁² + y₂² + s y₃² ≤ level, and up
/// to two planes have in common.
class UnitFrame {
 public:
  explicit UnitFrame(const QuadricBody& shape);

  [[nodiscard]] PosedQuadric::Kind kind() const { return kind_; }
  [[nodiscard]] double last_sign() const { return last_sign_; }  ///< s
  [[nodiscard]] double level() const { return level_; }
  [[nodiscard]] int caps() const { return caps_; }
  /// In the pair's frame: y = 0.
  [[nodiscard]] const BoundedVector& origin() const { return origin_; }
  /// yᵢ is its product with what points from the origin.
  [[nodiscard]] const BoundedVector& row(std::size_t i) const { return row_[i]; }

  [[nodiscard]] BoundedVector turned(const BoundedVector& way) const {
    return {dot(row_[0], way), dot(row_[1], way), dot(row_[2], way)};
  }
  [[nodiscard]] BoundedVector placed(const BoundedVector& point) const { return turned(point - origin_); }
  [[nodiscard]] UnitGenerator generator(const QuadricBody& body, Index number) const;
  /// A ball of the pair's frame.
  [[nodiscard]] UnitGenerator ball(const BoundedVector& centre, double radius) const;

 private:
  PosedQuadric::Kind kind_;
  double last_sign_ = 0;
  double level_ = 0;
  int caps_ = 0;
  BoundedVector origin_;
  std::array<BoundedVector, 3> row_;
};

/// Whether the shape holds all of a generator. Proved by the S-lemma (V. A. Yakubovich, 1971): the quadric holds the
/// image of the ball |w| ≤ 1 exactly when, for some λ ≥ 0, the form of the quadric less λ(|w|² − 1) is nowhere
/// positive.
[[nodiscard]] Within is_held(const UnitFrame& shape, const UnitGenerator& generator);

/// It is, as this multiplier λ shows.
[[nodiscard]] bool is_held_by(const UnitFrame& shape, const UnitGenerator& generator, double multiplier);

/// Whether the shape holds all of another body.
[[nodiscard]] Within is_held(const UnitFrame& shape, const QuadricBody& other);

}  // namespace toccata
