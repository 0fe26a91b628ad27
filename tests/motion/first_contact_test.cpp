#include "motion/first_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "math/constants.hpp"

namespace toccata {
namespace {

/// Two points, of which the second goes straight on as seen from the first. They meet where it is not farther than
/// `pad`.
class TwoPoints final : public MovingPair {
 public:
  TwoPoints(const Vec3& from, const Vec3& way, double pad) : from_(from), way_(way), pad_(pad) {}

  Vec3 direction(double time) override {
    ++looks;
    return length(between(time)) > 0 ? normalized(between(time)) : Vec3{};
  }
  double separation(double time, const Vec3& direction) override { return dot(direction, between(time)) - pad_; }
  bool may_turn() const override { return true; }
  bool surely_meet(double time) override { return length(between(time)) <= pad_; }

  int looks = 0;

 private:
  [[nodiscard]] Vec3 between(double time) const { return from_ + time * way_; }

  Vec3 from_;
  Vec3 way_;
  double pad_;
};

constexpr double pad = 0x1p-50;

GapBounds straight(const Vec3& way) { return {length(way), 0, pad}; }

// The direction of the end is opposite to that of the beginning, and one that turns evenly between the two leaves a gap
// of (2t − 1)² / 2: the bound of its second derivative is met, and with one that is smaller the two would be free.
TEST(FirstContact, PointsThatPassThroughEachOtherAreNotFreeAlongADirectionThatTurns) {
  const Vec3 way{1, 0, 0};
  TwoPoints pair({-0.5, 0, 0}, way, pad);
  const auto contact = first_contact(pair, {}, straight(way));
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->lower, 0.5, 4 * pad);
  EXPECT_LE(contact->lower, 0.5);
}

// A direction that turns by nearly half a turn parts them, and none that rests.
TEST(FirstContact, APointThatPassesAnotherIsFree) {
  for (const double aside : {1.0, 0.1, 1e-3, 1e-6, 1e-9}) {
    const Vec3 way{1, 0, 0};
    TwoPoints pair({-0.5, aside, 0}, way, pad);
    EXPECT_FALSE(first_contact(pair, {}, straight(way))) << aside;
  }
}

TEST(FirstContact, NearAContactTheGapIsSquared) {
  const Vec3 way{1, 1, 0};
  TwoPoints pair({-0.75, -0.75, 0}, way, pad);
  const auto contact = first_contact(pair, {}, straight(way));
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->lower, 0.75, 8 * pad);
  EXPECT_LE(pair.looks, 8);
}

}  // namespace
}  // namespace toccata
