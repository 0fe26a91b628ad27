#pragma once

#include <array>
#include <cstddef>

#include "math/number_vector.hpp"
#include "narrow/quadrics/plain_body.hpp"

namespace toccata {

/// The same body with bounds on what its numbers are off by: what proofs look at.
class QuadricBody : public PlainBody {
 public:
  QuadricBody(const PosedQuadric& shape, const PairFrame& frame);
  QuadricBody(const PosedPolytope& shape, const PairFrame& frame);
  explicit QuadricBody(const BoundedVector& point);

  [[nodiscard]] BoundedVector centre(Index generator) const;
  [[nodiscard]] const BoundedVector& column(std::size_t j) const { return column_[j]; }
  /// For a quadric: the images of its half axes, of the radius twice and the half height.
  [[nodiscard]] const std::array<BoundedVector, 3>& axes() const { return axes_; }
  /// The body of a quadric, moved.
  [[nodiscard]] QuadricBody moved(const BoundedVector& by) const;
  /// The body of a quadric, made smaller around its middle by a part of its size.
  [[nodiscard]] QuadricBody made_smaller(double part) const;
  /// For a quadric: the map that makes it as long as it is wide, rounded.
  [[nodiscard]] Mat3 roundness() const;
  /// The middle of a quadric, or of the first few vertices of a polytope.
  [[nodiscard]] BoundedVector middle_point() const { return hull_ == nullptr ? middle_ : middle_of_vertices(); }

 private:
  [[nodiscard]] BoundedVector middle_of_vertices() const;

  std::array<BoundedVector, 2> centre_{};
  std::array<BoundedVector, 3> column_{};
  std::array<BoundedVector, 3> axes_{};
  BoundedVector middle_{};  ///< but of a polytope
};

}  // namespace toccata
