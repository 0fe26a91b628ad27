#pragma once

#include <array>
#include <cstddef>

#include "narrow/quadrics/plain_body.hpp"

namespace toccata {

/// For those who look for the nearest of many triangles: which ones are certainly farther from a quadric than
/// another. By planes in doubles that touch the shape: the last ones that parted triangles from it mostly tell of those
/// beside them.
class QuadricBeyond {
 public:
  explicit QuadricBeyond(const PosedQuadric& shape);

  /// From here on the plane across this direction, from the shape to a triangle, is looked at as well. World
  /// coordinates.
  void look_along(const Vec3& direction);

  /// The distance of the triangle is more than the length, and by so much that its interval is too. False where that
  /// is not known.
  [[nodiscard]] bool is_beyond(const std::array<Vec3, 3>& corner, double length) const;

 private:
  PairFrame frame_;
  PlainBody body_;
  bool is_fast_;
  struct Plane {
    Vec3 direction;     ///< no longer than 1
    double height = 0;  ///< no point of the shape is higher along it
  };
  std::array<Plane, 8> planes_;
  std::size_t count_ = 0;  ///< of all until now, of which the last are kept
};

}  // namespace toccata
