#include "trees/wide_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/trees/wide_bvh.hpp"

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
WideBlock& lowest_block(WideBvh& tree) {
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
  const std::vector<std::pair<const char*, std::function<void(WideBvh&)>>> damages = {
      {"an item less", [](WideBvh& t) { t.items.pop_back(); }},
      {"an item twice", [](WideBvh& t) { t.items[3] = t.items[4]; }},
      {"an unknown item", [](WideBvh& t) { t.items[3] = 300; }},
      {"two items swapped", [](WideBvh& t) { std::swap(t.items.front(), t.items.back()); }},
      {"no blocks", [](WideBvh& t) { t.blocks.clear(); }},
      {"a block that nothing leads to", [](WideBvh& t) { t.blocks.push_back(t.blocks.back()); }},
      {"more blocks than items need", [](WideBvh& t) { t.blocks.resize(700, t.blocks.back()); }},
      {"another origin", [](WideBvh& t) { t.origin.x += 1e-3; }},
      {"another unit", [](WideBvh& t) { t.unit *= 2; }},
      {"another box", [](WideBvh& t) { t.box.upper.z += 1; }},
      {"an origin that is nowhere", [&](WideBvh& t) { t.origin.y = not_a_number; }},
      {"no size", [&](WideBvh& t) { t.built_size = not_a_number; }},
      {"no lanes", [](WideBvh& t) { t.blocks[0].count = 0; }},
      {"nine lanes", [](WideBvh& t) { t.blocks[0].count = 9; }},
      {"a lane less", [](WideBvh& t) { --lowest_block(t).count; }},
      {"its own child", [](WideBvh& t) { t.blocks[0].child[0] = 0; }},
      {"a child before it", [](WideBvh& t) { t.blocks.back().child[0] = 0; }},
      {"a child beyond all", [](WideBvh& t) { t.blocks[0].child[0] = 1 << 30; }},
      {"a place beyond all", [](WideBvh& t) { t.blocks[0].child[0] = ~300; }},
      {"the least number", [](WideBvh& t) { t.blocks[0].child[0] = std::numeric_limits<std::int32_t>::min(); }},
      {"the same item in two lanes", [](WideBvh& t) { lowest_block(t).child[0] = lowest_block(t).child[1]; }},
      {"a box too small", [](WideBvh& t) { t.blocks[0].extent[1][0] *= 0.99F; }},
      {"a box elsewhere", [](WideBvh& t) { t.blocks[0].centre[1][0] += 0.1F; }},
      {"a box without end", [](WideBvh& t) { t.blocks[0].extent[1][0] = std::numeric_limits<float>::infinity(); }},
      {"a box far too large", [](WideBvh& t) { t.blocks[0].extent[1][0] = 4; }},
      {"a box that is none", [](WideBvh& t) { t.blocks[0].extent[1][0] = std::nanf(""); }},
      {"a box inside out", [](WideBvh& t) { t.blocks[0].extent[1][0] *= -1; }},
      {"a centre that is nowhere", [](WideBvh& t) { t.blocks[0].centre[2][0] = std::nanf(""); }}};
  const WideBvh tree = build_wide_bvh(boxes);
  ASSERT_EQ(fault_of(tree, boxes), "");
  for (const auto& [what, damage] : damages) {
    WideBvh damaged = tree;
    damage(damaged);
    EXPECT_NE(fault_of(damaged, boxes), "") << what;
  }
}

TEST(WideCheck, TakesABoxThatIsLargerThanNeeded) {
  const std::vector<Aabb> boxes = random_boxes(300);
  WideBvh tree = build_wide_bvh(boxes);
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
    WideBvh tree = build_wide_bvh(boxes_of(moved(0)));
    for (const double share : {0.1, 0.2, 0.3}) {
      refit(tree, moved(share));
      EXPECT_EQ(fault_of(tree, boxes_of(moved(share))), "");
      EXPECT_NE(fault_of(tree, boxes_of(moved(0))), "");
    }
  }
}

TEST(WideCheck, IsOfTheBoxesAndNotOfTheirNumber) {
  std::vector<Aabb> boxes = random_boxes(300);
  const WideBvh tree = build_wide_bvh(boxes);
  boxes[7].lower.x -= 1e-3;
  EXPECT_NE(fault_of(tree, boxes), "");
  EXPECT_NE(fault_of(tree, random_boxes(299)), "");
  EXPECT_EQ(fault_of(WideBvh{}, std::span<const Aabb>()), "");
  EXPECT_NE(fault_of(tree, std::span<const Aabb>()), "");
}

}  // namespace
}  // namespace toccata
