#include "toccata/math/vec3.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "toccata/math/mat3.hpp"

namespace toccata {
namespace {

static_assert(Vec3{1, 2, 3} * 2 == Vec3{2, 4, 6} && Vec3{2, 4, 6} / 2 == Vec3{1, 2, 3});

TEST(Vec3, CompoundAssignments) {
  Vec3 v{1, 2, 3};
  v += {1, 1, 1};
  v *= 3;
  v -= {0, 3, 0};
  v /= 2;
  EXPECT_EQ(v, (Vec3{3, 3, 6}));
}

TEST(Vec3, LengthNeitherOverflowsNorUnderflows) {
  EXPECT_EQ(length(Vec3{3, 0, -4}), 5);
  EXPECT_EQ(length(Vec3{3e300, 0, -4e300}), 5e300);
  EXPECT_EQ(length(Vec3{0x3p-1074, 0x4p-1074, 0}), 0x5p-1074);
  EXPECT_EQ(length(Vec3{}), 0);
  EXPECT_EQ(length(Vec3{1, -INFINITY, 0}), INFINITY);
  EXPECT_TRUE(std::isnan(length(Vec3{1, NAN, 0})));
}

TEST(Vec3, NormalizedHasLengthOneWhateverTheSize) {
  for (const double size : {1.0, 1e300, 1e-300, 0x1p-1070}) {
    const Vec3 unit = normalized({3 * size, 0, -4 * size});
    EXPECT_NEAR(unit.x, 0.6, 1e-15);
    EXPECT_NEAR(unit.z, -0.8, 1e-15);
  }
  EXPECT_EQ(normalized({}), Vec3{});
  EXPECT_EQ(normalized({INFINITY, 0, 0}), Vec3{});
  EXPECT_EQ(normalized({0, NAN, 1}), Vec3{});
}

constexpr Mat3 some{{{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}}}, turn{{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}};

static_assert(some * Vec3{1, 0, -1} == Vec3{-2, -2, -3});
static_assert(turn * some == Mat3{{{{-4, -5, -6}, {1, 2, 3}, {7, 8, 10}}}});
static_assert(transpose(some)[0] == Vec3{1, 4, 7} && transpose(transpose(some)) == some &&
              turn * transpose(turn) == Mat3{});

}  // namespace
}  // namespace toccata
