#include "trees/gap_planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/simd_levels.hpp"
#include "toccata/core/random.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

Vec3 random_vector(Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

Mat3 random_rotation(Random& random, double degrees) {
  return rotation_about(random_vector(random, 1) + Vec3{0, 0, 1.5}, random.between(-degrees, degrees));
}

OrientedBlock random_block(Random& random) {
  OrientedBlock block{};
  block.count = OrientedBlock::width;
  for (std::size_t lane = 0; lane < OrientedBlock::width; ++lane) {
    const Mat3 axes = random_rotation(random, 180);
    OrientedBox box;
    const double size = std::exp2(random.between(-8, -1));
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      box.centre[at] = static_cast<float>(random.between(-0.5, 0.5));
      box.axis[0][at] = static_cast<float>(axes.column(0)[i]);
      box.axis[1][at] = static_cast<float>(axes.column(1)[i]);
      box.extent[at] = static_cast<float>(size * random.unit() * (i == 2 ? 0.1 : 1));
    }
    set_lane(block, lane, box);
    block.child[lane] = ~static_cast<std::int32_t>(lane);
  }
  return block;
}

NearView random_view(Random& random, double ratio) {
  NearView view;
  view.rotation = random_rotation(random, 180);
  view.ratio = ratio;
  view.offset = std::exp2(random.between(-2, 3)) * random_vector(random, 1);
  view.pad = 1e-12;
  return view;
}

NearView moved(NearView view, Random& random, double share) {
  const Mat3 turn = random_rotation(random, 60 * share);
  Mat3 turned;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) turned[i][j] = dot(turn[i], view.rotation.column(j));
  view.rotation = turned;
  view.offset = view.offset + random_vector(random, share);
  return view;
}

Vec3 lane_of(const std::array<std::array<float, OrientedBlock::width>, 3>& lanes, std::size_t lane) {
  return {lanes[0][lane], lanes[1][lane], lanes[2][lane]};
}

std::array<Vec3, 8> corners(const OrientedBlock& block, std::size_t lane) {
  const Vec3 first = lane_of(block.axis[0], lane), second = lane_of(block.axis[1], lane);
  const std::array<Vec3, 3> axis{first, second, cross(first, second)};
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = lane_of(block.centre, lane);
    for (std::size_t k = 0; k < 3; ++k)
      corners[i] = corners[i] + ((i >> k & 1U) != 0 ? 1.0 : -1.0) * double{block.extent[k][lane]} * axis[k];
  }
  return corners;
}

Vec3 seen(const NearView& view, const Vec3& p) {
  return view.offset + view.ratio * Vec3{dot(view.rotation[0], p), dot(view.rotation[1], p), dot(view.rotation[2], p)};
}

/// How far the boxes are apart along a plane's normal, which no bound of it may be above.
double gap_along(const GapPlaneLanes& planes, std::size_t lane, const std::array<Vec3, 8>& own,
                 const std::array<Vec3, 8>& other, const NearView& view) {
  const Vec3 n{planes.normal[0][lane], planes.normal[1][lane], planes.normal[2][lane]};
  double top = -std::numeric_limits<double>::infinity(), bottom = -top;
  for (const Vec3& p : own) top = std::max(top, dot(n, p));
  for (const Vec3& q : other) bottom = std::min(bottom, dot(n, seen(view, q)));
  return bottom - top;
}

struct Blocks {
  explicit Blocks(Random& random) : a(random_block(random)), b(random_block(random)) {}
  OrientedBlock a, b;
  std::array<Index, 8> items{0, 1, 2, 3, 4, 5, 6, 7};

  [[nodiscard]] NearWalk walk(const NearView& view) const { return {{{&a, 1}, items}, {{&b, 1}, items}, view, view}; }
};

GapPlaneLanes parted_diagonally(const Blocks& blocks, const NearView& view) {
  std::array<BoxPair, 8> pairs;
  for (std::uint32_t i = 0; i < 8; ++i) pairs[i] = {i, 7 - i};
  GapPlaneLanes planes{};
  part_boxes(blocks.walk(view), pairs, planes);
  return planes;
}

