#include "trees/wide_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/trees/refit.hpp"

namespace toccata {
namespace {

std::vector<Aabb> random_boxes(std::size_t count) {
  Random random(5);
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.between(-1, 1), y = random.between(-1, 1), z = random.between(-1, 1);
    boxes.push_back({{x, y, z}, {x + 0.1, y + 0.1, z + 0.1}});
  }
  return boxes;
}

/// The first block all of whose lanes are items.
WideBlock& lowest_block(WideTree& tree) {
  for (WideBlock& block : tree.blocks) {
    bool only_items = true;
    for (std::size_t lane = 0; lane < block.count; ++lane) only_items = only_items && block.is_item(lane);
    if (only_items) return block;
  }
  return tree.blocks.back();
}

/// (A tree without blocks or with what builders make is in wide_build_test.cpp.)
TEST(WideCheck, SeesWhatIsWrong) {
  const std::vector<Aabb> boxes = random_boxes(300);
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<const char*, std::function<void(WideTree&)>>> damages = {
      {"an item less", [](WideTree& t) { t.items.pop_back(); }},
      {"an item twice", [](WideTree& t) { t.items[3] = t.items[4]; }},
      {"an unknown item", [](WideTree& t) { t.items[3] = 300; }},
      {"two items swapped", [](WideTree& t) { std::swap(t.items.front(), t.items.back()); }},
      {"no blocks", [](WideTree& t) { t.blocks.clear(); }},
      {"a block that nothing leads to", [](WideTree& t) { t.blocks.push_back(t.blocks.back()); }},
      {"more blocks than items need", [](WideTree& t) { t.blocks.resize(700, t.blocks.back()); }},
      {"another origin", [](WideTree& t) { t.origin.x += 1e-3; }},
      {"another unit", [](WideTree& t) { t.unit *= 2; }},
      {"another box", [](WideTree& t) { t.box.upper.z += 1; }},
      {"an origin that is nowhere", [&](WideTree& t) { t.origin.y = not_a_number; }},
      {"no size", [&](WideTree& t) { t.built_size = not_a_number; }},
      {"no lanes", [](WideTree& t) { t.blocks[0].count = 0; }},
      {"nine lanes", [](WideTree& t) { t.blocks[0].count = 9; }},
      {"a lane less", [](WideTree& t) { --lowest_block(t).count; }},
      {"its own child", [](WideTree& t) { t.blocks[0].child[0] = 0; }},
      {"a child before it", [](WideTree& t) { t.blocks.back().child[0] = 0; }},
      {"a child beyond all", [](WideTree& t) { t.blocks[0].child[0] = 1 << 30; }},
      {"a place beyond all", [](WideTree& t) { t.blocks[0].child[0] = ~300; }},
      {"the least number", [](WideTree& t) { t.blocks[0].child[0] = std::numeric_limits<std::int32_t>::min(); }},
      {"the same item in two lanes", [](WideTree& t) { lowest_block(t).child[0] = lowest_block(t).child[1]; }},
      {"a box too small", [](WideTree& t) { t.blocks[0].extent[1][0] *= 0.99F; }},
      {"a box elsewhere", [](WideTree& t) { t.blocks[0].centre[1][0] += 0.1F; }},
      {"a box without end", [](WideTree& t) { t.blocks[0].extent[1][0] = std::numeric_limits<float>::infinity(); }},
      {"a box far too large", [](WideTree& t) { t.blocks[0].extent[1][0] = 4; }},
      {"a box that is none", [](WideTree& t) { t.blocks[0].extent[1][0] = std::nanf(""); }},
      {"a box inside out", [](WideTree& t) { t.blocks[0].extent[1][0] *= -1; }},
      {"a centre that is nowhere", [](WideTree& t) { t.blocks[0].centre[2][0] = std::nanf(""); }}};
  const WideTree tree = build_wide_tree(boxes);
  ASSERT_EQ(fault_of(tree, boxes), "");
  for (const auto& [what, damage] : damages) {
    WideTree damaged = tree;
    damage(damaged);
    EXPECT_NE(fault_of(damaged, boxes), "") << what;
  }
}

TEST(WideCheck, TakesABoxThatIsLargerThanNeeded) {
  const std::vector<Aabb> boxes = random_boxes(300);
  WideTree tree = build_wide_tree(boxes);
  tree.blocks.back().extent[0][0] *= 1.25F;
  // Its parents' boxes have to hold items, not the boxes of their children.
  EXPECT_EQ(fault_of(tree, boxes), "");
}

TEST(WideCheck, TakesARefittedTree) {
  const TriangleMesh mesh = generate_mesh("noise-sphere", {{"subdivisions", 3}});
  for (const double scale : {1e-310, 1e-200, 1.0, 1e300}) {
    SCOPED_TRACE(scale);
    const auto moved = [&](double share) {
      std::vector<Vec3> vertices;
      for (const Vec3& v : mesh.vertices()) vertices.push_back(scale * (v + Vec3{share * v.y * v.z, 0, share * v.x}));
      return mesh.with_vertices(std::move(vertices));
    };
    const auto boxes_of = [](const TriangleMesh& of) {
      std::vector<Aabb> boxes;
      for (const auto& corners : of.triangles()) {
        Aabb& box = boxes.emplace_back();
        for (const Index corner : corners) box = merge(box, of.vertices()[corner]);
      }
      return boxes;
    };
    WideTree tree = build_wide_tree(boxes_of(moved(0)));
    for (const double share : {0.1, 0.2, 0.3}) {
      refit(tree, moved(share));
      EXPECT_EQ(fault_of(tree, boxes_of(moved(share))), "");
      EXPECT_NE(fault_of(tree, boxes_of(moved(0))), "");
    }
  }
}

TEST(WideCheck, IsOfTheBoxesAndNotOfTheirNumber) {
  std::vector<Aabb> boxes = random_boxes(300);
  const WideTree tree = build_wide_tree(boxes);
  boxes[7].lower.x -= 1e-3;
  EXPECT_NE(fault_of(tree, boxes), "");
  EXPECT_NE(fault_of(tree, random_boxes(299)), "");
  EXPECT_EQ(fault_of(WideTree{}, {}), "");
  EXPECT_NE(fault_of(tree, {}), "");
}

}  // namespace
}  // namespace toccata
