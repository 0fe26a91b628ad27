#include "toccata/bounds/volume.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "toccata/core/random.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata {
namespace {

bool overlap_of_convex_shapes(const Aabb& box, const Triangle& triangle) {
  std::vector<Vec3> corners;
  for (const double x : {box.lower.x, box.upper.x})
    for (const double y : {box.lower.y, box.upper.y})
      for (const double z : {box.lower.z, box.upper.z}) corners.push_back({x, y, z});
  const ConvexHull hull(corners);
  return overlap(PosedPolytope(hull), PosedPolytope(triangle));
}

double whole(Random& random, std::uint64_t count) { return static_cast<double>(random.below(count)); }
Vec3 corner(Random& random, std::uint64_t count) {
  const double x = whole(random, count), y = whole(random, count), z = whole(random, count);
  return {x, y, z};
}

TEST(BoxTriangle, IsDecidedAsForConvexShapes) {
  std::size_t meeting = 0, apart_in_spite_of_boxes = 0;
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
    Random random(seed);
    const Vec3 lower = corner(random, 6);
    const Aabb box{lower, lower + corner(random, 3)};  // flat ones too
    Triangle triangle{{corner(random, 8), corner(random, 8), corner(random, 8)}};
    if (seed % 3 == 0)  // a hair off the lattice
      for (Vec3& vertex : triangle.vertex) vertex.y = std::nextafter(vertex.y, whole(random, 9));
    const bool expected = overlap_of_convex_shapes(box, triangle);
    ASSERT_EQ(overlap(box, triangle), expected) << "seed " << seed;
    meeting += expected ? 1 : 0;
    apart_in_spite_of_boxes += !expected && overlap(box, fit_aabb(triangle.vertex)) ? 1 : 0;
  }
  EXPECT_GT(meeting, 1'000U);
  EXPECT_GT(apart_in_spite_of_boxes, 1'000U);
}

TEST(BoxTriangle, KnowsTheSmallestAndTheGreatestDoubles) {
  constexpr double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  const Aabb unit{{0, 0, 0}, {least, least, least}};
  EXPECT_TRUE(overlap(unit, Triangle{{{{2 * least, 0, 0}, {0, 2 * least, 0}, {0, 0, 2 * least}}}}));
  EXPECT_FALSE(overlap(unit, Triangle{{{{4 * least, 0, 0}, {0, 4 * least, 0}, {0, 0, 4 * least}}}}));
  const Aabb all{{-most, -most, -most}, {most, most, most}};
  EXPECT_TRUE(overlap(all, Triangle{{{{most, most, most}, {most, 0, 0}, {0, 0, most}}}}));
  EXPECT_FALSE(overlap(Aabb{{-most, -most, -most}, {0, 0, -least}},
                       Triangle{{{{-most, -most, 0}, {most, -most, 0}, {0, most, 0}}}}));
  EXPECT_FALSE(overlap(Aabb{}, Triangle{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}));
}

}  // namespace
}  // namespace toccata
