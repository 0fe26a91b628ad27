#include "narrow/quadrics/quadric_body.hpp"

#include <algorithm>

namespace toccata {
namespace {

BoundedVector zero_vector() { return {exactly(0), exactly(0), exactly(0)}; }

}  // namespace

QuadricBody::QuadricBody(const PosedQuadric& shape, const PairFrame& frame) : PlainBody(shape, frame) {
  const Mat3& linear = shape.pose().linear;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      axes_[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] =
          exactly(linear[i][j]) * exactly(frame.factor * shape.half()[j]);
  middle_ = frame.place(shape.pose().offset);
  column_ = axes_;
  centre_[0] = count_ == 1 ? middle_ : middle_ - axes_[2];
  centre_[1] = middle_ + axes_[2];
  for (std::size_t j = 0; j < columns_; ++j) plain_column_[j] = plain(column_[j]);
  for (Index i = 0; i < count_; ++i) plain_centre_[i] = plain(centre_[i]);
}

QuadricBody::QuadricBody(const PosedPolytope& shape, const PairFrame& frame) : PlainBody(shape, frame) {
  for (std::size_t j = 0; j < columns_; ++j) {
    column_[j] = zero_vector();
    column_[j][j] = exactly(frame.factor * shape.radius());
  }
}

QuadricBody::QuadricBody(const BoundedVector& point) : PlainBody(plain(point)), middle_(point) { centre_[0] = point; }

QuadricBody QuadricBody::moved(const BoundedVector& by) const {
  QuadricBody result = *this;
  result.middle_ = middle_ + by;
  for (Index i = 0; i < count_; ++i) {
    result.centre_[i] = centre_[i] + by;
    result.plain_centre_[i] = plain(result.centre_[i]);
  }
  return result;
}

QuadricBody QuadricBody::made_smaller(double part) const {
  QuadricBody result = *this;
  const BoundedNumber left = exactly(1.0) - exactly(part);
  for (Index i = 0; i < count_; ++i) {
    result.centre_[i] = middle_ + left * (centre_[i] - middle_);
    result.plain_centre_[i] = plain(result.centre_[i]);
  }
  for (std::size_t j = 0; j < columns_; ++j) {
    result.column_[j] = left * column_[j];
    result.plain_column_[j] = plain(result.column_[j]);
  }
  for (BoundedVector& axis : result.axes_) axis = left * axis;
  return result;
}

Mat3 QuadricBody::roundness() const {
  const Vec3 x = plain(axes_[0]), y = plain(axes_[1]), z = plain(axes_[2]);
  const Vec3 normal = cross(y, z);
  const double part = 1 / dot(normal, x);
  return {{part * normal, part * cross(z, x), part * cross(x, y)}};
}

BoundedVector QuadricBody::middle_of_vertices() const {
  const Index few = std::min<Index>(count_, 8);
  const BoundedNumber part = exactly(1.0) / exactly(few);
  BoundedVector result = zero_vector();
  for (Index i = 0; i < few; ++i) result = result + part * centre(i);
  return result;
}

BoundedVector QuadricBody::centre(Index generator) const {
  return hull_ == nullptr ? centre_[generator] : frame_.place(hull_->vertex(generator));
}

}  // namespace toccata
