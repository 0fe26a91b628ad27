#include "toccata/partitions/r_tree.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "partitions/r_tree_life.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

TEST(RTree, FindsWhatBruteForceFindsThroughALife) {
  for (const std::string_view family : test::box_families)
    for (const std::uint64_t seed : {1U, 2U})
      EXPECT_EQ(test::complaint_about_r_tree_life(family, seed, 400), "") << family << ", seed " << seed;
}

TEST(RTree, DoesNotGrowWhereBoxesComeAndGo) {
  Random random(1);
  RTree tree;
  for (Index number = 0; number < 300; ++number) tree.insert(number, test::random_box("uniform", 0, random));
  const std::size_t early = tree.bytes();
  for (int step = 0; step < 20'000; ++step) {
    const auto number = static_cast<Index>(random.below(300));
    if (step % 2 == 0) {
      tree.remove(number);
      tree.insert(number, test::random_box("uniform", 0, random));
    } else {
      tree.move(number, test::random_box("uniform", 0, random));
    }
  }
  EXPECT_LE(tree.bytes(), 2 * early);
  EXPECT_EQ(tree.complaint(), "");
}

TEST(RTree, AnEmptyBoxMeetsNothing) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const RTree tree(std::vector<Aabb>{{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}}});
  EXPECT_TRUE(tree.candidates(Aabb{}).empty());
  EXPECT_EQ(tree.candidates({{0, 0, 0}, {1, 1, 1}}).size(), 1U);
}

TEST(RTree, IsPackedFull) {
  Random random(2);
  const RTree packed(test::random_boxes("points", 1'000, random));
  EXPECT_EQ(packed.cells().size(), 63U);  // of 1000 boxes, by sixteens
  EXPECT_EQ(packed.complaint(), "");
  const std::vector<RTree> copies(2, packed);
  EXPECT_EQ(copies[1].candidate_pairs(), packed.candidate_pairs());
}

template <class Call>
std::string message_of_r_tree(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(RTree, RefusesWhatIsNoBoxAndChangesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Aabb unit{{0, 0, 0}, {1, 1, 1}};
  RTree tree;
  tree.insert(4, unit);
  EXPECT_EQ(message_of_r_tree([&] { tree.insert(4, unit); }), "box 4 is there already: move it");
  EXPECT_EQ(message_of_r_tree([&] {
              tree.insert(5, {{0, nan, 0}, {1, 1, 1}});
            }),
            "box 5: its y is not a number, or its lower one is above its upper one");
  EXPECT_EQ(message_of_r_tree([&] {
              tree.move(4, {{0, 0, 2}, {1, 1, 1}});
            }),
            "box 4: its z is not a number, or its lower one is above its upper one");
  EXPECT_EQ(message_of_r_tree([&] { tree.remove(5); }), "there is no box 5: it was removed, or never put in");
  EXPECT_EQ(message_of_r_tree([&] { RTree(std::vector<Aabb>(1)); }),
            "box 0: its x is not a number, or its lower one is above its upper one");
  EXPECT_EQ(tree.box(4), unit);
  EXPECT_EQ(tree.size(), 1U);
  tree.remove(4);
  EXPECT_TRUE(tree.candidates(unit).empty());
  EXPECT_EQ(tree.complaint(), "");
}

}  // namespace
}  // namespace toccata
