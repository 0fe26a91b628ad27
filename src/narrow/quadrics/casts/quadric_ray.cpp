#include "narrow/quadrics/casts/quadric_ray.hpp"

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"

namespace toccata {
namespace {

/// The normal of the surface, in the frame in which it is round, where the line enters it.
template <QuadricKind Kind, class Number>
Vec3 normal_where_entered(const RoundLine<Number>& line, const RayStretch<Number>& stretch) {
  using End = typename RayStretch<Number>::End;
  if (stretch.entered_by == End::cap_below || stretch.entered_by == End::cap_above)
    return {0, 0, stretch.entered_by == End::cap_above ? 1.0 : -1.0};
  VectorOf<Number> at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = line.p[i] + stretch.enters * line.v[i];
  return Kind::round_normal(line, at);
}

template <QuadricKind Kind, class Number>
std::optional<LineWithin<Number>> within(RoundLine<Number> line) {
  line.orient();
  if (!line.volume.is_positive()) return {};
  RayStretch<Number> stretch(line.begin);
  Kind::cut(stretch, line);
  LineWithin<Number> found;
  found.empty = stretch.empty;
  if (found.empty) return found;
  if (!stretch.certain) return {};
  const Number length = stretch.leaves - stretch.enters;
  const bool unbounded = std::isinf(middle(stretch.enters)) || std::isinf(middle(stretch.leaves));
  if (!unbounded && !length.is_positive() && !length.is_negative()) return {};
  found.empty = !unbounded && length.is_negative();
  const Number begin = number_as<Number>(line.begin);
  found.enters = begin + stretch.enters;
  found.leaves = begin + stretch.leaves;
  if (found.empty || std::isinf(middle(stretch.enters))) return found;
  // A normal is mapped by the inverse of the transpose.
  const Vec3 out = normal_where_entered<Kind>(line, stretch);
  found.normal = (out.x * line.normal[0] + out.y * line.normal[1]) + out.z * line.normal[2];
  return found;
}

/// What is lost below the range is little beside what is rounded.
bool are_moderate_axes(const std::array<Vec3, 3>& axis, double size_from, double size_along) {
  constexpr double least = 0x1p-200, most = 0x1p200;
  for (const Vec3& a : axis)
    if (!(sum_of_magnitudes(a) > least && sum_of_magnitudes(a) < most)) return false;
  return size_from < most && size_along < most;
}

}  // namespace

template <class Number>
std::optional<LineWithin<Number>> line_within(const RoundAndLine<Number>& given) {
  RoundLine<Number> line;
  for (std::size_t i = 0; i < 3; ++i) {
    const VectorOf<Number> normal = outer(given.axis[(i + 1) % 3], given.axis[(i + 2) % 3]);
    line.p[i] = inner(normal, given.from);
    line.v[i] = inner(normal, given.along);
    line.normal[i] = {middle(normal[0]), middle(normal[1]), middle(normal[2])};
    if (i == 0) line.volume = inner(normal, given.axis[0]);
  }
  return with_kind(given.kind, [&]<class Kind>(Kind) { return within<Kind>(line); });
}

template std::optional<LineWithin<BoundedNumber>> line_within(const RoundAndLine<BoundedNumber>&);

/// From near the middle of the shape on, so that little cancels. A component of a cross product is off by less than 5
/// roundings of the product of the sums of magnitudes, a product with it by less than 10, those of the axes included;
/// the place from which on by less than 4 of what it is the sum of.
std::optional<LineWithin<BoundedDouble>> fast_line_within(PosedQuadric::Kind kind, const std::array<Vec3, 3>& axis,
                                                          const Vec3& from, const Vec3& along) {
  constexpr double rounding = 0x1p-53;
  RoundLine<BoundedDouble> line;
  line.begin = -dot(from, along) / dot(along, along);
  const Vec3 near = from + line.begin * along;
  const double size_along = sum_of_magnitudes(along), size_near = sum_of_magnitudes(near);
  const double summed = sum_of_magnitudes(from) + std::fabs(line.begin) * size_along;
  if (!are_moderate_axes(axis, summed, size_along)) return {};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &u = axis[(i + 1) % 3], &w = axis[(i + 2) % 3];
    const double part = 10 * rounding * sum_of_magnitudes(u) * sum_of_magnitudes(w);
    const Vec3 normal = cross(u, w);
    line.p[i] = {dot(normal, near), part * (size_near + 0.4 * summed) + BoundedNumber::underflow};
    line.v[i] = {dot(normal, along), part * size_along + BoundedNumber::underflow};
    line.normal[i] = normal;
    if (i == 0) line.volume = {dot(normal, axis[0]), part * sum_of_magnitudes(axis[0]) + BoundedNumber::underflow};
  }
  return with_kind(kind, [&]<class Kind>(Kind) { return within<Kind>(line); });
}

}  // namespace toccata
