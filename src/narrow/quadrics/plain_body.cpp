#include "narrow/quadrics/plain_body.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/quadrics/kinds/quadric_kind.hpp"

namespace toccata {
namespace {

/// Heights of plain centres are off by less than this part of the centres' greatest sum of magnitudes, for directions
/// of length 1.
constexpr double centre_height_rounding = 0x1p-48;

/// What the image of a ball reaches: squares of products below this are lost.
constexpr double lost_in_squares = 0x1p-500;

}  // namespace

PlainBody::PlainBody(const PosedQuadric& shape, const PairFrame& frame) : frame_(frame), kind_(shape.kind()) {
  with_kind(shape.kind(), [&](auto kind) {
    count_ = kind.generators;
    columns_ = kind.columns;
    has_tip_ = kind.has_tip;
  });
  const Mat3& linear = shape.pose().linear;
  const Vec3 half = frame.factor * shape.half(), middle = frame.plainly_placed(shape.pose().offset);
  for (int j = 0; j < static_cast<int>(columns_); ++j)
    plain_column_[static_cast<std::size_t>(j)] = half[j] * linear.column(j);
  const Vec3 upwards = count_ == 1 ? Vec3{} : half.z * linear.column(2);
  plain_centre_[0] = middle - upwards;
  plain_centre_[1] = middle + upwards;
}

PlainBody::PlainBody(const PosedPolytope& shape, const PairFrame& frame)
    : hull_(&shape), frame_(frame), count_(shape.vertex_count()) {
  if (shape.radius() > 0) {
    columns_ = 3;
    for (std::size_t j = 0; j < 3; ++j) plain_column_[j][static_cast<int>(j)] = frame.factor * shape.radius();
  }
  if (!shape.in_world())
    search_.emplace(shape);
  else
    for (Index i = 0; i < count_; ++i) plain_centre_[i] = frame.plainly_placed(shape.vertex(i));
}

QuadricSupport PlainBody::support(const Vec3& direction) const {
  QuadricSupport found;
  Vec3 along;
  double growth = 0;
  if (columns_ > 0) {
    along = along_columns(direction);
    growth = plain_length(along);
  }
  if (search_) {
    found.generator = search_->search.least(-direction);
  } else {
    double highest = -HUGE_VAL;
    for (Index i = 0; i < count_; ++i) {
      const double height = dot(direction, plain_centre_[i]) + (i == 1 && has_tip_ ? 0 : growth);
      found.generator = height > highest ? i : found.generator;
      highest = height > highest ? height : highest;
    }
  }
  found.point = plain_centre(found.generator);
  if (!grown(found.generator) || !(growth > 0)) return found;
  found.round = (1 / growth) * along;
  found.point = found.point + map(found.round);
  return found;
}

/// Centres and columns are rounded once; products, sums and the root a handful of times.
double PlainBody::height_at_most(const Vec3& direction) const {
  const Vec3 size = magnitudes(direction);
  double growth = 0, magnitude = 0;
  if (columns_ > 0) {
    growth = plain_length(along_columns(direction));
    for (std::size_t j = 0; j < columns_; ++j) magnitude += dot(size, magnitudes(plain_column_[j]));
  }
  double highest = -HUGE_VAL, greatest = 0;
  if (search_) {
    const double of_vertices = -search_->search.lower_bound(-direction), of_origin = dot(direction, frame_.origin);
    highest = frame_.factor * (of_vertices - of_origin) + growth;
    greatest = frame_.factor * (std::fabs(of_vertices) + dot(size, magnitudes(frame_.origin)));
  } else {
    for (Index i = 0; i < count_; ++i) {
      highest = std::fmax(highest, dot(direction, plain_centre_[i]) + (i == 1 && has_tip_ ? 0 : growth));
      greatest = std::fmax(greatest, dot(size, magnitudes(plain_centre_[i])));
    }
  }
  return highest + (centre_height_rounding * (greatest + magnitude) + lost_in_squares);
}

PlainBody PlainBody::moved(const Vec3& by) const {
  PlainBody result = *this;
  for (Index i = 0; i < count_; ++i) result.plain_centre_[i] = plain_centre_[i] + by;
  return result;
}

Index PlainBody::highest_generators(const Vec3& direction, std::span<Index> found) const {
  if (search_) {
    const Vec3 highest = search_->search.vertex(search_->search.least(-direction));
    return search_->search.close(-direction, 0x1p-52, highest, {}, found);
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
    if (!(height[i] < highest - centre_height_rounding * size)) found[written++] = i;
  return written;
}

}  // namespace toccata
