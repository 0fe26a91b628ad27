#pragma once

#include <array>

#include "math/exact.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// A plane as it is chosen: through a point with a normal, or through three points.
struct PlaneChoice {
  Vec3 through;
  Vec3 normal;  ///< about it, where the plane is that of three points
  bool of_points = false;
  std::array<Vec3, 2> others{};  ///< with `through` the three points
};

/// The same with an exact normal. Exact signs of points beside it.
class CutPlane {
 public:
  explicit CutPlane(const PlaneChoice& choice);

  [[nodiscard]] const PlaneChoice& choice() const { return choice_; }
  [[nodiscard]] const RationalPoint& normal() const { return normal_; }
  [[nodiscard]] const Rational& offset() const { return offset_; }

  /// Positive on the side that the normal points to.
  [[nodiscard]] Sign side(const Vec3& point) const;
  [[nodiscard]] Sign side(const RationalPoint& point) const { return sign_of(height(point)); }
  /// Times the length of the normal.
  [[nodiscard]] Rational height(const RationalPoint& point) const { return dot(normal_, point) - offset_; }

 private:
  PlaneChoice choice_;
  RationalPoint normal_;
  Rational offset_;
  Vec3 rounded_normal_;
};

}  // namespace toccata
