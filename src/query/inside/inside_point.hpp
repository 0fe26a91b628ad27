#pragma once

#include <memory>

#include "query/inside/inside_interval.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/shapes/primitives.hpp"

namespace toccata {

struct RationalPoint;

/// A world point with rational coordinates, and the doubles around it, by which most questions about it are settled.
class ExactPoint {
 public:
  explicit ExactPoint(const Vec3& point);
  explicit ExactPoint(RationalPoint point);

  [[nodiscard]] RationalPoint rational() const;

  /// Contains the point; without extent along every axis where the coordinate is a double.
  [[nodiscard]] const Aabb& box() const { return box_; }

  [[nodiscard]] Interval around(int axis) const { return {box_.lower[axis], box_.upper[axis]}; }
  [[nodiscard]] bool is_double(int axis) const { return box_.lower[axis] == box_.upper[axis]; }

 private:
  std::shared_ptr<const RationalPoint> rational_;  ///< none where the coordinates are doubles
  Aabb box_;
};

/// The sign of predicates.hpp after dropping `axis`.
[[nodiscard]] Sign orient2d(const Vec3& a, const Vec3& b, const ExactPoint& p, int axis);

[[nodiscard]] Sign orient3d(const Triangle& t, const ExactPoint& p);

/// The point lies on the closed triangle, which may be without area.
[[nodiscard]] bool lies_on(const ExactPoint& p, const Triangle& t);

/// The orientation of the triangle after dropping `axis`: the sign of that component of its normal.
[[nodiscard]] Sign projected_orientation(const Triangle& t, int axis);

}  // namespace toccata
