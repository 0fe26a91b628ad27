#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "narrow/convex/apart_cores.hpp"
#include "narrow/convex/core_separation.hpp"
#include "narrow/convex/precise_facet.hpp"
#include "narrow/penetration_checks.hpp"
#include "toccata/math/pose.hpp"

// Contacts as deep as those of a simulation are, 10⁻² to 10⁻¹⁰ of the shapes, and shapes a little apart, compared with
// rational arithmetic.
namespace toccata::test {
namespace {

class ShallowPairs {
 public:
  explicit ShallowPairs(std::uint64_t seed) : random_(seed) {}

  ConvexShape shape(std::size_t kind) {
    switch (kind) {
      case 0:
        return Sphere(random_.between(0.3, 0.7));
      case 1:
        return Capsule({0, 0, -0.5}, {0, 0, 0.5}, random_.between(0.2, 0.4));
      case 2:
        return Box({0.5, 0.7, 0.4});
      case 3:
        return Rounded(Box({0.4, 0.6, 0.3}), 0.125);
      default:
        return ConvexHull(points());
    }
  }

  /// A pair of A and B, somewhere, with B as deep in A along the way between two near points of the two.
  ConvexCase pair(std::size_t kind_a, std::size_t kind_b, double depth) {
    ConvexCase pair{{shape(kind_a), pose()}, {shape(kind_b), pose()}};
    pair.b.pose.offset = pair.a.pose.offset + 4.0 * direction();
    const Distance apart = distance(posed(pair.a), posed(pair.b));
    const Vec3 way = apart.on_b - apart.on_a;
    pair.b.pose.offset = pair.b.pose.offset - (1 + depth / std::sqrt(dot(way, way))) * way;
    return pair;
  }

  /// B lies on a face of A, turned in its plane, as deep.
  ConvexCase resting(double depth) {
    const Pose floor = pose();
    const double x = random_.between(-0.2, 0.2), y = random_.between(-0.2, 0.2), turn = random_.between(0, 360);
    const Pose seat =
        Pose::translation(x, y, 0.6 - depth) * Pose::rotation({0, 0, 1}, random_.below(2) == 0 ? turn : 0);
    return {{Box({1, 1, 0.4}), floor}, {Box({0.3, 0.25, 0.2}), floor * seat}};
  }

  double between(double low, double high) { return random_.between(low, high); }

 private:
  Vec3 direction() {
    const Vec3 v{random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1)};
    return (1 / std::sqrt(dot(v, v))) * v;
  }
  Pose pose() {
    Pose pose;
    pose.linear = rotation_about(direction(), random_.between(0, 360));
    pose.offset = {random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1)};
    return pose;
  }
  std::vector<Vec3> points() {
    std::vector<Vec3> points;
    for (int k = 0; k < 8; ++k) points.push_back(direction());
    return points;
  }

  Random random_;
};

/// Empty, or what is wrong with the penetration, asked both ways round.
std::string wrong_with_depth(const ConvexCase& pair) {
  const PosedPolytope a = posed(pair.a), b = posed(pair.b);
  const oracle::ConvexSet set_a = set_of(pair.a), set_b = set_of(pair.b);
  const Penetration p = penetration(a, b);
  if (const std::string wrong = wrong_with(p, set_a, set_b, size_of(set_a) + size_of(set_b)); !wrong.empty())
    return wrong + ": " + to_text(pair);
  if (!(flipped(penetration(b, a)) == p)) return "exchanged: " + to_text(pair);
  return (manifold(a, b).count > 0) == overlap(a, b) ? "" : "manifold: " + to_text(pair);
}

class ShallowDepth : public testing::TestWithParam<std::size_t> {};

TEST_P(ShallowDepth, AgreesWithRationals) {
  ShallowPairs pairs(20 + GetParam());
  for (std::size_t other = GetParam(); other < 5; ++other)
    for (const double depth : {1e-2, 1e-4, 1e-7, 1e-10, -1e-4, -1.0})
      for (int k = 0; k < 2; ++k) EXPECT_EQ(wrong_with_depth(pairs.pair(GetParam(), other, depth)), "");
}

INSTANTIATE_TEST_SUITE_P(Each, ShallowDepth, testing::Range<std::size_t>(0, 5));

TEST(ShallowDepthOf, BoxesThatRestAgreesWithRationals) {
  ShallowPairs pairs(31);
  for (const double depth : {1e-2, 1e-5, 1e-9})
    for (int k = 0; k < 4; ++k) EXPECT_EQ(wrong_with_depth(pairs.resting(depth)), "");
}

// Nothing is left to exact arithmetic for spheres and boxes in general position, and nothing is rougher than it is
// there.
TEST(ShallowDepthOf, GrownShapesIsBetweenNeighbouringDoubles) {
  ShallowPairs pairs(32);
  for (int k = 0; k < 60; ++k) {
    const double depth = std::pow(10.0, pairs.between(-8, -1));
    const ConvexCase pair = pairs.pair(static_cast<std::size_t>(k % 2), static_cast<std::size_t>(k % 3), depth);
    const PosedPolytope a = posed(pair.a), b = posed(pair.b);
    const std::optional<ConvexSeparation> apart = part_apart_cores(a, b);
    ASSERT_TRUE(apart.has_value());
    EXPECT_GT(apart->penetration.lower, 0);
    EXPECT_LE(apart->penetration.upper - apart->penetration.lower, 0x1p-48 * apart->penetration.upper);
  }
}

TEST(ShallowDepthOf, CoresThatNearlyTouchIsAlongTheirTrueDirection) {
  const Vec3 half{0.3, 0.1, 0.7};
  const PosedPolytope capsule(Capsule(-half, half, 0.5));
  for (const double away : {1e-10, 1e-16, 1e-20, 1e-28, 1e-30, 1e-32, 1e-60}) {
    const Penetration found = penetration(capsule, PosedPolytope(Sphere(0.5, away * Vec3{1, 0.37, -0.11})));
    EXPECT_NEAR(dot(found.direction, half), 0, 1e-15) << away;
    EXPECT_NEAR(dot(found.direction, found.direction), 1, 1e-15) << away;
  }
}

TEST(ShallowDepthOf, HullsIsFoundWithoutExactSigns) {
  ShallowPairs pairs(33);
  int found = 0;
  for (int k = 0; k < 40; ++k) {
    const ConvexCase pair = pairs.pair(4, 4, std::pow(10.0, pairs.between(-8, -2)));
    const std::optional<CoreSeparation> fast = part_cores_fast(posed(pair.a), posed(pair.b), 0);
    if (!fast) continue;
    ++found;
    EXPECT_LE(fast->upper - fast->lower, relative_width_of_depth * fast->upper);
  }
  EXPECT_GE(found, 36);
}

// A facet of the difference that is not the nearest: a plank under a plank, pushed in from its end.
TEST(PreciseFacet, IsNotTakenForTheNearestWhereItIsSmallForItsDistance) {
  const PosedPolytope plank(Box({1, 1, 0.01})), other(Box({1, 1, 0.01}), Pose::translation(1.5, 0.1, 0.005));
  VertexPairs end;  // of the facet across x: the far end of the one, a corner of the other
  for (const Index corner : {1U, 3U, 5U}) end.append(corner, 0);
  const std::optional<PreciseFacet> facet = precise_facet(plank, other, end);
  ASSERT_TRUE(facet.has_value());
  EXPECT_FALSE(is_certainly_nearest(plank, other, *facet));
  EXPECT_NEAR(penetration(plank, other).upper, 0.015, 1e-15);
}

}  // namespace
}  // namespace toccata::test
