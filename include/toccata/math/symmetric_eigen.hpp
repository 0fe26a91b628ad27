#pragma once

#include "toccata/math/mat3.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

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
