#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "narrow/penetration_checks.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/rotation.hpp"

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
    const PlacedConvex a{random.shape(), random.pose()}, b{random.shape(), random.pose()};
    const PosedConvex posed_a = posed(a), posed_b = posed(b);
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

INSTANTIATE_TEST_SUITE_P(Each, PenetrationOverDecades, testing::Values(3.0, 8.0, 20.0, 75.0));

}  // namespace
}  // namespace toccata::test
