#include "toccata/math/pose.hpp"

#include <gtest/gtest.h>

#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

TEST(Pose, TwelveNumbersRoundTrip) {
  const std::array<double, 12> numbers{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  EXPECT_EQ(Pose::from_numbers(numbers).numbers(), numbers);
}

TEST(Pose, IdentityLeavesEveryVertexAsItIs) {
  const Vec3 v{0.1, -2e300, 5e-324};
  EXPECT_EQ(transform(Pose{}, v), v);
}

TEST(Pose, ComposedTranslationsAdd) {
  EXPECT_EQ(Pose::translation(1, 2, 3) * Pose::translation(4, 5, 6), Pose::translation(5, 7, 9));
}

TEST(Pose, TimesAPointIsTheWorldVertex) {
  const Pose pose = Pose::from_numbers({1, 2, 3, 4, 5, 6, 7, 8, 10, 0.1, 0.2, 0.3});
  EXPECT_EQ((pose * Vec3{0.1, 0.2, 0.3}), transform(pose, Vec3{0.1, 0.2, 0.3}));
  EXPECT_EQ(Pose::translation(Vec3{1, 2, 3}), Pose::translation(1, 2, 3));
  EXPECT_EQ((Pose::rotation({0, 0, 1}, 90) * Vec3{1, 0, 0}), (Vec3{0, 1, 0}));
}

TEST(Pose, RigidDividesByTheLengthOfTheQuaternion) {
  const Pose pose = Pose::rigid({.z = 3, .w = 3}, {1, 2, 3});
  EXPECT_EQ(pose, (Pose{rotation_about({0, 0, 1}, 90), {1, 2, 3}}));
  EXPECT_THROW((void)Pose::rigid({0, 0, 0, 0}, {}), Error);
  EXPECT_THROW((void)Pose::rigid({NAN, 0, 0, 1}, {}), Error);
  EXPECT_EQ(Pose::nearest_rigid({{{Vec3{0, -2, 0}, {2, 0, 0}, {0, 0, 2}}}}, {1, 2, 3}), pose);
}

TEST(Pose, InverseIsTheNearestDoubleOfEachNumber) {
  EXPECT_EQ(inverse(Pose::rotation({0, 0, 1}, 90)), Pose::rotation({0, 0, 1}, -90));
  const Pose third{{{{Vec3{3, 0, 0}, {0, -7, 0}, {0, 0, 0x1p-1060}}}}, {6, 7, 0}};
  const Pose back{{{{Vec3{1.0 / 3, 0, 0}, {0, -1.0 / 7, 0}, {0, 0, 0}}}}, {-2, 1, 0}};
  EXPECT_THROW((void)inverse(third), Error);  // 2^1060 is no double
  Pose plain = third;
  plain.linear[2].z = 0x1p-1000;
  Pose plain_back = back;
  plain_back.linear[2].z = 0x1p1000;
  EXPECT_EQ(inverse(plain), plain_back);
  EXPECT_THROW((void)inverse({{{{Vec3{1, 2, 3}, {2, 4, 6}, {0, 0, 1}}}}, {}}), Error);
  EXPECT_THROW((void)inverse({{}, {INFINITY, 0, 0}}), Error);
}

TEST(Pose, InverseUndoes) {
  Random random(5);
  const auto number = [&] { return random.between(-1, 1); };
  for (int i = 0; i < 300; ++i) {
    Pose pose;
    for (Vec3& row : pose.linear.row) row = {number(), number(), number()};
    pose.offset = {number(), number(), number()};
    const Pose back = inverse(pose), same = pose * back;
    double size = 0;
    for (const Vec3& row : back.linear.row) size += length(row);
    for (int row = 0; row < 3; ++row) {
      EXPECT_NEAR(same.offset[row], 0, 1e-15 * size);
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(same.linear[row][j], row == j ? 1 : 0, 1e-15 * size);
    }
  }
}

}  // namespace
}  // namespace toccata
