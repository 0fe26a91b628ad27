#include "toccata/query/scene_hierarchy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/trees/builders.hpp"

namespace toccata {
namespace {

struct BadGraph {
  const char* name;
  std::function<Scene(std::size_t, std::uint64_t)> make;
};

const std::vector<BadGraph> bad_graphs = {
    {"by kind", parts_by_kind}, {"chain", parts_in_a_chain}, {"side by side", parts_side_by_side}};

std::vector<Aabb> boxes_of(const Scene& scene) {
  std::vector<Aabb> boxes;
  for (const SceneObject& object : scene.objects) {
    Aabb& box = boxes.emplace_back();
    for (const auto& corners : object.mesh()->triangles())
      for (const Index corner : corners) box = merge(box, transform(object.pose, object.mesh()->vertices()[corner]));
  }
  return boxes;
}

std::vector<ItemPair> by_brute_force(const Scene& scene) {
  std::vector<ItemPair> pairs;
  for (const IndexPair& pair : overlapping_pairs_by_brute_force(boxes_of(scene)))
    pairs.push_back({pair.first, pair.second});
  return pairs;
}

/// Every object in one leaf, every box just around its children, children after their parents.
void expect_valid(const SceneHierarchy& hierarchy, std::size_t objects) {
  const auto& nodes = hierarchy.tree.nodes;
  ASSERT_EQ(hierarchy.scene_nodes.size(), nodes.size());
  std::vector<Index> items = hierarchy.tree.items;
  items.insert(items.end(), hierarchy.unbounded.begin(), hierarchy.unbounded.end());
  std::sort(items.begin(), items.end());
  ASSERT_EQ(items.size(), objects);
  for (Index i = 0; i < items.size(); ++i) ASSERT_EQ(items[i], i);
  std::vector<int> parents(nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    ASSERT_NE(nodes[i].is_leaf(), nodes[i].child_count > 0);
    ASSERT_LE(nodes[i].count, 1U);
    Aabb around;
    for (Index child = 0; child < nodes[i].child_count; ++child) {
      ASSERT_GT(nodes[i].first + child, i);
      ++parents.at(nodes[i].first + child);
      around = merge(around, nodes[nodes[i].first + child].volume);
    }
    if (!nodes[i].is_leaf()) {
      ASSERT_EQ(around, nodes[i].volume);
    }
  }
  EXPECT_EQ(std::count(parents.begin(), parents.end(), 1), static_cast<std::ptrdiff_t>(nodes.size()) - 1);
}

WalkCounts counts_of_direct_build(const Scene& scene) {
  const Bvh<Aabb> direct = build_bvh(boxes_of(scene), {.leaf_size = 1});
  SceneHierarchy same;
  same.tree.nodes = direct.nodes;
  same.tree.items = direct.items;
  return report_of(same).counts;
}

TEST(SceneHierarchy, IsTheTreeOfNodes) {
  const SceneHierarchy kinds = hierarchy_of(parts_by_kind(200, 1));
  expect_valid(kinds, 200);
  const HierarchyReport report = report_of(kinds);
  ASSERT_EQ(report.levels.size(), 4U);  // the machine, the kinds, the parts' nodes, the parts
  EXPECT_EQ(report.levels[0].most_children, report.levels[1].nodes);
  EXPECT_EQ(report.levels[2].nodes, 200U);
  EXPECT_EQ(report.levels[3].leaves, 200U);
  EXPECT_EQ(report.levels[2].most_children, 1U);
  EXPECT_EQ(report.leaves, 200U);
  EXPECT_EQ(report.mean_depth, 3);
  EXPECT_EQ(report.nodes, 1 + report.levels[1].nodes + 400);
  // What is grouped by function overlaps everywhere.
  EXPECT_EQ(report.levels[0].overlapping_sibling_pairs, report.levels[0].sibling_pairs);
  EXPECT_EQ(report_of(hierarchy_of(parts_in_a_chain(50, 1))).levels.size(), 52U);
  EXPECT_EQ(report_of(hierarchy_of(parts_side_by_side(50, 1))).most_children, 50U);
}

TEST(SceneHierarchy, EveryOneFindsThePairsOfBruteForce) {
  for (const BadGraph& graph : bad_graphs)
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      SCOPED_TRACE(testing::Message() << graph.name << ", seed " << seed);
      const Scene scene = graph.make(120, seed);
      const auto pairs = by_brute_force(scene);
      ASSERT_FALSE(pairs.empty());
      const SceneHierarchy as_is = hierarchy_of(scene);
      EXPECT_EQ(overlapping_objects(as_is), pairs);
      for (const Rebalance how : {Rebalance::rebuild, Rebalance::cure}) {
        const SceneHierarchy better = rebalanced(as_is, how);
        expect_valid(better, 120);
        EXPECT_EQ(overlapping_objects(better), pairs);
        EXPECT_EQ(report_of(better).counts.items, pairs.size());
      }
    }
}

TEST(SceneHierarchy, RebalancedCostsNoMoreThanADirectBuild) {
  for (const BadGraph& graph : bad_graphs) {
    SCOPED_TRACE(graph.name);
    const Scene scene = graph.make(500, 3);
    const WalkCounts direct = counts_of_direct_build(scene);
    const HierarchyReport as_is = report_of(hierarchy_of(scene));
    for (const Rebalance how : {Rebalance::rebuild, Rebalance::cure}) {
      const HierarchyReport better = report_of(rebalanced(hierarchy_of(scene), how));
      EXPECT_EQ(better.counts.items, direct.items);
      // The pairs of objects are the same ones, so the tests of boxes are what may differ.
      EXPECT_LE(static_cast<double>(better.counts.volume_tests), 1.2 * static_cast<double>(direct.volume_tests));
      EXPECT_LE(5 * better.cost(), as_is.cost());
      EXPECT_LE(better.levels.size(), 30U);
    }
  }
}

/// Eight heaps of parts far from each other, each below a node of its own.
Scene heaps() {
  Scene all;
  for (int heap = 0; heap < 8; ++heap) {
    const auto node = static_cast<Index>(all.nodes.size());
    all.nodes.push_back({"heap " + std::to_string(heap), std::nullopt, Pose::translation(100 * heap, 0, 0)});
    for (SceneObject object : many_parts(20, 1 + static_cast<std::uint64_t>(heap)).objects) {
      object.pose = all.nodes[node].pose * object.pose;
      object.node = node;
      all.objects.push_back(std::move(object));
    }
  }
  return all;
}

TEST(SceneHierarchy, TheCureKeepsNodesThatAreGood) {
  const SceneHierarchy as_is = hierarchy_of(heaps());
  const SceneHierarchy cured = rebalanced(as_is, Rebalance::cure);
  const auto kept = [](const SceneHierarchy& hierarchy) {
    return std::count_if(hierarchy.scene_nodes.begin(), hierarchy.scene_nodes.end(),
                         [](const std::optional<Index>& node) { return node.has_value(); });
  };
  EXPECT_EQ(kept(as_is), 8);
  EXPECT_EQ(kept(cured), 8);
  EXPECT_EQ(kept(rebalanced(as_is, Rebalance::rebuild)), 0);
  EXPECT_EQ(overlapping_objects(cured), overlapping_objects(as_is));
  EXPECT_LT(report_of(cured).cost(), report_of(as_is).cost());
  EXPECT_EQ(kept(rebalanced(cured, Rebalance::cure)), 8);
}

TEST(SceneHierarchy, TheCostIsThatOfItsTests) {
  const HierarchyReport report = report_of(hierarchy_of(parts_by_kind(60, 2)));
  EXPECT_EQ(report.cost(), static_cast<double>(report.counts.volume_tests + report.counts.items));
  EXPECT_EQ(report.cost({3, 100}), static_cast<double>(3 * report.counts.volume_tests + 100 * report.counts.items));
}

TEST(SceneHierarchy, OddScenes) {
  EXPECT_TRUE(hierarchy_of({}).tree.nodes.empty());
  EXPECT_TRUE(rebalanced(hierarchy_of({})).tree.nodes.empty());
  EXPECT_EQ(report_of(hierarchy_of({})).cost(), 0);
  Scene scene;
  scene.nodes = {{"nothing", std::nullopt, {}}, {"holder", std::nullopt, {}}, {"nothing either", 1, {}}};
  SceneObject ball;
  ball.name = "ball";
  ball.shape = Sphere(1);
  ball.node = 1;
  scene.objects.push_back(ball);
  // Nodes without objects are left out, and one that has all of them is the root.
  SceneHierarchy hierarchy = hierarchy_of(scene);
  expect_valid(hierarchy, 1);
  ASSERT_EQ(hierarchy.tree.nodes.size(), 2U);
  EXPECT_EQ(hierarchy.scene_nodes[0], std::optional<Index>(1));
  for (const Rebalance how : {Rebalance::rebuild, Rebalance::cure}) expect_valid(rebalanced(hierarchy, how), 1);
  // What has no node is beside it, and what has no end is nowhere.
  SceneObject ground = ball;
  ground.name = "ground";
  ground.shape = HalfSpace({0, 0, 0}, {0, 0, 1});
  ground.node = std::nullopt;
  scene.objects.push_back(ground);
  SceneObject box = ground;
  box.name = "box";
  box.shape = Box({1, 2, 3});
  scene.objects.push_back(box);
  hierarchy = hierarchy_of(scene);
  expect_valid(hierarchy, 3);
  EXPECT_EQ(hierarchy.unbounded, std::vector<Index>{1});
  EXPECT_EQ(hierarchy.scene_nodes[0], std::nullopt);
  EXPECT_EQ(rebalanced(hierarchy).unbounded, std::vector<Index>{1});
  EXPECT_EQ(overlapping_objects(hierarchy), (std::vector<ItemPair>{{0, 2}}));
  scene.objects[0].pose.linear = {{{{1, 2, 0}, {0, 1, 0}, {0, 0, 1}}}};
  EXPECT_THROW(static_cast<void>(hierarchy_of(scene)), Error);
}

TEST(SceneHierarchy, PartsThatCoincideOrLieOnALine) {
  for (const double step : {0.0, 3.0}) {
    Scene scene = parts_in_a_chain(60, 5);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      scene.objects[i].shape = Point(Vec3{step * static_cast<double>(i), 0, 0});
      scene.objects[i].pose = {};
    }
    const SceneHierarchy as_is = hierarchy_of(scene);
    const std::size_t pairs = step == 0 ? 60 * 59 / 2 : 0;
    for (const Rebalance how : {Rebalance::rebuild, Rebalance::cure}) {
      expect_valid(rebalanced(as_is, how), 60);
      EXPECT_EQ(overlapping_objects(rebalanced(as_is, how)).size(), pairs);
      EXPECT_LE(report_of(rebalanced(as_is, how)).levels.size(), 10U);
    }
  }
}

TEST(SceneHierarchy, AChainOfThousandsIsNoTrouble) {
  const SceneHierarchy chain = hierarchy_of(parts_in_a_chain(2000, 1));
  EXPECT_EQ(chain.tree.items.size(), 2000U);
  EXPECT_LE(report_of(rebalanced(chain, Rebalance::cure)).levels.size(), 40U);
}

}  // namespace
}  // namespace toccata
