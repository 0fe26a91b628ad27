#pragma once

#include <array>

#include "toccata/math/vec3.hpp"

namespace toccata {

/// A solid box along the axes of the shape's own frame. In the world it is the convex hull of its eight corners, each
/// rounded by itself.
class Box {
 public:
  /// `half_extents`: from the centre to the faces. Throws Error when one is not positive, a number is not finite, or a
  /// corner centre ± half extent overflows or falls together with its opposite.
  explicit Box(const Vec3& half_extents, const Vec3& centre = {});

  [[nodiscard]] const Vec3& half_extents() const { return half_extents_; }
  [[nodiscard]] const Vec3& centre() const { return centre_; }

  /// Corner i, of 8, in the shape's own frame: its x is centre.x + half_extents.x where bit 0 of i is set and
  /// centre.x − half_extents.x where not; bit 1 is y, bit 2 is z.
  [[nodiscard]] Vec3 corner(int i) const {
    const auto along = [i, this](int axis) {
      return (i >> axis & 1) != 0 ? centre_[axis] + half_extents_[axis] : centre_[axis] - half_extents_[axis];
    };
    return {along(0), along(1), along(2)};
  }

 private:
  Vec3 centre_;
  Vec3 half_extents_;
};

}  // namespace toccata
