#pragma once

#include <array>
#include <cstddef>

#include "narrow/smooth/number_vector.hpp"
#include "narrow/smooth/plain_body.hpp"

namespace toccata {

/// The same body with bounds on what its numbers are off by: what proofs look at.
class SmoothBody : public PlainBody {
 public:
  SmoothBody(const PosedSmooth& shape, const PairFrame& frame);
  SmoothBody(const PosedConvex& shape, const PairFrame& frame);
  explicit SmoothBody(const BoundedVector& point);

  [[nodiscard]] BoundedVector centre(Index atom) const;
  [[nodiscard]] const BoundedVector& column(std::size_t j) const { return column_[j]; }
  /// Of a smooth shape: the images of its half axes, of the radius twice and the half height.
  [[nodiscard]] const std::array<BoundedVector, 3>& axes() const { return axes_; }
  /// The body of a smooth shape, moved.
  [[nodiscard]] SmoothBody moved(const BoundedVector& by) const;
  /// The body of a smooth shape, made smaller around its middle by a part of its size.
  [[nodiscard]] SmoothBody made_smaller(double part) const;
  /// Of a smooth shape: the map that makes it as long as it is wide, rounded.
  [[nodiscard]] Mat3 roundness() const;
  /// Of a polytope, of the first few vertices.
  [[nodiscard]] BoundedVector middle_point() const { return hull_ == nullptr ? middle_ : middle_of_vertices(); }

 private:
  [[nodiscard]] BoundedVector middle_of_vertices() const;

  std::array<BoundedVector, 2> centre_{};
  std::array<BoundedVector, 3> column_{};
  std::array<BoundedVector, 3> axes_{};
  BoundedVector middle_{};  ///< but of a polytope
};

}  // namespace toccata
