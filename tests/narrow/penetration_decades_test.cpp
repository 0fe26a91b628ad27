#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "narrow/penetration_checks.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"

// Solids with coordinates from 10^-decades to 10^decades beside each other, compared with rational arithmetic: moving
// such shapes by a pose shows nothing, as rounding swallows the move.
namespace toccata::test {
namespace {

class Decades {
 public:
  Decades(double decades, std::uint64_t seed) : decades_(decades), random_(seed) {}

  ConvexShape shape() {
    switch (random_.below(5)) {
      case 0:
        return Sphere(positive(), point());
      case 1:
        return Box({positive(), positive(), positive()});
      case 2:
        return Capsule(point(), point(), positive());
      case 3:
        return ConvexHull(points());
      default:
        return Rounded(ConvexHull(points()), positive());
    }
  }

  Pose pose() {
    const std::uint64_t which = random_.below(4);
    Pose pose;
    if (which == 0) return pose;
    if (which > 1) pose.linear = rotation_about(Vec3{1, 2, 3}, random_.between(0, 360));
    if (which < 3) pose.offset = point();
    return pose;
  }

 private:
  double positive() { return std::pow(10.0, random_.between(-decades_, decades_)); }
  double number() {
    const std::uint64_t which = random_.below(6);
    return which == 0 ? 0 : which < 3 ? positive() : -positive();
  }
  Vec3 point() {
    const double x = number(), y = number();
    return {x, y, number()};
  }
  std::vector<Vec3> points() {
    std::vector<Vec3> points;
    for (std::uint64_t left = 4 + random_.below(6); left > 0; --left) points.push_back(point());
    return points;
  }

  double decades_;
  Random random_;
};

/// Nothing when the shapes are no solids, or refused.
std::optional<std::string> wrong_with_case(double decades, std::uint64_t seed) {
  Decades random(decades, seed);
  try {
    const PlacedPolytope a{random.shape(), random.pose()}, b{random.shape(), random.pose()};
    const PosedPolytope posed_a = posed(a), posed_b = posed(b);
    if (!posed_a.solid() || !posed_b.solid()) return {};
    const oracle::ConvexSet set_a = set_of(a), set_b = set_of(b);
    if (!oracle::is_solid(set_a) || !oracle::is_solid(set_b)) return {};
    const Penetration p = penetration(posed_a, posed_b);
    return wrong_with(p, set_a, set_b, size_of(set_a) + size_of(set_b));
  } catch (const Error&) {
    return {};
  }
}

class PenetrationOverDecades : public testing::TestWithParam<double> {};

TEST_P(PenetrationOverDecades, IsThatOfRationalArithmetic) {
  int asked = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const std::optional<std::string> wrong = wrong_with_case(GetParam(), seed);
    if (!wrong) continue;
    ++asked;
    EXPECT_EQ(*wrong, "") << "seed " << seed;
  }
  EXPECT_GE(asked, 10);
}

/// Empty when penetration is right of two hulls.
std::string wrong_with_hulls(const ConvexHull& a, const ConvexHull& b) {
  const oracle::ConvexSet set_a = set_of({a, {}}), set_b = set_of({b, {}});
  return wrong_with(penetration(PosedPolytope(a), PosedPolytope(b)), set_a, set_b, size_of(set_a) + size_of(set_b));
}

TEST(PenetrationOfHulls, OfTheLeastDoubleIsNotTouching) {
  constexpr double least = 4.9406564584124654e-324;
  const ConvexHull crystal(std::vector<Vec3>{{0, -1, 0}, {-3, -2, 1}, {-3, 0, 0}, {0, 0, 2}, {0, 0, 0}});
  const ConvexHull wedge(std::vector<Vec3>{{1.0000000000000002, -0.5, -least},
                                           {1.9999999999999998, -0.5, 2.0000000000000004},
                                           {-least, -0.5, 1},
                                           {1.9999999999999998, -0.5, 3},
                                           {3.0000000000000004, 2.5000000000000004, least}});
  const Penetration p = penetration(PosedPolytope(crystal), PosedPolytope(wedge));
  const oracle::Depth depth(set_of({crystal, {}}), set_of({wedge, {}}));
  EXPECT_GT(depth.compare(0), 0);
  EXPECT_EQ(p.lower, 0);
  EXPECT_LE(depth.compare(oracle::exact(p.upper)), 0);
  EXPECT_LT(p.upper, 100 * least);
}

TEST(PenetrationOfHulls, IsNoneWhereTheyTouchAndAnotherFaceIsTheLeastDoubleDeep) {
  constexpr double least = 4.9406564584124654e-324;
  const auto box = [](const Vec3& low, const Vec3& high) {
    std::vector<Vec3> corners;
    for (const double x : {low.x, high.x})
      for (const double y : {low.y, high.y})
        for (const double z : {low.z, high.z}) corners.push_back({x, y, z});
    return ConvexHull(corners);
  };
  const ConvexHull left = box({-2, 1, -1}, {0, 5, 3}), above = box({-least, 4, 3}, {4, 6, 7});
  EXPECT_EQ(wrong_with_hulls(left, above), "");
  EXPECT_EQ(penetration(PosedPolytope(left), PosedPolytope(above)).upper, 0);
  EXPECT_EQ(penetration(PosedPolytope(above), PosedPolytope(left)).upper, 0);
}

TEST(PenetrationOfHulls, HasPointsOnNeedlesToo) {
  const ConvexHull needle(std::vector<Vec3>{{247512.59680693888, 313786.17459582741, 298113.54632768716},
                                            {286896.65565502062, -1311175.2139875321, 469039.29893654305},
                                            {252085.28096558433, 124871.32257117965, 317983.49390170228},
                                            {267445.01367595705, -508228.82054603327, 384577.9998633705}});
  const ConvexHull other(std::vector<Vec3>{{304006.03277913027, 247791.58401986345, 440381.19023119402},
                                           {177092.04588284378, 396050.06763110717, 120773.39534112503},
                                           {378131.32095386158, 161199.62216578913, 627051.68515052716},
                                           {397916.94794586377, 138086.51652081939, 676877.8643783296},
                                           {-122221.7247950106, 745702.99388842704, -632989.86240339105}});
  EXPECT_EQ(wrong_with_hulls(needle, other), "");
}

INSTANTIATE_TEST_SUITE_P(Each, PenetrationOverDecades, testing::Values(3.0, 8.0, 20.0, 75.0));

}  // namespace
}  // namespace toccata::test
