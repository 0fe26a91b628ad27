#include "narrow/difference_body.hpp"

#include <algorithm>
#include <cmath>

namespace toccata {
namespace {

Vec3 lesser(const Vec3& p, const Vec3& q) { return {std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)}; }
Vec3 greater(const Vec3& p, const Vec3& q) { return {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}; }

double greatest_magnitude(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

}  // namespace

CoreVertices::CoreVertices(const PosedConvex& shape) : count_(shape.vertex_count()), padded_((count_ + 7) / 8 * 8) {
  if (count_ > few) {
    many_world_ = std::make_unique_for_overwrite<Vec3[]>(count_);
    many_along_ = std::make_unique_for_overwrite<double[]>(std::size_t{3} * padded_);
  }
  world_ = count_ > few ? many_world_.get() : few_world_.data();
  for (std::size_t axis = 0; axis < 3; ++axis)
    along_[axis] = count_ > few ? many_along_.get() + axis * padded_ : few_along_[axis].data();
  least_ = greatest_ = shape.vertex(0);
  for (Index i = 0; i < count_; ++i) {
    world_[i] = shape.vertex(i);
    least_ = lesser(least_, world_[i]);
    greatest_ = greater(greatest_, world_[i]);
  }
}

void CoreVertices::scale(double first, double second) {
  const Vec3 origin = first * world_[0];
  for (Index i = 0; i < count_; ++i) {
    const Vec3 relative = second * (first * world_[i] - origin);
    along_[0][i] = relative.x;
    along_[1][i] = relative.y;
    along_[2][i] = relative.z;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (Index i = count_; i < padded_; ++i) along_[axis][i] = along_[axis][count_ - 1];
}

Index CoreVertices::farthest(const Vec3& n) const {
  Index best = 0;
  double greatest = height(0, n);
  for (Index i = 1; i < count_; ++i) {
    const double here = height(i, n);
    best = here > greatest ? i : best;
    greatest = here > greatest ? here : greatest;
  }
  return best;
}

// The first factor keeps the differences finite, the second brings them to about 1.
DifferenceBody::DifferenceBody(const PosedConvex& a, const PosedConvex& b) : a_(a), b_(b) {
  const double largest = std::max({greatest_magnitude(a_.least()), greatest_magnitude(a_.greatest()),
                                   greatest_magnitude(b_.least()), greatest_magnitude(b_.greatest())});
  first_ = largest > 0x1p1000 ? 0x1p-100 : 1.0;
  const double reach = std::max(greatest_magnitude(first_ * a_.greatest() - first_ * b_.least()),
                                greatest_magnitude(first_ * b_.greatest() - first_ * a_.least()));
  second_ = reach > 0 ? std::ldexp(1.0, std::clamp(-std::ilogb(reach), -1000, 1000)) : 1.0;
  extent_ = second_ * reach;
  a_.scale(first_, second_);
  b_.scale(first_, second_);
}

DifferencePoint DifferenceBody::point(Index on_a, Index on_b) const {
  return {second_ * (first_ * a_[on_a] - first_ * b_[on_b]), on_a, on_b};
}

DifferencePoint DifferenceBody::support(const Vec3& n) const { return point(a_.farthest(n), b_.farthest(-n)); }

Vec3 DifferenceBody::from_a_to_b() const {
  const double half = 0.5 * first_;
  return second_ * ((half * b_.least() + half * b_.greatest()) - (half * a_.least() + half * a_.greatest()));
}

int DifferenceBody::exact_exponent() const {
  if (!exact_exponent_) exact_exponent_ = std::min(common_exponent(a_.world()), common_exponent(b_.world()));
  return *exact_exponent_;
}

IntegerVector DifferenceBody::exact_point(Index on_a, Index on_b) const {
  const int exponent = exact_exponent();
  return scaled_wide(a_[on_a], exponent) - scaled_wide(b_[on_b], exponent);
}

}  // namespace toccata
