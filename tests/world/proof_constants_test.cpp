// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include "toccata/world/world.hpp"

namespace toccata {
namespace {

// The margins are 1 and three quarters of a last place of 1, so that their sum is rounded up; the points are as far
// apart as that. With boxes grown by the margins, a quarter of a last place is between them.
TEST(ProofConstants, BodiesThatAreAsNearAsTheRoundedSumOfTheirMarginsAreAPair) {
  const double small = 0x3p-54, distance = 1 + 0x1p-52;
  ASSERT_EQ(small + 1, distance);
  World world;
  world.add({Body{.model = Point({0, 0, 0}), .margin = small}, Body{.model = Point({distance, 0, 0}), .margin = 1}});
  EXPECT_EQ(world.step().begin.size(), 1);
}

}  // namespace
}  // namespace toccata
