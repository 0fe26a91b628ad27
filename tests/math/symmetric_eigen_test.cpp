#include "toccata/math/mat3.hpp"

#include <gtest/gtest.h>

#include "toccata/core/random.hpp"

namespace toccata {
namespace {

/// The farthest that A Aᵀ is from the identity.
double skew_of(const Mat3& axes) {
  double skew = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) skew = std::max(skew, std::fabs(dot(axes[i], axes[j]) - (i == j ? 1 : 0)));
  return skew;
}

Mat3 random_symmetric(Random& random) {
  Mat3 m;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) m[i][j] = m[j][i] = random.below(4) == 0 ? 0 : random.between(-1, 1);
  return m;
}

TEST(SymmetricEigen, VectorsAreMappedToMultiplesOfThemselves) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(Random(seed).bits());
    const Mat3 m = random_symmetric(random);
    const SymmetricEigen eigen = symmetric_eigen(m);
    EXPECT_GE(eigen.values.x, eigen.values.y);
    EXPECT_GE(eigen.values.y, eigen.values.z);
    EXPECT_LT(skew_of(eigen.axes), 0x1p-49);
    EXPECT_GT(dot(cross(eigen.axes[0], eigen.axes[1]), eigen.axes[2]), 0.99);
    for (int i = 0; i < 3; ++i) {
      const Vec3 mapped{dot(m[0], eigen.axes[i]), dot(m[1], eigen.axes[i]), dot(m[2], eigen.axes[i])};
      const Vec3 rest = mapped - eigen.values[i] * eigen.axes[i];
      EXPECT_LT(std::sqrt(dot(rest, rest)), 1e-14);
    }
  }
}

TEST(SymmetricEigen, ADiagonalIsSorted) {
  const SymmetricEigen eigen = symmetric_eigen({{Vec3{1, 0, 0}, Vec3{0, 3, 0}, Vec3{0, 0, 2}}});
  EXPECT_EQ(eigen.values, (Vec3{3, 2, 1}));
  EXPECT_EQ(eigen.axes[0], (Vec3{0, 1, 0}));
  EXPECT_EQ(eigen.axes[1], (Vec3{0, 0, 1}));
}

TEST(OrthonormalAxes, AreSoForWhatHasNoDirectionToo) {
  const Vec3 some{1, 2, -3}, zero{}, tiny{0, 3e-310, 1e-310};
  const double unbounded = HUGE_VAL;
  for (const auto& [first, second] : {std::pair{some, zero},
                                      {zero, some},
                                      {zero, zero},
                                      {some, some},
                                      {tiny, some},
                                      {Vec3{1e300, 1e300, 0}, tiny},
                                      {some, 2 * some + Vec3{0x1p-50, 0, 0}},
                                      {Vec3{unbounded, 0, 0}, some},
                                      {some, Vec3{std::nan(""), 0, 0}}})
    EXPECT_LT(skew_of(orthonormal_axes(first, second)), 0x1p-49);
}

}  // namespace
}  // namespace toccata
