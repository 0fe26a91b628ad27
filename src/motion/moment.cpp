#include "motion/moment.hpp"

#include <cmath>

#include "math/expansion.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {
namespace {

/// start + time · (end − start), where none of the three operations rounds.
std::optional<double> exact_coordinate(double start, double end, double time) {
  const TwoPart way = two_difference(end, start), travelled = two_product(time, way.high);
  const TwoPart sum = two_sum(start, travelled.high);
  const bool is_exact = way.low == 0 && travelled.low == 0 && sum.low == 0;
  // Products within these limits neither underflow nor overflow on the way.
  const double size = std::fabs(travelled.high);
  const bool is_in_range = way.high == 0 || (size > 0x1p-900 && size < 0x1p900);
  return is_exact && is_in_range ? std::optional<double>(sum.high) : std::nullopt;
}

std::optional<Vec3> exact_position(const MovingPoint& point, double time) {
  if (time == 0) return point.start;
  if (time == 1) return point.end;
  const auto x = exact_coordinate(point.start.x, point.end.x, time);
  const auto y = exact_coordinate(point.start.y, point.end.y, time);
  const auto z = exact_coordinate(point.start.z, point.end.z, time);
  if (!x || !y || !z) return {};
  return Vec3{*x, *y, *z};
}

std::array<const MovingPoint*, 4> points_of(const MovingPolygon<3>& p) {
  return {p[0].tail, p[0].head, p[1].head, p[2].head};
}
std::array<const MovingPoint*, 4> points_of(const MovingPolygon<4>& p) {
  return {p[0].head, p[1].head, p[0].tail, p[2].tail};
}

template <std::size_t Count>
std::optional<Moment<Count>> moment_of(const MovingPolygon<Count>& polygon, double time) {
  const std::array<const MovingPoint*, 4> points = points_of(polygon);
  Moment<Count> moment;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::optional<Vec3> position = exact_position(*points[i], time);
    if (!position) return {};
    moment.position[i] = *position;
  }
  return moment;
}

}  // namespace

// Points and segments are triangles without area.
template <>
bool Moment<3>::is_contact() const {
  const auto& [vertex, a, b, c] = position;
  return overlap(Triangle{{vertex, vertex, vertex}}, Triangle{{a, b, c}});
}

template <>
bool Moment<4>::is_contact() const {
  const auto& [a, b, c, d] = position;
  return overlap(Triangle{{a, b, b}}, Triangle{{c, d, d}});
}

template <>
std::optional<Moment<3>> moment_at(const MovingPolygon<3>& polygon, double time) {
  return moment_of(polygon, time);
}

template <>
std::optional<Moment<4>> moment_at(const MovingPolygon<4>& polygon, double time) {
  return moment_of(polygon, time);
}

}  // namespace toccata
