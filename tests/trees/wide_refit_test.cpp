#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/trees/wide_bvh.hpp"
#include "trees/wide_boxes.hpp"

namespace toccata {
namespace {

std::vector<Aabb> leaf_boxes_of(const TriangleMesh& mesh) {
  std::vector<Aabb> boxes;
  for (const auto& corners : mesh.triangles()) {
    Aabb& box = boxes.emplace_back();
    for (const Index corner : corners) box = merge(box, mesh.vertices()[corner]);
  }
  return boxes;
}

/// Every lane's box holds the triangles below it; gives the box around them.
Aabb expect_holds(const WideBvh& tree, const std::vector<Aabb>& boxes, std::size_t block) {
  Aabb all;
  for (std::size_t lane = 0; lane < tree.blocks[block].count; ++lane) {
    const WideBlock& here = tree.blocks[block];
    const Aabb below = here.is_item(lane) ? boxes[tree.items[here.item_place(lane)]]
                                          : expect_holds(tree, boxes, static_cast<std::size_t>(here.child[lane]));
    EXPECT_TRUE(contains(box_of(tree, block, lane), below)) << "block " << block << ", lane " << lane;
    all = merge(all, below);
  }
  return all;
}

void expect_fits(const WideBvh& tree, const TriangleMesh& mesh) {
  EXPECT_EQ(expect_holds(tree, leaf_boxes_of(mesh), 0), tree.box);
}

void expect_same(const WideBvh& a, const WideBvh& b) {
  ASSERT_EQ(a.blocks.size(), b.blocks.size());
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.unit, b.unit);
  EXPECT_EQ(a.box, b.box);
  for (std::size_t i = 0; i < a.blocks.size(); ++i) {
    EXPECT_EQ(a.blocks[i].centre, b.blocks[i].centre) << i;
    EXPECT_EQ(a.blocks[i].extent, b.blocks[i].extent) << i;
    EXPECT_EQ(a.blocks[i].child, b.blocks[i].child) << i;
  }
}

/// A mesh whose vertices are moved by a function of them.
template <class Move>
TriangleMesh moved(const TriangleMesh& mesh, const Move& move) {
  std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Vec3& v : vertices) v = move(v);
  return mesh.with_vertices(std::move(vertices));
}

TEST(WideRefit, OfWhatStoodStillIsHardlyLargerThanAsBuilt) {
  const TriangleMesh mesh = generate_mesh("torus-knot");
  WideBvh tree = build_wide_bvh(leaf_boxes_of(mesh));
  const Refit still = refit(tree, mesh);
  expect_fits(tree, mesh);
  EXPECT_NEAR(still.growth, 1, 1e-5);
  EXPECT_FALSE(still.should_rebuild());
  EXPECT_GT(still.volumes_updated, std::size_t{mesh.triangle_count()});
}

TEST(WideRefit, HoldsWhatHasMovedOnAnyNumberOfThreads) {
  const TriangleMesh mesh = generate_mesh("noise-sphere");
  WideBvh tree = build_wide_bvh(leaf_boxes_of(mesh)), on_threads = tree;
  for (const double bend : {0.1, 1.0, 3.0}) {
    const TriangleMesh bent = moved(mesh, [&](const Vec3& v) {
      return Vec3{v.x + bend * v.y * v.y, v.y, v.z + 0.3 * bend * std::sin(5 * v.x)};
    });
    const Refit alone = refit(tree, bent, 1);
    const Refit shared = refit(on_threads, bent, 2);
    EXPECT_EQ(alone.growth, shared.growth);
    expect_fits(tree, bent);
    expect_same(tree, on_threads);
  }
}

TEST(WideRefit, TinyHugeAndFarMeshesKeepTheirDetail) {
  const TriangleMesh mesh = generate_mesh("torus");
  for (const double scale : {1e-300, 1e-9, 1e9, 1e150, 1e307})
    for (const double shift : {0.0, 1e6}) {
      if (scale > 1e300 && shift > 0) continue;  // beyond the doubles
      WideBvh tree = build_wide_bvh(leaf_boxes_of(mesh));
      const TriangleMesh placed = moved(mesh, [&](const Vec3& v) { return scale * (v + Vec3{shift, 0, -shift}); });
      static_cast<void>(refit(tree, placed));
      expect_fits(tree, placed);
    }
}

TEST(WideRefit, IsNotMisledByAFloorThatStands) {
  // Far more area than all that stands on it.
  const TriangleMesh sphere = generate_mesh("noise-sphere");
  std::vector<Vec3> vertices(sphere.vertices().begin(), sphere.vertices().end());
  std::vector<std::array<Index, 3>> triangles(sphere.triangles().begin(), sphere.triangles().end());
  const Index floor = static_cast<Index>(vertices.size());
  vertices.insert(vertices.end(), {{-1e4, -1e4, -2}, {1e4, -1e4, -2}, {0, 1e4, 2}});
  triangles.push_back({floor, floor + 1, floor + 2});
  const TriangleMesh mesh(vertices, triangles);
  WideBvh tree = build_wide_bvh(leaf_boxes_of(mesh));
  EXPECT_FALSE(refit(tree, mesh).should_rebuild());
  Random random(3);
  for (std::size_t i = floor; i > 1; --i) std::swap(vertices[i - 1], vertices[random.below(i)]);
  EXPECT_TRUE(refit(tree, mesh.with_vertices(vertices)).should_rebuild());
}

TEST(WideRefit, TellsWhenToRebuild) {
  const TriangleMesh mesh = generate_mesh("noise-sphere");
  WideBvh tree = build_wide_bvh(leaf_boxes_of(mesh));
  Random random(3);
  std::vector<Vec3> shuffled(mesh.vertices().begin(), mesh.vertices().end());
  for (std::size_t i = shuffled.size(); i > 1; --i) std::swap(shuffled[i - 1], shuffled[random.below(i)]);
  EXPECT_TRUE(refit(tree, mesh.with_vertices(shuffled)).should_rebuild());
  EXPECT_FALSE(refit(tree, mesh).should_rebuild()) << "growth is counted from the build";
  const TriangleMesh point = moved(mesh, [](const Vec3&) { return Vec3{1, 2, 3}; });
  WideBvh of_point = build_wide_bvh(leaf_boxes_of(point));
  EXPECT_FALSE(refit(of_point, point).should_rebuild());
  EXPECT_TRUE(refit(of_point, mesh).should_rebuild()) << "grown from nothing";
}

TEST(WideRefit, VerticesWithoutTrianglesDoNotMatter) {
  const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e300, -1e300, 1e9}}, {{0, 1, 2}});
  WideBvh tree = build_wide_bvh(leaf_boxes_of(mesh));
  static_cast<void>(refit(tree, mesh));
  expect_fits(tree, mesh);
}

TEST(WideRefit, ATreeOfAnotherMeshIsRefused) {
  WideBvh tree = build_wide_bvh(leaf_boxes_of(generate_mesh("torus")));
  EXPECT_THROW(static_cast<void>(refit(tree, generate_mesh("torus-knot"))), Error);
}

}  // namespace
}  // namespace toccata
