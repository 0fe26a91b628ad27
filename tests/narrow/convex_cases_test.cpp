#include "support/convex_cases.hpp"

#include <gtest/gtest.h>

#include <map>

// What the generated pairs of convex shapes are meant to be, they are.
namespace toccata::test {
namespace {

oracle::Relation relation_of(const ConvexCase& pair) {
  return oracle::relation(set_of(pair.a), is_solid(pair.a), set_of(pair.b), is_solid(pair.b));
}

/// How often each relation is that of a regime, over all pairs of kinds.
std::map<oracle::RelationKind, int> relations_of(const std::string& regime) {
  std::map<oracle::RelationKind, int> counts;
  Random random(1);
  for (const std::string& kind_a : convex_kinds())
    for (const std::string& kind_b : convex_kinds())
      ++counts[relation_of(convex_case(kind_a, kind_b, regime, random)).kind];
  return counts;
}

TEST(ConvexCases, PairsThatTouchDoSoExactly) {
  std::map<oracle::RelationKind, int> counts = relations_of("touching");
  EXPECT_EQ(counts.size(), 1U);
  EXPECT_EQ(counts[oracle::RelationKind::touching], 14 * 14);
}

TEST(ConvexCases, FarAndNearPairsAreApart) {
  for (const char* regime : {"far", "near"}) EXPECT_EQ(relations_of(regime)[oracle::RelationKind::apart], 14 * 14);
}

TEST(ConvexCases, ALastPlaceDecides) {
  for (const char* regime : {"ulp", "hair", "close", "parallel"}) {
    std::map<oracle::RelationKind, int> counts = relations_of(regime);
    EXPECT_GT(counts[oracle::RelationKind::apart], 20) << regime;
    EXPECT_GT(counts[oracle::RelationKind::overlapping] + counts[oracle::RelationKind::crossing], 20) << regime;
  }
}

TEST(ConvexCases, TheSameSeedGivesTheSameCase) {
  Random first(7), second(7);
  for (std::uint64_t i = 0; i < 210; ++i)
    ASSERT_EQ(to_text(numbered_case("hull", i, first)), to_text(numbered_case("hull", i, second)));
}

TEST(ConvexCases, ThePosedShapeHasTheVerticesOfTheOracle) {
  Random random(1);
  for (const std::string& kind : convex_kinds())
    for (std::uint64_t i = 0; i < 15; ++i) {
      const ConvexCase pair = numbered_case(kind, i, random);
      const PosedPolytope shape = posed(pair.a);
      const oracle::ConvexSet set = set_of(pair.a);
      ASSERT_EQ(shape.vertex_count(), set.vertices.size()) << kind;
      for (Index v = 0; v < shape.vertex_count(); ++v)
        EXPECT_NE(std::ranges::find(set.vertices, oracle::exact(shape.vertex(v))), set.vertices.end()) << kind;
      EXPECT_EQ(shape.solid(), is_solid(pair.a)) << kind;
    }
}

TEST(ConvexCases, AHalfSpaceTouchesWholeNumbersExactly) {
  Random random(1);
  for (const std::string& kind : convex_kinds())
    for (int i = 0; i < 10; ++i) {
      const HalfSpaceCase pair = half_space_case(kind, "touching", random);
      EXPECT_EQ(oracle::relation(set_of(pair.a), set_of(pair.b)).kind, oracle::RelationKind::touching) << to_text(pair);
    }
}

}  // namespace
}  // namespace toccata::test
