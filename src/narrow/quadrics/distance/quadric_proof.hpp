#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "narrow/quadrics/distance/quadric_search.hpp"
#include "narrow/quadrics/quadric_body.hpp"

// What is believed of quadric bodies: heights along a direction, and points, with bounds on what they are off by.
// Number is BoundedDouble where that does, else BoundedNumber.
namespace toccata {

/// The width that the interval of a distance or a depth may have, as a share of it.
inline constexpr double relative_width = 1e-12;

/// A direction of about 106 bits, taken as it is.
using FineDirection = FineVector;

inline FineDirection fine(const Vec3& d) { return {DoubleWord{d.x, 0}, DoubleWord{d.y, 0}, DoubleWord{d.z, 0}}; }

/// A point of a body by what it is made of: it is the body's, whatever these numbers are. Weights that are negative
/// count as 0, and are brought to the sum 1; a round part that is longer than 1 is brought to length 1.
struct BodyPoint : WeightedGenerators<DoubleWord, 4> {
  std::array<DoubleWord, 3> round{};
};

[[nodiscard]] BodyPoint body_point(const QuadricSupport& support);

template <class Number>
[[nodiscard]] VectorOf<Number> point_of(const QuadricBody& body, const BodyPoint& point);

/// The height of a generator's farthest point along the direction.
template <class Number>
[[nodiscard]] Number generator_height(const QuadricBody& body, Index generator, const FineDirection& direction);

/// No point of the body is higher along the direction than the upper end of this.
template <class Number>
[[nodiscard]] Number height_of(const QuadricBody& body, const FineDirection& direction);

/// All of A − B lies at least this far from the origin along the direction; negative when it does not. −∞ where nothing
/// is certain. In the pair's frame.
template <class Number>
[[nodiscard]] double gap_along(const QuadricBody& a, const QuadricBody& b, const FineDirection& direction);

/// The distance of two points is at most this.
template <class Number>
[[nodiscard]] double distance_at_most(const VectorOf<Number>& p, const VectorOf<Number>& q);

inline double middle(const DoubleWord& a) { return a.high; }

/// Six times the signed volume of the tetrahedron of the origin and three points, seen from the nearest of them: the
/// others may be far away, where their difference is known better than they are.
template <class Number>
[[nodiscard]] Number volume_from_origin(const VectorOf<Number>& p, const VectorOf<Number>& q,
                                        const VectorOf<Number>& r) {
  const auto size = [](const VectorOf<Number>& v) {
    return std::fmax(std::fmax(std::fabs(middle(v[0])), std::fabs(middle(v[1]))), std::fabs(middle(v[2])));
  };
  const auto seen_from = [](const VectorOf<Number>& a, const VectorOf<Number>& b, const VectorOf<Number>& c) {
    return inner(a, outer(difference(b, a), difference(c, a)));
  };
  const double of_p = size(p), of_q = size(q), of_r = size(r);
  if (of_q < of_p && of_q < of_r) return seen_from(q, r, p);
  return of_r < of_p ? seen_from(r, p, q) : seen_from(p, q, r);
}

/// The origin certainly lies inside the tetrahedron.
template <class Number>
[[nodiscard]] bool is_origin_within(const std::array<VectorOf<Number>, 4>& corner);

/// The point certainly lies in the interior of a body that is made of a quadric.
[[nodiscard]] bool is_within(const QuadricBody& quadric, const BoundedVector& point);

}  // namespace toccata
