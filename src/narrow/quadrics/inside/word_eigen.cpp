#include "narrow/quadrics/inside/word_eigen.hpp"

#include <cmath>
#include <utility>

namespace toccata {
namespace {

/// Rows p and q are replaced by c p − s q and s p + c q.
void rotate(FineVector& p, FineVector& q, const DoubleWord& c, const DoubleWord& s) {
  for (std::size_t i = 0; i < 3; ++i) {
    const DoubleWord x = p[i], y = q[i];
    p[i] = c * x - s * y;
    q[i] = s * x + c * y;
  }
}

/// Makes the entry at (p, q) nearly 0. The tangent need not be exact, as more rounds come, but the rotation has to be
/// one.
void turn(std::array<FineVector, 3>& m, std::array<FineVector, 3>& axis, std::size_t p, std::size_t q) {
  const double off = m[p][q].high;
  if (off == 0) return;
  const double cotangent = (m[q][q] - m[p][p]).high / (2 * off);
  if (!(std::fabs(cotangent) < 0x1p200)) return;
  const double tangent = std::copysign(1 / (std::fabs(cotangent) + std::sqrt(cotangent * cotangent + 1)), cotangent);
  const DoubleWord one{1, 0}, t{tangent, 0};
  const DoubleWord c = one / root_of(one + t * t), s = t * c;
  rotate(m[p], m[q], c, s);
  for (std::size_t i = 0; i < 3; ++i) {
    const DoubleWord x = m[i][p], y = m[i][q];
    m[i][p] = c * x - s * y;
    m[i][q] = s * x + c * y;
  }
  rotate(axis[p], axis[q], c, s);
}

}  // namespace

DoubleWord root_of(const DoubleWord& a) {
  const double root = std::sqrt(a.high);
  if (!(root > 0)) return {0, 0};
  const DoubleWord rest = a - double_word(two_product(root, root));
  return double_word(fast_two_sum(root, rest.high / (2 * root)));
}

WordEigen word_eigen(std::array<FineVector, 3> matrix) {
  std::array<FineVector, 3> axis{};
  for (std::size_t i = 0; i < 3; ++i) axis[i][i] = {1, 0};
  constexpr int rounds = 12;
  for (int round = 0; round < rounds; ++round) {
    turn(matrix, axis, 0, 1);
    turn(matrix, axis, 0, 2);
    turn(matrix, axis, 1, 2);
  }
  WordEigen eigen{{matrix[0][0], matrix[1][1], matrix[2][2]}, axis};
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}, {0, 1}})
    if (eigen.value[i].high < eigen.value[j].high) {
      std::swap(eigen.value[i], eigen.value[j]);
      std::swap(eigen.axis[i], eigen.axis[j]);
    }
  return eigen;
}

}  // namespace toccata
