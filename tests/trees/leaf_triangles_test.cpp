#include "trees/leaf_triangles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "oracle/rational.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

WideBvh bvh_over(const TriangleMesh& mesh) {
  std::vector<Aabb> boxes;
  for (const auto& corner : mesh.triangles())
    boxes.push_back(merge(merge(merge(Aabb{}, mesh.vertices()[corner[0]]), mesh.vertices()[corner[1]]),
                          mesh.vertices()[corner[2]]));
  return build_wide_bvh(boxes);
}

TriangleMesh scaled_and_moved(const TriangleMesh& mesh, double scale, const Vec3& by) {
  std::vector<Vec3> vertices;
  for (const Vec3& v : mesh.vertices()) vertices.push_back(scale * v + by);
  return mesh.with_vertices(std::move(vertices));
}

/// How far a coordinate of a lane is from the vertex's, in the tree's units, exactly.
Rational distance_off(const WideBvh& tree, float coordinate, double vertex, int axis) {
  const Rational off = exact(double{coordinate}) - (exact(vertex) - exact(tree.origin[axis])) / exact(tree.unit);
  return off < Rational(0) ? -off : off;
}

/// Every item's lane tells its triangle; the others hold zeros.
void expect_triangles(const WideBvh& tree, const TriangleMesh& mesh) {
  const LeafTriangles all = leaf_triangles(tree, mesh);
  ASSERT_EQ(all.of_block.size(), tree.blocks.size());
  const Rational off = exact(double{all.off});
  for (std::size_t number = 0; number < tree.blocks.size(); ++number) {
    const WideBlock& block = tree.blocks[number];
    const TriangleLanes& lanes = all.of_block[number];
    for (std::size_t lane = 0; lane < WideBlock::width; ++lane) {
      const bool item = lane < block.count && block.is_item(lane);
      const Index triangle = item ? tree.items[block.item_place(lane)] : 0;
      ASSERT_EQ(lanes.number[lane], triangle);
      for (std::size_t corner = 0; corner < 3; ++corner)
        for (int axis = 0; axis < 3; ++axis) {
          const float coordinate = lanes.corner[corner][static_cast<std::size_t>(axis)][lane];
          if (!item)
            ASSERT_EQ(coordinate, 0);
          else
            ASSERT_LE(distance_off(tree, coordinate, mesh.vertices()[mesh.triangles()[triangle][corner]][axis], axis),
                      off);
        }
    }
  }
}

TEST(LeafTriangles, AreThoseOfTheMeshUpToTheBoundTold) {
  const TriangleMesh mesh = generate_mesh("noise-sphere", {{"subdivisions", 2}});
  for (const double scale : {1e-310, 1e-200, 1e-5, 1.0, 1e20, 1.7e308})
    for (const double share : {0.0, 1e3, 1e12}) {
      if (scale > 1e300 && share > 0) continue;
      SCOPED_TRACE(std::to_string(scale) + " " + std::to_string(share));
      const TriangleMesh placed =
          scaled_and_moved(mesh, 0.5 * scale, {share * scale, -share * scale, 0.3 * share * scale});
      expect_triangles(bvh_over(placed), placed);
    }
}

TEST(LeafTriangles, OfARefittedTreeAreThoseOfTheMovedMesh) {
  const TriangleMesh mesh = generate_mesh("torus");
  WideBvh tree = bvh_over(mesh);
  const TriangleMesh moved = scaled_and_moved(mesh, 3e7, {5, 1e9, -2e8});
  static_cast<void>(refit(tree, moved));
  expect_triangles(tree, moved);
}

TEST(LeafTriangles, OfAWholeLongerThanTheGreatestDoubleAreBoundedToo) {
  const double m = 1.7e308;
  const TriangleMesh mesh({{-m, -m, -m}, {m, m, m}, {m, -m, 0.3 * m}, {1, 2, 3}}, {{0, 1, 2}, {1, 2, 3}, {3, 3, 3}});
  expect_triangles(bvh_over(mesh), mesh);
}

}  // namespace
}  // namespace toccata::test
