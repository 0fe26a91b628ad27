#include "narrow/quadrics/distance/quadric_proof.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"

namespace toccata {
namespace {

/// More generators than this in one height are not told apart by rounding; then all are looked at.
constexpr std::size_t most_tied_generators = 16;

bool is_more(const BoundedDouble& a, const BoundedDouble& b) { return a.value > b.value; }
bool is_more(const BoundedNumber& a, const BoundedNumber& b) {
  return a.value.high > b.value.high || (a.value.high == b.value.high && a.value.low > b.value.low);
}

template <class Number>
Number growth_along(const QuadricBody& body, const VectorOf<Number>& direction) {
  Number squared = number_as<Number>(0.0);
  for (std::size_t j = 0; j < body.column_count(); ++j) {
    const Number along = inner(direction, vector_as<Number>(body.column(j)));
    squared = squared + along * along;
  }
  return root_of_squares(squared);
}

}  // namespace

BodyPoint body_point(const QuadricSupport& support) {
  BodyPoint point;
  point.append(support.generator, {1, 0});
  for (std::size_t j = 0; j < 3; ++j) point.round[j] = {support.round[static_cast<int>(j)], 0};
  return point;
}

template <class Number>
VectorOf<Number> point_of(const QuadricBody& body, const BodyPoint& point) {
  const Number none = number_as<Number>(0.0);
  Number total = none, grown = none;
  VectorOf<Number> sum_of_centres{none, none, none};
  for (std::size_t i = 0; i < point.size; ++i) {
    if (!(point.weight[i].high > 0)) continue;
    const Number weight = number_as<Number>(point.weight[i]);
    total = total + weight;
    if (body.grown(point.generator[i])) grown = grown + weight;
    sum_of_centres = sum(sum_of_centres, multiple(weight, vector_as<Number>(body.centre(point.generator[i]))));
  }
  if (body.column_count() == 0 || middle(grown) == 0)
    return point.size == 1 ? vector_as<Number>(body.centre(point.generator[0]))
                           : multiple(number_as<Number>(1.0) / total, sum_of_centres);
  VectorOf<Number> mapped{none, none, none};
  Number squared = none;
  for (std::size_t j = 0; j < body.column_count(); ++j) {
    const Number u = number_as<Number>(point.round[j]);
    squared = squared + u * u;
    mapped = sum(mapped, multiple(u, vector_as<Number>(body.column(j))));
  }
  Number part = grown;
  if (!(number_as<Number>(1.0) - squared).is_positive()) part = part / square_root(squared);
  return multiple(number_as<Number>(1.0) / total, sum(sum_of_centres, multiple(part, mapped)));
}

template <class Number>
Number generator_height(const QuadricBody& body, Index generator, const FineDirection& direction) {
  const VectorOf<Number> d = vector_as<Number>(direction);
  const Number height = inner(d, vector_as<Number>(body.centre(generator)));
  return body.grown(generator) ? height + growth_along(body, d) : height;
}

template <class Number>
Number height_of(const QuadricBody& body, const FineDirection& direction) {
  const VectorOf<Number> d = vector_as<Number>(direction);
  const Number growth = growth_along(body, d);
  std::array<Index, most_tied_generators> found;
  // Where Newton's method has failed, the direction is of any length.
  const Index count = body.highest_generators(unit_or_zero(high_parts(direction)), found);
  Number highest;
  double widest = -1;
  const auto look_at = [&](Index generator) {
    Number height = inner(d, vector_as<Number>(body.centre(generator)));
    if (body.grown(generator)) height = height + growth;
    if (widest < 0 || is_more(height, highest)) highest = height;
    // The greatest lies no higher than the highest value and the widest bound; asked so that NaN is kept.
    if (!(height.error <= widest) && widest == widest) widest = height.error;
  };
  if (count <= most_tied_generators)
    for (Index i = 0; i < count; ++i) look_at(found[i]);
  else
    for (Index i = 0; i < body.generator_count(); ++i) look_at(i);
  highest.error = widest;
  return highest;
}

template <class Number>
double gap_along(const QuadricBody& a, const QuadricBody& b, const FineDirection& direction) {
  const FineDirection back{-direction[0], -direction[1], -direction[2]};
  const Number gap = -(height_of<Number>(a, back) + height_of<Number>(b, direction));
  const VectorOf<Number> d = vector_as<Number>(direction);
  const double lower = floor_of(gap / square_root(inner(d, d)));
  return lower == lower ? lower : -HUGE_VAL;
}

template <class Number>
double distance_at_most(const VectorOf<Number>& p, const VectorOf<Number>& q) {
  const VectorOf<Number> between = difference(p, q);
  const double upper = ceiling_of(root_of_squares(inner(between, between)));
  return upper == upper ? upper : HUGE_VAL;
}

template <class Number>
bool is_origin_within(const std::array<VectorOf<Number>, 4>& corner) {
  // The origin's side of each face is that of the opposite corner.
  int positive = 0, negative = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& p = corner[(i + 1) % 4];
    const auto& q = corner[(i + 2) % 4];
    const auto& r = corner[(i + 3) % 4];
    const Number volume = volume_from_origin(p, q, r);
    const bool odd = i % 2 == 1;
    positive += (odd ? (-volume).is_positive() : volume.is_positive()) ? 1 : 0;
    negative += (odd ? (-volume).is_negative() : volume.is_negative()) ? 1 : 0;
  }
  return positive == 4 || negative == 4;
}

bool is_within(const QuadricBody& quadric, const BoundedVector& point) {
  const std::array<BoundedVector, 3>& axis = quadric.axes();
  const BoundedVector from_middle = point - quadric.middle_point();
  const BoundedVector normal[3] = {cross(axis[1], axis[2]), cross(axis[2], axis[0]), cross(axis[0], axis[1])};
  const BoundedNumber volume = dot(normal[0], axis[0]);
  BoundedVector u;
  for (std::size_t i = 0; i < 3; ++i) u[i] = dot(normal[i], from_middle) / volume;
  return with_kind(*quadric.quadric_kind(), [&](auto kind) { return kind.holds_within(u); });
}

template VectorOf<BoundedDouble> point_of(const QuadricBody&, const BodyPoint&);
template VectorOf<BoundedNumber> point_of(const QuadricBody&, const BodyPoint&);
template double gap_along<BoundedDouble>(const QuadricBody&, const QuadricBody&, const FineDirection&);
template double gap_along<BoundedNumber>(const QuadricBody&, const QuadricBody&, const FineDirection&);
template BoundedDouble generator_height(const QuadricBody&, Index, const FineDirection&);
template BoundedNumber generator_height(const QuadricBody&, Index, const FineDirection&);
template BoundedDouble height_of(const QuadricBody&, const FineDirection&);
template BoundedNumber height_of(const QuadricBody&, const FineDirection&);
template double distance_at_most(const VectorOf<BoundedDouble>&, const VectorOf<BoundedDouble>&);
template double distance_at_most(const VectorOf<BoundedNumber>&, const VectorOf<BoundedNumber>&);
template bool is_origin_within(const std::array<VectorOf<BoundedDouble>, 4>&);
template bool is_origin_within(const std::array<VectorOf<BoundedNumber>, 4>&);

}  // namespace toccata
