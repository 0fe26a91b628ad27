#include "motion/approach.hpp"
#include "motion/scaled_polygon.hpp"

// Vertices that stop one by one, each where it wants. Let two features be apart along a direction n at the start: the
// least n · (head − tail) over all corners is g > d |n|. Let A be the most that a head's way leads against n, and B the
// most that a tail's leads along it, neither negative. Where every point of the two goes at most the part f of its way,
// no head has come farther against n than f A, and no tail farther along it than f B. So n · (head − tail) is at least
// g − f (A + B), and while
//     f (A + B) < g − d |n|
// the features, which are convex hulls of these points, are more than d apart. No time comes into it, and nothing is
// assumed of the order in which the points go. (M. Tang, D. Manocha, J. Lin, R. Tong, "Collision-streams", 2011, divide
// space between features by such planes to discard pairs; A. H. Chen and others, "Offset geometric contact", 2025,
// bound ways by balls: a ball is what is left of this where nothing is known of the direction of the ways.)
namespace toccata {
namespace {

/// How much of `way` leads along the direction, and no less; not negative. The dot product, with a difference, a
/// product and two sums, is off by at most 2^-50 of its magnitudes, as in separating_direction.hpp. Infinite where it
/// overflows.
double most_along(const Vec3& direction, const Vec3& way) {
  if (!is_finite(way)) return HUGE_VAL;
  const double size = dot(magnitudes(direction), magnitudes(way)) + filter::floor;
  return std::max(dot(direction, way), 0.0) + 0x1p-49 * size;
}

template <std::size_t Count>
double fraction_along(const MovingPolygon<Count>& polygon, const ScaledPolygon<Count>& scaled, const Vec3& direction) {
  double gap = HUGE_VAL, of_heads = 0, of_tails = 0;
  for (std::size_t i = 0; i < Count; ++i) {
    const MovingCorner& c = polygon[i];
    gap = std::min(gap, dot(direction, scaled.corners[i].start));
    of_heads = std::max(of_heads, most_along(-direction, scaled.factor * (c.head->end - c.head->start)));
    of_tails = std::max(of_tails, most_along(direction, scaled.factor * (c.tail->end - c.tail->start)));
  }
  const PolygonSpan<Count> span{scaled.corners, scaled.magnitude};
  const double wanted = span.slack(direction) + separation_along(direction, scaled.separation);
  // The margin is more than what the quotient rounds, and makes the inequality strict. A NaN is no fraction.
  const double fraction = (gap - wanted) / (of_heads + of_tails) * (1 - 0x1p-40);
  return fraction > 0 ? std::min(fraction, 1.0) : 0.0;
}

/// Along the direction in which they are nearest at the start, or at the end: what slides past is told by the one or
/// the other.
template <std::size_t Count>
double fraction_of(const MovingPolygon<Count>& polygon, double separation) {
  const ScaledPolygon<Count> scaled(polygon, separation);
  double greatest = 0;
  for (const double t : {0.0, 1.0}) {
    const Vec3 direction = of_largest_coordinate_one(nearest_of_polygon(scaled.at(t)).direction);
    greatest = std::max(greatest, fraction_along(polygon, scaled, direction));
    if (greatest == 1) break;
  }
  return greatest;
}

}  // namespace

double independent_fraction(const MovingPolygon<3>& polygon, double separation) {
  return fraction_of(polygon, separation);
}
double independent_fraction(const MovingPolygon<4>& polygon, double separation) {
  return fraction_of(polygon, separation);
}

}  // namespace toccata
