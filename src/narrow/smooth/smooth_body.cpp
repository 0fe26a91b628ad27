#include "narrow/smooth/smooth_body.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

/// Heights of plain centres are off by less than this part of the centres' greatest sum of magnitudes, for directions
/// of length 1.
constexpr double height_rounding = 0x1p-48;

double reach_of(const PosedSmooth& shape) {
  double largest = 0;
  for (const Vec3& row : shape.pose().linear.row) largest = std::fmax(largest, dot(magnitudes(row), shape.half()));
  return largest;
}

/// Of a hull only its own box is looked at.
double reach_from(const PosedConvex& shape, const Vec3& origin) {
  double largest = 0;
  if (shape.in_world()) {
    for (Index i = 0; i < shape.vertex_count(); ++i)
      largest = std::fmax(largest, largest_magnitude(shape.vertex(i) - origin));
  } else {
    for (const Vec3& row : shape.pose().linear.row)
      largest = std::fmax(largest, shape.stored_extent() * sum_of_magnitudes(row));
    largest += largest_magnitude(shape.pose().offset - origin);
  }
  return largest + shape.radius();
}

/// Brings the size to about 1.
PairFrame frame_of(const Vec3& origin, double size) {
  if (!std::isfinite(size)) return {origin, 0x1p-1000};
  return {origin, std::scalbn(1.0, std::clamp(-std::ilogb(size), -1000, 1000))};
}

BoundedVector zero_vector() { return {exactly(0), exactly(0), exactly(0)}; }

}  // namespace

PairFrame pair_frame(const PosedSmooth& a, const PosedSmooth& b) {
  const double between = largest_magnitude(b.pose().offset - a.pose().offset);
  return frame_of(a.pose().offset, std::fmax(reach_of(a), reach_of(b) + between));
}

PairFrame pair_frame(const PosedSmooth& a, const PosedConvex& b) {
  return frame_of(a.pose().offset, std::fmax(reach_of(a), reach_from(b, a.pose().offset)));
}

BoundedVector PairFrame::place(const Vec3& world) const {
  // What is multiplied first may lose its last digits below the range, what is multiplied last not.
  BoundedVector placed;
  for (int i = 0; i < 3; ++i) {
    BoundedNumber& x = placed[static_cast<std::size_t>(i)];
    x = factor < 1 ? bounded_difference(factor * world[i], factor * origin[i])
                   : bounded_difference(world[i], origin[i]);
    if (factor > 1) x.value = {factor * x.value.high, factor * x.value.low};
    if (factor < 1) x.error = BoundedNumber::underflow;
  }
  return placed;
}

BoundedVector PairFrame::scaled(const Vec3& world) const {
  BoundedVector result = exactly(factor * world);
  for (BoundedNumber& x : result) x.error = factor < 1 ? BoundedNumber::underflow : 0;
  return result;
}

Vec3 PairFrame::back(const Vec3& placed) const {
  if (factor < 1) return (1 / factor) * (placed + factor * origin);
  return origin + (1 / factor) * placed;
}

SmoothBody::SmoothBody(const PosedSmooth& shape, const PairFrame& frame)
    : frame_(frame), is_cone_(shape.kind() == PosedSmooth::Kind::cone), kind_(shape.kind()) {
  const Mat3& linear = shape.pose().linear;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      axes_[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] =
          exactly(linear[i][j]) * exactly(frame.factor * shape.half()[j]);
  middle_ = frame.place(shape.pose().offset);
  column_ = axes_;
  const bool is_ellipsoid = shape.kind() == PosedSmooth::Kind::ellipsoid;
  columns_ = is_ellipsoid ? 3 : 2;
  count_ = is_ellipsoid ? 1 : 2;
  centre_[0] = is_ellipsoid ? middle_ : middle_ - axes_[2];
  centre_[1] = middle_ + axes_[2];
  for (std::size_t j = 0; j < columns_; ++j) plain_column_[j] = plain(column_[j]);
  for (Index i = 0; i < count_; ++i) plain_centre_[i] = plain(centre_[i]);
}

