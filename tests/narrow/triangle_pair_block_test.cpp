#include "narrow/triangles/triangle_pair_block.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <tuple>

#include "narrow/triangle_pair_blocks.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {

/// Where gtest looks for it, so that tests are called by the level and not by its bytes.
inline void PrintTo(SimdLevel level, std::ostream* out) { *out << name_of(level); }

}  // namespace toccata

namespace toccata::test {
namespace {

using triangle_pairs::random_triangle;

/// Every level in turn; afterwards the one that was in use before.
class TrianglePairBlocks : public testing::TestWithParam<SimdLevel> {
 protected:
  TrianglePairBlocks() { use_simd_level(GetParam()); }
  ~TrianglePairBlocks() override { use_simd_level(before_); }

 private:
  SimdLevel before_ = simd_level();
};

INSTANTIATE_TEST_SUITE_P(, TrianglePairBlocks, testing::ValuesIn(simd_levels()),
                         [](const auto& level) { return std::string(name_of(level.param)); });

std::vector<TrianglePair> random_pairs(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  std::vector<TrianglePair> pairs;
  for (std::size_t i = 0; i < count; ++i) pairs.push_back(triangle_pair("random", random));
  return pairs;
}

/// Side patterns of both triangles and what lies inside what: 6 · 6 · 4, among which few are impossible.
TEST_P(TrianglePairBlocks, FindsEveryKindOfCrossing) {
  const PosedTrianglePairs batch{{}, {}, random_pairs(1, 20000)};
  std::set<std::array<IntersectionPoint, 2>> kinds;
  for (const TrianglePairBlock& block : classified(batch, GetParam()))
    for (std::size_t lane = 0; lane < block.count; ++lane) {
      const Intersection truth = intersect(triangle_a(block, lane), triangle_b(block, lane));
      if (!has_bit(block.intersection, lane)) continue;
      ASSERT_EQ(intersection_in(block, lane), truth);
      kinds.insert({truth.points[0], truth.points[1]});
    }
  // Two edges of a, two of b, or one of each.
  EXPECT_EQ(kinds.size(), 3U + 3U + 9U);
}

TEST_P(TrianglePairBlocks, KnowNearlyAlways) {
  for (const double size : {1.0, 1e-3, 1e9}) {
    const Pose pose = scaled({rotation_about({1, 2, 3}, 40), {0.1, 0.2, 0.3}}, size);
    const PosedTrianglePairs batch{pose, pose, random_pairs(2, 8000)};
    std::size_t unknown = 0;
    for (const TrianglePairBlock& block : classified(batch, GetParam()))
      unknown += static_cast<std::size_t>(std::popcount(block.unknown));
    EXPECT_LE(unknown, batch.pairs.size() / 1000) << size;
  }
}

TEST_P(TrianglePairBlocks, KnowAlsoNeedlesAndPartsOfVeryDifferentSize) {
  Random random(3);
  PosedTrianglePairs batch;
  for (int i = 0; i < 4000; ++i) {
    const Triangle a = random_triangle(random);
    const Vec3 at = triangle_pairs::point_of(a, random);
    const auto shrink = [&](const Vec3& v) { return at + 0x1p-16 * v; };
    batch.pairs.push_back({a, triangle_pairs::each_vertex(random_triangle(random), shrink)});
  }
  std::size_t unknown = 0;
  for (const TrianglePairBlock& block : classified(batch, GetParam()))
    unknown += static_cast<std::size_t>(std::popcount(block.unknown));
  EXPECT_LE(unknown, batch.pairs.size() / 100);
}

TEST_P(TrianglePairBlocks, DisjointBoxesSettleEvenWhatHasNoPlane) {
  const Triangle point{{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}}, flat{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  const Triangle beside{{{{2, 0, 0}, {3, 0, 0}, {2, 1, 0}}}};
  const PosedTrianglePairs batch{{}, {}, {{point, flat}, {flat, beside}, {flat, flat}, {point, point}}};
  const std::vector<TrianglePairBlock> blocks = classified(batch, GetParam());
  EXPECT_EQ(blocks[0].intersection, 0);
  EXPECT_EQ(blocks[0].unknown, 0b1100);
}

TEST_P(TrianglePairBlocks, FreeLanesSayNothing) {
  for (const double filler : {0.0, std::numeric_limits<double>::quiet_NaN(), 1e308}) {
    for (std::size_t count = 0; count <= TrianglePairBlock::lanes; ++count) {
      std::vector<TrianglePairBlock> blocks = blocks_of(random_pairs(4, count), filler);
      classify_pairs(Pose{}, Pose{}, blocks);
      for (const TrianglePairBlock& block : blocks) {
        EXPECT_EQ((block.intersection | block.unknown) >> count, 0);
        for (std::size_t lane = 0; lane < count; ++lane)
          EXPECT_EQ(has_bit(block.intersection, lane), overlap(triangle_a(block, lane), triangle_b(block, lane)));
      }
    }
  }
}

/// Every coordinate of every corner in turn, also where the boxes of what stays finite are disjoint.
TEST_P(TrianglePairBlocks, KnowNothingOfWhatAPoseMakesInfinite) {
  const Triangle here{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}}}}, there{{{{5, 5, 5}, {6, 5, 5}, {5, 6, 7}}}};
  for (const double bad : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()})
    for (int i = 0; i < 18; ++i) {
      TrianglePair pair{here, there};
      (i < 9 ? pair.a : pair.b)[i % 3][i / 3 % 3] = bad;
      const std::vector<TrianglePairBlock> blocks = classified({{}, {}, {pair}}, GetParam());
      EXPECT_EQ(blocks[0].intersection, 0) << i << ' ' << bad;
      EXPECT_EQ(blocks[0].unknown, 1) << i << ' ' << bad;
    }
  const Pose overflowing = scaled(Pose{}, 1e308);
  const std::vector<TrianglePairBlock> blocks = classified({overflowing, overflowing, {{here, there}}}, GetParam());
  EXPECT_EQ(blocks[0].unknown, 1);
}

