#pragma once

#include <span>
#include <vector>

#include "math/exact.hpp"
#include "query/inside/inside_interval.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

/// An exact number and the doubles around it, by which most comparisons are settled.
class ExactNumber {
 public:
  ExactNumber() = default;
  explicit ExactNumber(Rational value);
  explicit ExactNumber(double value) : exact_(to_rational(value)), around_{value, value} {}

  [[nodiscard]] const Rational& exact() const { return exact_; }
  [[nodiscard]] const Interval& around() const { return around_; }
  [[nodiscard]] bool is_double() const { return around_.lower == around_.upper; }

  friend bool operator<(const ExactNumber& a, const ExactNumber& b);
  friend bool operator==(const ExactNumber& a, const ExactNumber& b);

 private:
  Rational exact_;
  Interval around_;
};

struct PlanarPoint {
  ExactNumber x;
  ExactNumber y;
};

/// In the plane. The left end is not right of the right one, and of a vertical segment it is the lower.
struct PlanarSegment {
  PlanarPoint left;
  PlanarPoint right;

  [[nodiscard]] bool is_vertical() const { return left.x == right.x; }
};

/// The three edges of `t` and then the different segments that the triangles of `cuts` draw on it: where they cross its
/// plane, and the outlines of those that lie in it (an edge on both sides of which such triangles lie is no outline).
/// In the projection along `axis`, which has area. A segment may go on beyond t.
[[nodiscard]] std::vector<PlanarSegment> segments_on(const Triangle& t, std::span<const Triangle> cuts, int axis);

/// The height of a segment that is not vertical, at an x of its range.
[[nodiscard]] Rational height_at(const PlanarSegment& s, const ExactNumber& x);

/// The same in doubles.
[[nodiscard]] Interval approximate_height_at(const PlanarSegment& s, const Interval& x);

/// Adds to `ends` the x at which `other` meets the inside of `s`, which is not vertical, in one point.
void add_intersection(const PlanarSegment& s, const PlanarSegment& other, std::vector<ExactNumber>& ends);

}  // namespace toccata
