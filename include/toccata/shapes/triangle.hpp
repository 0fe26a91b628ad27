#pragma once

#include <array>

#include "toccata/math/vec3.hpp"

namespace toccata {

/// Three vertices; the set is their convex hull, which may be a segment or a point. Its normal is
/// (v1 − v0) × (v2 − v0): out of the solid when vertices turn counter-clockwise seen from outside.
struct Triangle {
  std::array<Vec3, 3> vertex;

  constexpr const Vec3& operator[](int i) const { return vertex[static_cast<std::size_t>(i)]; }
  constexpr Vec3& operator[](int i) { return vertex[static_cast<std::size_t>(i)]; }

  friend constexpr bool operator==(const Triangle&, const Triangle&) = default;
};

/// It is neither a segment nor a point; exact.
[[nodiscard]] bool has_area(const Triangle& t);

}  // namespace toccata
