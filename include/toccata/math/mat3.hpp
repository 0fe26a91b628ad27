#pragma once

#include <array>

#include "toccata/math/vec3.hpp"

namespace toccata {

/// A 3×3 matrix, stored by rows.
struct Mat3 {
  std::array<Vec3, 3> row{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

  constexpr const Vec3& operator[](int i) const { return row[static_cast<std::size_t>(i)]; }
  constexpr Vec3& operator[](int i) { return row[static_cast<std::size_t>(i)]; }

  constexpr Vec3 column(int j) const { return {row[0][j], row[1][j], row[2][j]}; }

  friend constexpr bool operator==(const Mat3&, const Mat3&) = default;
};

inline bool is_finite(const Mat3& m) { return is_finite(m[0]) && is_finite(m[1]) && is_finite(m[2]); }

}  // namespace toccata
