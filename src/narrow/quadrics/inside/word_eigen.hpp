#pragma once

#include <array>

#include "math/number_vector.hpp"

namespace toccata {

/// The root of a number that is not negative.
[[nodiscard]] DoubleWord root_of(const DoubleWord& a);

/// Eigenvalues, the greatest first, and eigenvectors of length 1.
struct WordEigen {
  std::array<DoubleWord, 3> value;
  std::array<VectorOf<DoubleWord>, 3> axis;
};

/// The eigenvalues and axes of a symmetric matrix, off by some 2⁻¹⁰⁰ of its greatest entry: by rotations (C. G. J.
/// Jacobi, 1846).
[[nodiscard]] WordEigen word_eigen(std::array<VectorOf<DoubleWord>, 3> matrix);

}  // namespace toccata
