#include "narrow/convex/difference_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

constexpr Index block = 8;  ///< a loop of constant length becomes vector instructions

/// World coordinates, by the formula of the truth page.
void place(const PosedPolytope& shape, const std::array<double*, 3>& world) {
  const Index count = shape.padded_count();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vec3& row = shape.pose().linear[static_cast<int>(axis)];
    const double offset = shape.pose().offset[static_cast<int>(axis)];
    const double *x = shape.along(0), *y = shape.along(1), *z = shape.along(2);
    double* const to = world[axis];
    if (shape.in_world()) {
      std::copy_n(shape.along(static_cast<int>(axis)), count, to);
      continue;
    }
    for (Index first = 0; first < count; first += block)
      for (Index i = first; i < first + block; ++i) to[i] = ((row.x * x[i] + row.y * y[i]) + row.z * z[i]) + offset;
  }
}

struct Range {
  double least, greatest;
};

Range range_of(const double* values, Index count) {
  std::array<double, block> least, greatest;
  std::copy_n(values, block, least.begin());
  greatest = least;
  for (Index first = block; first < count; first += block)
    for (Index i = 0; i < block; ++i) {
      const double value = values[first + i];
      least[i] = value < least[i] ? value : least[i];
      greatest[i] = value > greatest[i] ? value : greatest[i];
    }
  return {*std::min_element(least.begin(), least.end()), *std::max_element(greatest.begin(), greatest.end())};
}

}  // namespace

CoreVertices::CoreVertices(const PosedPolytope& shape) : count_(shape.vertex_count()), padded_(shape.padded_count()) {
  if (count_ > few) many_ = std::make_unique_for_overwrite<double[]>(std::size_t{6} * padded_);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    world_[axis] = many_ ? many_.get() + axis * padded_ : few_[axis].data();
    relative_[axis] = many_ ? many_.get() + (axis + 3) * padded_ : few_[axis + 3].data();
  }
  place(shape, world_);
  for (int axis = 0; axis < 3; ++axis) {
    const Range range = range_of(world_[static_cast<std::size_t>(axis)], padded_);
    least_[axis] = range.least;
    greatest_[axis] = range.greatest;
  }
}

void CoreVertices::scale(double first, double second) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double* const from = world_[axis];
    double* const to = relative_[axis];
    const double origin = first * from[0];
    for (Index start = 0; start < padded_; start += block)
      for (Index i = start; i < start + block; ++i) to[i] = second * (first * from[i] - origin);
  }
}

int CoreVertices::least_exponent() const {
  int least = std::numeric_limits<int>::max();
  for (Index i = 0; i < count_; ++i)
    for (const double* along : world_)
      if (along[i] != 0) least = std::min(least, binary_fraction(along[i]).exponent);
  return least;
}

// The first factor keeps the differences finite, the second brings them to about 1.
DifferenceBody::DifferenceBody(const PosedPolytope& a, const PosedPolytope& b) : a_(a), b_(b) {
  const double largest = std::max({largest_magnitude(a_.least()), largest_magnitude(a_.greatest()),
                                   largest_magnitude(b_.least()), largest_magnitude(b_.greatest())});
  first_ = largest > 0x1p1000 ? 0x1p-100 : 1.0;
  const double reach = std::max(largest_magnitude(first_ * a_.greatest() - first_ * b_.least()),
                                largest_magnitude(first_ * b_.greatest() - first_ * a_.least()));
  second_ = reach > 0 ? std::ldexp(1.0, std::clamp(-std::ilogb(reach), -1000, 1000)) : 1.0;
  extent_ = second_ * reach;
  a_.scale(first_, second_);
  b_.scale(first_, second_);
}

DifferencePoint DifferenceBody::point(Index on_a, Index on_b) const {
  return {second_ * (first_ * a_[on_a] - first_ * b_[on_b]), on_a, on_b};
}

PrecisePoint DifferenceBody::precise_point(Index on_a, Index on_b) const {
  const Vec3 a = first_ * a_[on_a], b = first_ * b_[on_b];
  const auto along = [&](int axis) {
    const DoubleWord difference = exact_difference(a[axis], b[axis]);
    return DoubleWord{second_ * difference.high, second_ * difference.low};
  };
  return {along(0), along(1), along(2)};
}

DifferencePoint DifferenceBody::support(const Vec3& n) const {
  return point(kernels_.least(a_.scan(-n)), kernels_.least(b_.scan(n)));
}

Vec3 DifferenceBody::from_a_to_b() const {
  const double half = 0.5 * first_;
  return second_ * ((half * b_.least() + half * b_.greatest()) - (half * a_.least() + half * a_.greatest()));
}

int DifferenceBody::exact_exponent() const {
  if (!exact_exponent_) exact_exponent_ = std::min(a_.least_exponent(), b_.least_exponent());
  // All coordinates are zero: any unit will do.
  if (exact_exponent_ == std::numeric_limits<int>::max()) exact_exponent_ = 0;
  return *exact_exponent_;
}

IntegerVector DifferenceBody::exact_point(Index on_a, Index on_b) const {
  const int exponent = exact_exponent();
  return scaled_wide(a_[on_a], exponent) - scaled_wide(b_[on_b], exponent);
}

}  // namespace toccata