SmoothBody::SmoothBody(const PosedConvex& shape, const PairFrame& frame, const SupportKernels& kernels)
    : hull_(&shape), frame_(frame), count_(shape.vertex_count()) {
  if (shape.radius() > 0) {
    columns_ = 3;
    for (std::size_t j = 0; j < 3; ++j) {
      column_[j] = zero_vector();
      column_[j][j] = exactly(frame.factor * shape.radius());
      plain_column_[j] = plain(column_[j]);
    }
  }
  if (shape.in_world()) {
    for (Index i = 0; i < count_; ++i) plain_centre_[i] = plain(centre(i));
  } else {
    search_.emplace(shape, kernels);
  }
  middle_ = centre(0);
  const BoundedNumber part = exactly(1.0 / std::min<Index>(count_, 8));
  middle_ = zero_vector();
  for (Index i = 0; i < std::min<Index>(count_, 8); ++i) middle_ = middle_ + part * centre(i);
}

SmoothBody::SmoothBody(const BoundedVector& point) : count_(1), middle_(point) {
  centre_[0] = point;
  plain_centre_[0] = plain(point);
}

SmoothBody SmoothBody::moved(const BoundedVector& by) const {
  SmoothBody result = *this;
  result.middle_ = middle_ + by;
  for (Index i = 0; i < count_; ++i) {
    result.centre_[i] = centre_[i] + by;
    result.plain_centre_[i] = plain(result.centre_[i]);
  }
  return result;
}

Mat3 SmoothBody::roundness() const {
  const Vec3 x = plain(axes_[0]), y = plain(axes_[1]), z = plain(axes_[2]);
  const Vec3 normal = cross(y, z);
  const double part = 1 / dot(normal, x);
  return {{part * normal, part * cross(z, x), part * cross(x, y)}};
}

BoundedVector SmoothBody::centre(Index atom) const {
  return hull_ == nullptr ? centre_[atom] : frame_.place(hull_->vertex(atom));
}

Vec3 SmoothBody::plain_centre(Index atom) const {
  return search_ ? plain(frame_.place(search_->vertex(atom))) : plain_centre_[atom];
}

Vec3 SmoothBody::along_columns(const Vec3& direction) const {
  Vec3 along;
  for (std::size_t j = 0; j < columns_; ++j) along[static_cast<int>(j)] = dot(direction, plain_column_[j]);
  return along;
}

Vec3 SmoothBody::map(const Vec3& round) const {
  Vec3 mapped;
  for (std::size_t j = 0; j < columns_; ++j) mapped = mapped + round[static_cast<int>(j)] * plain_column_[j];
  return mapped;
}

SmoothSupport SmoothBody::support(const Vec3& direction) const {
  const Vec3 along = along_columns(direction);
  const double growth = plain_length(along);
  SmoothSupport found;
  if (search_) {
    found.atom = search_->least(-direction);
  } else {
    double highest = -HUGE_VAL;
    for (Index i = 0; i < count_; ++i) {
      const double height = dot(direction, plain_centre_[i]) + (grown(i) ? growth : 0);
      if (!(height > highest)) continue;
      highest = height;
      found.atom = i;
    }
  }
  found.point = plain_centre(found.atom);
  if (!grown(found.atom) || !(growth > 0)) return found;
  found.round = (1 / growth) * along;
  found.point = found.point + map(found.round);
  return found;
}

Index SmoothBody::highest_atoms(const Vec3& direction, std::span<Index> found) const {
  if (search_) {
    const Vec3 highest = search_->vertex(search_->least(-direction));
    return search_->close(-direction, 0x1p-52, highest, {}, found);
  }
  if (count_ <= 2) {
    for (Index i = 0; i < count_; ++i) found[i] = i;
    return count_;
  }
  std::array<double, 8> height{};
  double highest = -HUGE_VAL, size = 0;
  for (Index i = 0; i < count_; ++i) {
    height[i] = dot(direction, plain_centre_[i]);
    highest = std::fmax(highest, height[i]);
    size = std::fmax(size, sum_of_magnitudes(plain_centre_[i]));
  }
  Index written = 0;
  for (Index i = 0; i < count_; ++i)
    if (!(height[i] < highest - height_rounding * size)) found[written++] = i;
  return written;
}

}  // namespace toccata
