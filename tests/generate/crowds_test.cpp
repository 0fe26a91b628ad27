#include "toccata/generate/crowds.hpp"

#include <gtest/gtest.h>

#include "toccata/core/error.hpp"

namespace toccata {
namespace {

TEST(Crowds, AreTheSameForTheSameSeedAndMove) {
  for (const NamedScene& scene : crowd_scenes()) {
    SCOPED_TRACE(scene.name);
    Crowd one(scene.name, 500, 3), same(scene.name, 500, 3), another(scene.name, 500, 4);
    EXPECT_EQ(one.boxes().size(), 500U);
    EXPECT_NE(one.boxes(), another.boxes());
    for (int frame = 0; frame < 5; ++frame) {
      const std::vector<Aabb> before = one.boxes();
      const std::span<const Index> moved = one.step();
      EXPECT_EQ(moved.size(), same.step().size());
      EXPECT_EQ(one.boxes(), same.boxes());
      std::vector<bool> may_move(500, false);
      for (const Index number : moved) may_move[number] = true;
      for (Index number = 0; number < 500; ++number) {
        EXPECT_EQ(one.boxes()[number] != before[number], may_move[number]) << number;
        EXPECT_FALSE(is_empty(one.boxes()[number]));
      }
    }
  }
}

TEST(Crowds, OfWhichMostStandStill) {
  Crowd crowd("static", 10'000);
  const std::size_t moving = crowd.step().size();
  EXPECT_GT(moving, 400U);
  EXPECT_LT(moving, 600U);
}

TEST(Crowds, OfAnUnknownNameAreRefused) {
  try {
    const Crowd crowd("unifrom", 5);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "there is no crowd 'unifrom'; did you mean 'uniform'?");
  }
}

}  // namespace
}  // namespace toccata
