#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "toccata/bounds/all_volumes.hpp"

namespace toccata {

/// Up to 13 directions: the normals of a volume's faces, of opposite ones one.
struct Directions {
  std::array<Vec3, 13> direction{};
  std::size_t count = 0;

  [[nodiscard]] std::span<const Vec3> span() const { return std::span(direction).first(count); }
};

inline Directions directions_of(const Mat3& axes) { return {{axes[0], axes[1], axes[2]}, 3}; }

inline Directions face_normals(const Aabb&) { return directions_of(Mat3{}); }
inline Directions face_normals(const Cube&) { return directions_of(Mat3{}); }
Directions face_normals(const Obb& box);

}  // namespace toccata
