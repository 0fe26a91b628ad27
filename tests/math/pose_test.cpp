#include "toccata/math/pose.hpp"

#include <gtest/gtest.h>

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
  EXPECT_EQ(compose(Pose::translation(1, 2, 3), Pose::translation(4, 5, 6)), Pose::translation(5, 7, 9));
}

}  // namespace
}  // namespace toccata
