#pragma once

#include "motion/volume_filter.hpp"

// Fixed directions along which a moving polygon stays on one side of the origin: they tell what slides past each other
// in one plane, of which the volume tells nothing.
namespace toccata {

// The bound. A corner at a time t, of which both t and 1 − t are doubles, is (1 − t)s + te from rounded differences: a
// difference, a product and a sum give three factors 1 + δ with |δ| ≤ ε = 2^-53, and underflow takes 2η, η = 2^-1075.
// The dot product with a direction adds a product and two sums, and 3η. So with m the greatest magnitude of each
// coordinate at the start and the end it is off by at most ((1 + ε)^6 − 1) Σ|d_c|m_c + (3 + 2Σ|d_c|)η, which is less
// than 6.1ε Σ|d_c|m_c + 5.1η(Σ|d_c| + 1). `slack` is computed with four roundings, from magnitudes of at
// least τ = `filter::floor`, and 15ε max(m_c, τ) ≥ 7.5ε (m_c + τ). Overflow makes it infinite or NaN.
inline constexpr double direction_bound = 0x1p-49;

/// The corners of a polygon at both ends of a part of its time, and the greatest magnitudes over all of it.
template <std::size_t Count>
struct PolygonSpan {
  RoundedPolygon<Count> corners;
  Vec3 magnitude;

  /// How much a dot product with the direction may be off.
  [[nodiscard]] double slack(const Vec3& direction) const {
    const double sum = (std::fabs(direction.x) * magnitude.x + std::fabs(direction.y) * magnitude.y) +
                       std::fabs(direction.z) * magnitude.z;
    return direction_bound * (sum + filter::floor);
  }
};

template <std::size_t Count>
Vec3 greatest_magnitudes(const RoundedPolygon<Count>& polygon) {
  Vec3 greatest{filter::floor, filter::floor, filter::floor};
  for (const RoundedCorner& c : polygon) {
    const Vec3 m = greatest_magnitudes(c);
    greatest = {std::max(greatest.x, m.x), std::max(greatest.y, m.y), std::max(greatest.z, m.z)};
  }
  return greatest;
}

/// The corner farthest against the direction.
template <std::size_t Count>
Vec3 least_along(const RoundedPolygon<Count>& polygon, const Vec3& direction) {
  Vec3 least = polygon[0].start;
  double height = dot(direction, least);
  const auto consider = [&](const Vec3& corner) {
    const double h = dot(direction, corner);
    least = h < height ? corner : least;
    height = std::min(h, height);
  };
  for (const RoundedCorner& c : polygon) {
    consider(c.start);
    consider(c.end);
  }
  return least;
}

/// Whether a direction is found that proves that the polygon does not contain the origin within the span: that of the
/// point of the corners' hull nearest to the origin, which is approached from corner to corner (M. Frank, P. Wolfe, "An
/// algorithm for quadratic programming", 1956).
template <std::size_t Count>
bool has_separating_direction(const PolygonSpan<Count>& span, int steps) {
  Vec3 nearest{};
  for (const RoundedCorner& c : span.corners) nearest += c.start + c.end;
  nearest = nearest / (2.0 * static_cast<double>(Count));
  for (int step = 0; step < steps; ++step) {
    const Vec3 corner = least_along(span.corners, nearest);
    const double height = dot(nearest, corner);
    if (height > span.slack(nearest)) return true;
    const Vec3 way = nearest - corner;
    const double fraction = dot(nearest, way) / dot(way, way);
    if (!(fraction > 0)) return false;
    nearest = nearest - std::min(fraction, 1.0) * way;
  }
  return false;
}

}  // namespace toccata
