#include "narrow/triangles/separating_normal.hpp"

#include <gtest/gtest.h>

#include <random>

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {
namespace {

/// By how much A has to move along a direction of length 1 until nothing of it is below the highest of B.
double overlap_along(const Triangle& a, const Triangle& b, const Vec3& up) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    low = std::min(low, dot(up, a.vertex[i]));
    high = std::max(high, dot(up, b.vertex[i]));
  }
  return high - low;
}

// The oracle is the search over the difference of the two, which is exact.
TEST(SeparatingNormal, IsAlongTheShortestWayOut) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto triangle = [&] {
    Triangle t;
    for (Vec3& v : t.vertex) v = {coordinate(random), coordinate(random), coordinate(random)};
    return t;
  };
  int meeting = 0;
  for (int i = 0; i < 3000; ++i) {
    const Triangle a = triangle(), b = triangle();
    if (!overlap(a, b)) continue;
    ++meeting;
    const Vec3 found = separating_normal(a, b), exact = manifold(PosedPolytope(a), PosedPolytope(b)).normal;
    EXPECT_NEAR(length(found), 1, 1e-14);
    EXPECT_NEAR(overlap_along(a, b, found), overlap_along(a, b, Vec3{} - exact), 1e-12);
    EXPECT_EQ(separating_normal(b, a), Vec3{} - found);
  }
  EXPECT_GT(meeting, 300);
}

TEST(SeparatingNormal, OfTrianglesThatTouchItIsAcrossThem) {
  const Triangle floor{{Vec3{-1, -1, 0}, Vec3{1, -1, 0}, Vec3{0, 1, 0}}};
  const Triangle on_it{{Vec3{-0.5, -0.5, 0}, Vec3{0.5, -0.5, 0}, Vec3{0, 0.5, 0}}};
  const Triangle corner_down{{Vec3{0, 0, 0}, Vec3{0.5, 0, 1}, Vec3{0, 0.5, 1}}};
  const Vec3 up{0, 0, 1};
  EXPECT_EQ(std::fabs(dot(separating_normal(on_it, floor), up)), 1);
  EXPECT_EQ(separating_normal(corner_down, floor), up);
  EXPECT_EQ(separating_normal(floor, corner_down), Vec3{} - up);
}

TEST(SeparatingNormal, WithoutAreaThereIsNone) {
  const Triangle point{{Vec3{1, 2, 3}, Vec3{1, 2, 3}, Vec3{1, 2, 3}}};
  EXPECT_EQ(separating_normal(point, point), Vec3{});
}

}  // namespace
}  // namespace toccata
