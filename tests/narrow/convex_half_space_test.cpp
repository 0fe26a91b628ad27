#include "toccata/narrow/convex_convex.hpp"

#include <gtest/gtest.h>

#include "narrow/convex_half_space_checks.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

const PosedHalfSpace ground(HalfSpace({0, 0, 0}, {0, 0, 1}));

TEST(HalfSpace, AgreesWithTheOracleForEveryKindAndRegime) {
  std::uint64_t number = 0;
  for (int round = 0; round < 4; ++round)
    for (const std::string& kind : test::convex_kinds())
      for (const std::string& regime : test::convex_regimes()) {
        Random random(++number);
        const test::HalfSpaceCase pair = test::half_space_case(kind, regime, random);
        ASSERT_EQ(test::half_space_fault(pair), "")
            << kind << ", " << regime << ", seed " << number << ": " << to_text(pair);
      }
}

TEST(HalfSpace, ASphereTouchesExactly) {
  for (const double height : {3.0, 3e-200, 3e200}) {
    const PosedPolytope touching(Sphere(height, {0, 0, height}));
    EXPECT_EQ(relation(touching, ground).kind, RelationKind::touching);
    EXPECT_TRUE(overlap(touching, ground));
    const PosedPolytope apart(Sphere(height, {0, 0, std::nextafter(height, HUGE_VAL)}));
    EXPECT_FALSE(overlap(apart, ground));
    const PosedPolytope deep(Sphere(height, {0, 0, std::nextafter(height, 0)}));
    EXPECT_EQ(relation(deep, ground).kind, RelationKind::overlapping);
    EXPECT_EQ(penetration(touching, ground).upper, 0);
    EXPECT_GT(penetration(deep, ground).lower, 0);
  }
}

TEST(HalfSpace, TheNormalsLengthDoesNotMatterAndNeedNotBeADouble) {
  // The distance of the centre from the plane x + y + z ≤ 0 is 3/√3 · 2: no double.
  const PosedPolytope sphere(Sphere(1, {2, 2, 2}));
  for (const double length : {1.0, 0x1p-300, 0x1p300}) {
    const Distance d = distance(sphere, PosedHalfSpace(HalfSpace({0, 0, 0}, {length, length, length})));
    EXPECT_EQ(d.upper, std::nextafter(d.lower, HUGE_VAL));
    EXPECT_NEAR(d.lower, 2 * std::sqrt(3) - 1, 1e-15);
    EXPECT_NEAR(d.on_a.x, 2 - 1 / std::sqrt(3), 1e-15);
    EXPECT_EQ(d.on_b, Vec3{});
  }
}

TEST(HalfSpace, ARestingBoxHasFourContactsWithStableNames) {
  const PosedPolytope box(Box({1, 2, 3}), Pose::translation(0, 0, 3));
  const Manifold resting = manifold(box, ground);
  EXPECT_EQ(resting.count, 4);
  EXPECT_EQ(resting.normal, (Vec3{0, 0, -1}));
  const PosedPolytope tilted(Box({1, 2, 3}), {rotation_about({1, 1, 0}, 1e-6), {0, 0, 3}});
  const Manifold later = manifold(tilted, ground);
  EXPECT_EQ(later.count, 4);
  const auto names = [](const Manifold& m) {
    std::vector<Index> result;
    for (int i = 0; i < m.count; ++i) result.push_back(m.points[static_cast<std::size_t>(i)].on_a.index);
    std::ranges::sort(result);
    return result;
  };
  EXPECT_EQ(names(resting), names(later));
  EXPECT_EQ(manifold(PosedPolytope(Box({1, 2, 3}), Pose::translation(0, 0, 3 + 1e-15)), ground).count, 0);
}

TEST(HalfSpace, ACapsuleLyingHasTwoContactsAndStandingOne) {
  EXPECT_EQ(manifold(PosedPolytope(Capsule({-1, 0, 0.5}, {1, 0, 0.5}, 0.5)), ground).count, 2);
  EXPECT_EQ(manifold(PosedPolytope(Capsule({0, 0, 0.5}, {0, 0, 2}, 0.5)), ground).count, 1);
  EXPECT_EQ(manifold(PosedPolytope(Capsule({0, 0, 0.5}, {0, 0, 0.5}, 0.5)), ground).count, 1);
}

TEST(HalfSpace, TwoOfThemMeetUnlessTheyFaceEachOther) {
  const PosedHalfSpace above(HalfSpace({5, 5, 2}, {0, 0, -3}));
  EXPECT_FALSE(overlap(ground, above));
  EXPECT_EQ(distance(ground, above).lower, 2);
  EXPECT_EQ(distance(ground, above).upper, 2);
  const PosedHalfSpace facing(HalfSpace({5, 5, 0}, {0, 0, -3}));
  EXPECT_EQ(relation(ground, facing).kind, RelationKind::touching);
  const PosedHalfSpace below(HalfSpace({5, 5, -1}, {0, 0, 7}));
  EXPECT_EQ(relation(ground, below).containment, Containment::b_in_a);
  EXPECT_EQ(relation(below, ground).containment, Containment::a_in_b);
  EXPECT_EQ(relation(ground, PosedHalfSpace(HalfSpace({9, 9, 0}, {0, 0, 5}))).containment, Containment::equal);
  const PosedHalfSpace leaning(HalfSpace({0, 0, 1e300}, {1e-300, 0, -1}));
  EXPECT_TRUE(overlap(ground, leaning));
}

TEST(HalfSpace, TwoOfThemAgreeWithTheOracle) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto small = [&] { return static_cast<double>(random.below(5)) - 2; };
    const auto vector = [&] {
      const double x = small(), y = small(), z = small();
      return Vec3{x, y, z};
    };
    const Vec3 p = vector(), q = vector();
    Vec3 n = vector(), m = random.below(2) == 0 ? vector() : small() * n;
    if (n == Vec3{}) n = {1, 0, 0};
    if (m == Vec3{}) m = -n;
    const PosedHalfSpace a(HalfSpace(p, n)), b(HalfSpace(q, m));
    EXPECT_EQ(test::relation_fault(relation(a, b),
                                   oracle::relation(oracle::half_space_set(p, n), oracle::half_space_set(q, m))),
              "");
    const Distance d = distance(a, b), e = distance(b, a);
    EXPECT_EQ(d.lower, e.lower);
    EXPECT_EQ(d.upper == 0, overlap(a, b));
    if (d.upper == 0) {
      EXPECT_EQ(d.on_a, e.on_a);
      EXPECT_LT(dot(d.on_a - p, n), 1e-12);
      EXPECT_LT(dot(d.on_a - q, m), 1e-12);
    }
  }
}

TEST(HalfSpace, BadPosesAreRefused) {
  const HalfSpace shape({0, 0, 0}, {0, 0, 1});
  EXPECT_THROW(PosedHalfSpace(shape, {Mat3{{Vec3{2, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, {}}), Error);
  EXPECT_THROW(PosedHalfSpace(shape, Pose::translation(HUGE_VAL, 0, 0)), Error);
  EXPECT_THROW(static_cast<void>(penetration(PosedPolytope(Point({0, 0, -1})), ground)), Error);
}

}  // namespace
}  // namespace toccata