TEST(GapPlanes, AreNeverAboveTheGapAlongTheirNormalHoweverTheBoxesMove) {
  test::at_every_simd_level([](SimdLevel level) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      Random random(seed);
      const Blocks blocks(random);
      const NearView before = random_view(random, std::exp2(random.between(-4, 4)));
      const GapPlaneLanes planes = parted_diagonally(blocks, before);
      NearView after = moved(before, random, std::exp2(random.between(-20, 0)));
      if (seed % 4 == 0) after.ratio *= random.between(0.9, 1.1);
      GapPlanes kept;
      for (std::size_t lane = 0; lane < 8; ++lane) kept.set(kept.add(), planes, lane);
      std::vector<GapPlanes::Near> near;
      kept.find_near(after, std::numeric_limits<double>::infinity(), near);
      ASSERT_EQ(near.size(), 8U);
      for (std::uint32_t lane = 0; lane < 8; ++lane) {
        const auto own = corners(blocks.a, lane), other = corners(blocks.b, 7 - lane);
        EXPECT_LE(planes.least[lane], gap_along(planes, lane, own, other, before)) << name_of(level) << ' ' << seed;
        EXPECT_LE(near[lane].least, gap_along(planes, lane, own, other, after)) << name_of(level) << ' ' << seed;
      }
    }
  });
}

TEST(GapPlanes, LoseLittleWhenTheBoxesMoveLittle) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const Blocks blocks(random);
    const NearView before = random_view(random, 1);
    const GapPlaneLanes planes = parted_diagonally(blocks, before);
    const NearView after = moved(before, random, 1e-3);
    GapPlanes kept;
    for (std::size_t lane = 0; lane < 8; ++lane) kept.set(kept.add(), planes, lane);
    std::vector<GapPlanes::Near> near;
    kept.find_near(after, std::numeric_limits<double>::infinity(), near);
    for (std::uint32_t lane = 0; lane < 8; ++lane) {
      const double gap = gap_along(planes, lane, corners(blocks.a, lane), corners(blocks.b, 7 - lane), after);
      // A turn of 0.06 degrees about a centre within 0.5 √3.
      EXPECT_GT(near[lane].least, gap - (2 * 0.0011 * planes.radius[lane] + 2 * plane_pad(after))) << seed;
    }
  }
}

TEST(GapPlanes, OfTheChildrenOfABlockAreThoseOfThePairs) {
  Random random(1);
  const Blocks blocks(random);
  const NearWalk walk = blocks.walk(random_view(random, 1.5));
  for (std::uint32_t box = 0; box < 8; ++box)
    for (std::uint32_t side = 0; side < 2; ++side) {
      std::array<BoxPair, 8> pairs;
      for (std::uint32_t lane = 0; lane < 8; ++lane) pairs[lane] = side == 0 ? BoxPair{lane, box} : BoxPair{box, lane};
      GapPlaneLanes of_pairs{}, of_children{};
      part_boxes(walk, pairs, of_pairs);
      part_children(walk, side, 0, box, of_children);
      EXPECT_EQ(of_pairs.least, of_children.least);
      EXPECT_EQ(of_pairs.normal, of_children.normal);
      EXPECT_EQ(of_pairs.reach, of_children.reach);
    }
}

TEST(GapPlanes, OfBoxesSayAtLeastAsMuchAsTheWalkDoes) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Blocks blocks(random);
    const NearView view = random_view(random, 1);
    const NearWalk walk = blocks.walk(view);
    for (std::uint32_t other = 0; other < 8; ++other) {
      GapPlaneLanes planes{};
      part_children(walk, 0, 0, other, planes);
      const NearBounds bounds = walk.bounds(0, 0, other);
      for (std::size_t lane = 0; lane < 8; ++lane)
        if (bounds.least[lane] > 0) {
          EXPECT_GT(planes.least[lane] + 1e-5, bounds.least[lane]) << i << ' ' << other << ' ' << lane;
        }
    }
  }
}

TEST(GapPlanes, FindTheNearOnesOnlyAndTheSameAtEverySimdLevel) {
  Random random(3);
  GapPlanes kept;
  for (int i = 0; i < 5; ++i) {
    const Blocks blocks(random);
    const GapPlaneLanes planes = parted_diagonally(blocks, random_view(random, 1));
    for (std::size_t lane = 0; lane < 7; ++lane) kept.set(kept.add(), planes, lane);
  }
  kept.unset(4);
  const NearView view = random_view(random, 1);
  std::vector<GapPlanes::Near> all;
  kept.find_near(view, std::numeric_limits<double>::infinity(), all);
  ASSERT_EQ(all.size(), 34U);
  test::at_every_simd_level([&](SimdLevel level) {
    for (const double limit : {-1.0, 0.0, 0.5, 2.0}) {
      std::vector<GapPlanes::Near> near;
      kept.find_near(view, limit, near);
      std::size_t expected = 0;
      for (const GapPlanes::Near& one : all) {
        if (one.least > limit) continue;
        ASSERT_LT(expected, near.size()) << name_of(level);
        EXPECT_EQ(near[expected].place, one.place) << name_of(level);
        EXPECT_EQ(near[expected++].least, one.least) << name_of(level);
      }
      EXPECT_EQ(near.size(), expected) << name_of(level);
    }
  });
}

}  // namespace
}  // namespace toccata
