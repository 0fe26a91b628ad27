#include "reports/clash_groups.hpp"

#include <gtest/gtest.h>

namespace toccata {
namespace {

ReportedPair pair_at(Index a, Index b, double x) {
  ReportedPair pair;
  pair.a = a;
  pair.b = b;
  pair.place = {{x, 0, 0}, {x + 1, 1, 1}};
  return pair;
}

using Places = std::vector<std::size_t>;

TEST(ClashGroups, OfAPartAreAllOfTheOneThatHasMost) {
  const std::vector<ReportedPair> pairs{pair_at(0, 1, 0), pair_at(1, 2, 9), pair_at(2, 3, 20), pair_at(1, 4, 40),
                                        pair_at(5, 6, 60)};
  const std::vector<ClashGroup> groups = io::clash_groups(pairs, ClashGrouping::part);
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].part, Index{1});
  EXPECT_EQ(groups[0].pairs, (Places{0, 1, 3}));
  EXPECT_EQ(groups[0].place, (Aabb{{0, 0, 0}, {41, 1, 1}}));
  EXPECT_EQ(groups[1].part, Index{2});
  EXPECT_EQ(groups[1].pairs, (Places{2}));
  EXPECT_EQ(groups[2].part, Index{5});
  EXPECT_EQ(groups[2].pairs, (Places{4}));
}

TEST(ClashGroups, OfARegionAreThoseInAChainOfNeighbouringPlaces) {
  // Each place is 1 wide and reaches 1 farther: those at most 2 apart are neighbours.
  const std::vector<ReportedPair> pairs{pair_at(0, 1, 0), pair_at(2, 3, 50), pair_at(4, 5, 3), pair_at(6, 7, 6),
                                        pair_at(8, 9, 9.5)};
  const std::vector<ClashGroup> groups = io::clash_groups(pairs, ClashGrouping::region);
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].pairs, (Places{0, 2, 3}));
  EXPECT_FALSE(groups[0].part);
  EXPECT_EQ(groups[1].pairs, (Places{1}));
  EXPECT_EQ(groups[2].pairs, (Places{4}));
}

TEST(ClashGroups, AreNoneWhereNoneAreAskedFor) {
  EXPECT_TRUE(io::clash_groups({pair_at(0, 1, 0)}, ClashGrouping::none).empty());
  EXPECT_TRUE(io::clash_groups({}, ClashGrouping::part).empty());
}

}  // namespace
}  // namespace toccata
