#pragma once

#include <array>
#include <cstddef>

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

/// Each number of a product is summed in the order of `dot`.
constexpr Vec3 operator*(const Mat3& m, const Vec3& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
  const Vec3 x = a * b.column(0), y = a * b.column(1), z = a * b.column(2);
  return {{Vec3{x.x, y.x, z.x}, Vec3{x.y, y.y, z.y}, Vec3{x.z, y.z, z.z}}};
}

constexpr Mat3 transpose(const Mat3& m) { return {{m.column(0), m.column(1), m.column(2)}}; }

inline bool is_finite(const Mat3& m) { return is_finite(m[0]) && is_finite(m[1]) && is_finite(m[2]); }

/// Three directions of unit length at right angles to each other to within 2⁻⁴⁸, as the rows, right-handed: the first
/// along `first`, the second in the plane of both. What has no direction, or that of the first, is replaced by a
/// coordinate axis. Any length.
[[nodiscard]] Mat3 orthonormal_axes(const Vec3& first, const Vec3& second);

/// The eigenvectors of a symmetric matrix as the rows of `axes`, by descending eigenvalue. Right-handed, the component
/// of greatest magnitude of the first two is positive: the same matrix gives the same axes.
struct SymmetricEigen {
  Vec3 values;
  Mat3 axes;
};

/// Only the upper triangle is read; all entries finite and of magnitude below 2^500. By rotations in a fixed order
/// (C. G. J. Jacobi, 1846), always the same number of rounds. Eigenvalues are off by some units in the last place of
/// the greatest. Where two are equal any axes between them will do, and are not told apart.
[[nodiscard]] SymmetricEigen symmetric_eigen(const Mat3& matrix);

}  // namespace toccata