/// Random pairs, stretched along x and y by a power of two of up to 200 from the first exponent on, along z from the
/// second.
PosedTrianglePairs stretched_pairs(std::uint64_t seed, int across, int along) {
  Random random(seed);
  const auto power_from = [&](int exponent) { return std::ldexp(1.0, exponent + static_cast<int>(random.below(200))); };
  PosedTrianglePairs batch;
  for (const TrianglePair& pair : random_pairs(seed + 1, 4000)) {
    const double x = power_from(across), y = power_from(across), z = power_from(along);
    const auto stretch = [&](const Vec3& v) -> Vec3 { return {x * v.x, y * v.y, z * v.z}; };
    batch.pairs.push_back({triangle_pairs::each_vertex(pair.a, stretch), triangle_pairs::each_vertex(pair.b, stretch)});
  }
  return batch;
}

std::string first_wrong(const std::vector<TrianglePairBlock>& blocks) {
  for (const TrianglePairBlock& block : blocks)
    for (std::size_t lane = 0; lane < block.count; ++lane) {
      const Triangle a = triangle_a(block, lane), b = triangle_b(block, lane);
      const std::string wrong = compare_lane(block, lane, a, b);
      if (!wrong.empty()) return wrong + ": a" + to_text(a) + ", b" + to_text(b);
    }
  return "";
}

/// The product of two factors is more than any double, or hardly one, while the third would bring it back among them.
TEST_P(TrianglePairBlocks, AreNotFooledWhereProductsOverflowOrUnderflow) {
  EXPECT_EQ(first_wrong(classified(stretched_pairs(5, 400, -600), GetParam())), "");
  EXPECT_EQ(first_wrong(classified(stretched_pairs(6, -600, 800), GetParam())), "");
}

}  // namespace
}  // namespace toccata::test
