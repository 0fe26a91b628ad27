#include "toccata/broad/broad_phase.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "broad/box_families.hpp"
#include "broad/box_life.hpp"
#include "broad/pair_buffer.hpp"
#include "support/error_message.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata {

/// Where gtest looks for it, so that tests are called by the method and not by its bytes.
inline void PrintTo(BroadPhaseMethod method, std::ostream* out) { *out << name_of(method); }

namespace {

using test::message_of;
using Pairs = std::vector<IndexPair>;

Pairs list_of(std::span<const IndexPair> pairs) { return {pairs.begin(), pairs.end()}; }
Aabb cube_at(double x, double size = 1) { return {{x, 0, 0}, {x + size, 1, 1}}; }

/// Found once for all methods.
const Pairs& pairs_of_brute_force(std::string_view name, const std::vector<Aabb>& boxes) {
  static std::map<std::string, Pairs, std::less<>> known;
  const std::string key = std::string(name) + std::to_string(boxes.size());
  const auto at = known.find(key);
  return at != known.end() ? at->second : known.emplace(key, overlapping_pairs_by_brute_force(boxes)).first->second;
}

class EveryMethod : public testing::TestWithParam<BroadPhaseMethod> {};

TEST_P(EveryMethod, FindsThePairsOfBruteForceThroughALife) {
  for (const std::string_view family : test::box_families) {
    Random random(family.size());
    test::BoxLife boxes(family, {GetParam(), 1});
    ASSERT_EQ(boxes.add(150, random), "");
    for (int frame = 0; frame < 20; ++frame) ASSERT_EQ(boxes.live(frame, random), "") << family << ", frame " << frame;
  }
}

TEST_P(EveryMethod, FindsThePairsOfBruteForceAmongMore) {
  for (const std::string_view family : test::box_families) {
    SCOPED_TRACE(family);
    Random random(7);
    const bool all_meet = family == "equal" || family == "nested";
    const std::vector<Aabb> boxes = test::random_boxes(family, all_meet ? 300 : 1000, random);
    const Pairs& expected = pairs_of_brute_force(family, boxes);
    EXPECT_EQ(overlapping_pairs(boxes, {GetParam(), 1}), expected);
    EXPECT_EQ(overlapping_pairs(boxes, {GetParam(), 2}), expected);
  }
}

TEST_P(EveryMethod, FindsThePairsOfCrowds) {
  for (const NamedScene& scene : crowd_scenes())
    for (const std::size_t count : {400U, 4'000U}) {
      SCOPED_TRACE(scene.name);
      Crowd crowd(scene.name, count, count);
      BroadPhase phase({GetParam(), 2});
      phase.add(crowd.boxes());
      phase.update();
      const std::span<const Index> moved = crowd.step();
      std::vector<Aabb> to;
      for (const Index number : moved) to.push_back(crowd.boxes()[number]);
      phase.move(moved, to);
      phase.update();
      EXPECT_EQ(list_of(phase.pairs()), pairs_of_brute_force(scene.name, crowd.boxes()));
    }
}

TEST_P(EveryMethod, FindsOnlyWhatIsWanted) {
  const auto wanted = [](const IndexPair& pair) { return pair.first % 3 != pair.second % 3; };
  for (const std::string_view family : test::box_families) {
    SCOPED_TRACE(family);
    Random random(3);
    const std::vector<Aabb> boxes = test::random_boxes(family, 300, random);
    Pairs expected = overlapping_pairs_by_brute_force(boxes);
    std::vector<std::atomic<int>> refused(boxes.size() * boxes.size());
    const auto counted = [&](const IndexPair& pair) {
      if (!wanted(pair)) ++refused[pair.first * boxes.size() + pair.second];
      return wanted(pair);
    };
    EXPECT_EQ(overlapping_pairs(boxes, {GetParam(), 2}, counted).size(),
              static_cast<std::size_t>(std::count_if(expected.begin(), expected.end(), wanted)));
    EXPECT_TRUE(std::all_of(expected.begin(), expected.end(), [&](const IndexPair& pair) {
      return refused[pair.first * boxes.size() + pair.second] == (wanted(pair) ? 0 : 1);
    }));
    std::erase_if(expected, [&](const IndexPair& pair) { return !wanted(pair); });
    EXPECT_EQ(overlapping_pairs(boxes, {GetParam(), 1}, wanted), expected);
  }
}

TEST_P(EveryMethod, IsNotLedAstrayByTheGreatestDoubles) {
  constexpr double most = std::numeric_limits<double>::max();
  std::vector<Aabb> boxes;
  for (const double size : {0x1p972, 0x1p988, 0x1p989, 0x1p990, 0x1p1000})
    for (const double end : {-most, most}) {
      const double from = end < 0 ? end : end - size, to = end < 0 ? end + size : end;
      boxes.push_back({{from, from, from}, {to, to, to}});
      boxes.push_back({{from, -size, 0}, {to, size, size}});
      boxes.push_back({{-0.5 * size, -0.5 * size, from}, {0.5 * size, 0.5 * size, to}});
    }
  EXPECT_EQ(overlapping_pairs(boxes, {GetParam()}), overlapping_pairs_by_brute_force(boxes));
}

TEST_P(EveryMethod, FindsNothingAmongNothing) {
  BroadPhase phase({GetParam(), 1});
  EXPECT_TRUE(phase.update().empty());
  const std::vector<Aabb> none(5);
  EXPECT_EQ(phase.add(none), (std::vector<Index>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(phase.update().empty());
  phase.add(std::vector<Aabb>{cube_at(0)});
  EXPECT_TRUE(phase.update().empty());
  phase.move(std::vector<Index>{2}, std::vector<Aabb>{cube_at(1)});
  EXPECT_EQ(list_of(phase.update()), (Pairs{{2, 5}}));
}

INSTANTIATE_TEST_SUITE_P(BroadPhases, EveryMethod,
                         testing::ValuesIn(broad_phase_methods().begin(), broad_phase_methods().end()),
                         [](const auto& method) {
                           std::string name(name_of(method.param));
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(KdTiles, TellEachPairOnceWhereABoxReachesOverSeveralCuts) {
  Crowd crowd("clustered", 100'000);
  crowd.step();
  EXPECT_EQ(overlapping_pairs(crowd.boxes(), {BroadPhaseMethod::kd_tiles, 1}),
            overlapping_pairs(crowd.boxes(), {BroadPhaseMethod::sort_and_sweep, 1}));
}

TEST(Layers, FindTheSameAmongManyMovers) {
  Crowd crowd("static", 200'000);
  BroadPhase layers({BroadPhaseMethod::layers, 2});
  layers.add(crowd.boxes());
  layers.update();
  for (int frame = 0; frame < 2; ++frame) {
    const std::span<const Index> moved = crowd.step();
    ASSERT_GT(moved.size(), 8192U) << "fewer are swept";
    std::vector<Aabb> to;
    for (const Index number : moved) to.push_back(crowd.boxes()[number]);
    layers.move(moved, to);
    EXPECT_TRUE(std::ranges::equal(layers.update(), overlapping_pairs(crowd.boxes(), {BroadPhaseMethod::kd_tiles, 2})));
  }
  EXPECT_FALSE(layers.cells().cells.empty());
}

TEST(Layers, KeepNoTreeOfWhatRestsWhileAllMove) {
  Random random(3);
  const std::vector<Aabb> boxes = test::random_boxes("uniform", 5000, random);
  const std::vector<Aabb> moved = test::random_boxes("uniform", 5000, random);
  const auto bytes_of = [&](BroadPhaseMethod method) {
    BroadPhase phase({method});
    const std::vector<Index> numbers = phase.add(boxes);
    phase.update();
    phase.move(numbers, moved);
    phase.update();
    return phase.bytes();
  };
  EXPECT_LT(bytes_of(BroadPhaseMethod::layers), bytes_of(BroadPhaseMethod::kd_tiles) + 10 * boxes.size());
}

TEST(PairBuffer, HoldsNoMoreThanWhatIsWanted) {
  const PairFilter wanted = [](const IndexPair& pair) { return pair.first % 1000 == 7; };
  PairBuffer all, some;
  all.clear(nullptr);
  some.clear(&wanted);
  for (Index one = 0; one < 1500; ++one)
    for (Index other = 0; other < one; ++other) {
      all.add(one, other);
      some.add(one, other);
    }
  EXPECT_GE(all.bytes(), 2U * sizeof(Index) * 1500 * 1499 / 2);
  EXPECT_LE(some.bytes(), 8U * sizeof(Index) * 2 * 1500);
  PairList left = sorted_pairs(std::span(&some, 1), 1500, 1, {});
  std::erase_if(left, [&](const IndexPair& pair) { return !wanted(pair); });
  PairList expected = sorted_pairs(std::span(&all, 1), 1500, 1, {});
  std::erase_if(expected, [&](const IndexPair& pair) { return !wanted(pair); });
  EXPECT_EQ(left, expected);
}

TEST(BroadPhase, GivesTheLeastNumbersOutAgainAfterAnUpdate) {
  BroadPhase phase;
  phase.add(std::vector<Aabb>(4, cube_at(0)));
  phase.update();
  phase.remove(std::vector<Index>{3, 1});
  EXPECT_EQ(phase.add(std::vector<Aabb>{cube_at(0)}), (std::vector<Index>{4}));
  EXPECT_EQ(list_of(phase.update()), (Pairs{{0, 2}, {0, 4}, {2, 4}}));
  EXPECT_EQ(phase.changes().end, (Pairs{{0, 1}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
  EXPECT_EQ(phase.add(std::vector<Aabb>(3, cube_at(0))), (std::vector<Index>{1, 3, 5}));
  EXPECT_EQ(phase.size(), 6U);
}

TEST(BroadPhase, TellsWhatAnUpdateChanged) {
  BroadPhase phase;
  phase.add(std::vector<Aabb>{cube_at(0), cube_at(1), cube_at(9)});
  phase.update();
  EXPECT_EQ(phase.changes().begin, (Pairs{{0, 1}}));
  phase.update();
  EXPECT_TRUE(phase.changes().begin.empty());
  EXPECT_TRUE(phase.changes().end.empty());
  phase.move(std::vector<Index>{1}, std::vector<Aabb>{cube_at(8)});
  EXPECT_EQ(phase.pairs().size(), 1U);  // of the last update
  phase.update();
  EXPECT_EQ(phase.changes().begin, (Pairs{{1, 2}}));
  EXPECT_EQ(phase.changes().end, (Pairs{{0, 1}}));
}

TEST(BroadPhase, ACopyLivesOnByItself) {
  BroadPhase phase;
  phase.add(std::vector<Aabb>{cube_at(0), cube_at(1), cube_at(9)});
  phase.update();
  BroadPhase copy = phase;
  EXPECT_EQ(copy.changes().begin, (Pairs{{0, 1}}));
  phase.move(std::vector<Index>{1}, std::vector<Aabb>{cube_at(8)});
  phase.update();
  EXPECT_EQ(list_of(copy.pairs()), (Pairs{{0, 1}}));
  copy.remove(std::vector<Index>{0});
  EXPECT_TRUE(copy.update().empty());
  EXPECT_EQ(list_of(phase.pairs()), (Pairs{{1, 2}}));
}

TEST(BroadPhase, RefusesWhatIsNoBoxAndChangesNothing) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  BroadPhase phase;
  phase.add(std::vector<Aabb>{cube_at(0), cube_at(1)});
  phase.update();
  const std::vector<Index> both{0, 1};
  EXPECT_EQ(message_of([&] {
              phase.move(both, std::vector<Aabb>{cube_at(5), {{nan, 0, 0}, {1, 1, 1}}});
            }),
            "box 1: its x is not a number");
  EXPECT_EQ(message_of([&] {
              phase.move(both, std::vector<Aabb>{cube_at(5), {{0, 2, 0}, {1, 1, 1}}});
            }),
            "box 1: its lower y 2 is above its upper y 1");
  EXPECT_EQ(message_of([&] {
              phase.add(std::vector<Aabb>{cube_at(5), {{0, 0, 0}, {1, 1, nan}}});
            }),
            "box 1 of the 2 to add: its z is not a number");
  EXPECT_EQ(message_of([&] { phase.move(both, std::vector<Aabb>{cube_at(5)}); }), "2 numbers with 1 boxes to move to");
  EXPECT_EQ(message_of([&] { phase.remove(std::vector<Index>{0, 0}); }), "box 0 is to be removed twice");
  EXPECT_EQ(message_of([&] {
              phase.remove(std::vector<Index>{0, 7});
            }),
            "box 7 is not in use: it was removed, or never added");
  EXPECT_EQ(list_of(phase.update()), (Pairs{{0, 1}}));
  EXPECT_EQ(phase.box(0), cube_at(0));
  EXPECT_EQ(phase.size(), 2U);
  phase.remove(std::vector<Index>{1});
  EXPECT_EQ(message_of([&] { phase.move(both, std::vector<Aabb>(2)); }),
            "box 1 is not in use: it was removed, or never added");
}

TEST(BroadPhase, ASpatialHashFindsTheSameWithCellsOfAnySize) {
  for (const std::string_view family : {"sizes", "touching", "huge", "denormal"}) {
    Random random(5);
    const std::vector<Aabb> boxes = test::random_boxes(family, 200, random);
    for (const double cell : {1e-300, 0.1, 1.0, 7.5, 1e300})
      EXPECT_EQ(overlapping_pairs(boxes, {BroadPhaseMethod::spatial_hash, 1, cell}),
                overlapping_pairs_by_brute_force(boxes))
          << family << ", cells of " << cell;
  }
  for (const double cell : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_NE(message_of([&] {
                BroadPhase({BroadPhaseMethod::spatial_hash, 1, cell});
              }).find("positive and finite"),
              std::string::npos);
}

TEST(BroadPhase, KnowsItsMethodsByName) {
  for (const BroadPhaseMethod method : broad_phase_methods()) EXPECT_EQ(broad_phase_method(name_of(method)), method);
  EXPECT_EQ(message_of([] { static_cast<void>(broad_phase_method("brute-forse")); }),
            "there is no broad phase 'brute-forse'; did you mean 'brute-force'?");
}

TEST(Offset, BoxesReachAtLeastAsFarAsAsked) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Aabb box = test::random_box("decades", 0, random);
    const double margin = std::pow(10, random.between(-20, 20));
    const Aabb larger = offset_outward(box, margin);
    EXPECT_LT(larger.lower.x, box.lower.x);
    EXPECT_GT(larger.upper.z, box.upper.z);
    EXPECT_GE(box.lower.y - larger.lower.y, margin * (1 - 1e-15));
  }
  EXPECT_EQ(offset_outward(cube_at(0), 0), cube_at(0));
  EXPECT_EQ(offset_outward(Aabb{}, 5), Aabb{});
  EXPECT_EQ(message_of([] { static_cast<void>(offset_outward(cube_at(0), -1)); }),
            "a margin of -1: it must not be negative");
}

}  // namespace
}  // namespace toccata
