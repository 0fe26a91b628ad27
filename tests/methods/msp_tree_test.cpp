#include "toccata/methods/msp_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "methods/msp_checks.hpp"
#include "support/data.hpp"
#include "support/error_message.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/query/nearest.hpp"
#include "toccata/query/self_contacts.hpp"

namespace toccata {
namespace {

using test::closed_meshes_and_more, test::generated, test::location_by_all, test::on_grid, test::telling_points,
    test::vertex_of;

/// How many points were on what.
struct KindCounts {
  std::array<std::size_t, 3> on{};
  std::size_t off = 0;
};

void expect_located(const MspTree& tree, const Model& model, const Vec3& p, KindCounts& counts) {
  const MspLocation found = tree.locate(p), truth = location_by_all(p, model);
  SCOPED_TRACE(testing::Message() << p.x << " " << p.y << " " << p.z);
  ASSERT_EQ(found.side, truth.side);
  ASSERT_EQ(found.winding_number, truth.winding_number);
  ASSERT_EQ(found.triangle, truth.triangle);
  ASSERT_EQ(found.feature, truth.feature);
  ++(truth.side == Side::boundary ? counts.on[static_cast<std::size_t>(truth.feature.kind)] : counts.off);
}

TEST(MspTree, LocatesAllThatEveryTriangleTellsInRationals) {
  KindCounts counts;
  std::size_t meshes = 0;
  for (const auto& [name, mesh] : closed_meshes_and_more()) {
    SCOPED_TRACE(name);
    const Model model(mesh);
    const MspTree tree(model);
    for (const Vec3& p : telling_points(model, 640, 1)) expect_located(tree, model, p, counts);
    ++meshes;
  }
  EXPECT_GE(meshes, 20U);
  for (const std::size_t on : counts.on) EXPECT_GT(on, 500U);
  EXPECT_GT(counts.off, 2000U);
}

TEST(MspTree, LocatesTheSameWhicheverPlanesAreChosen) {
  KindCounts counts;
  for (const auto& [name, mesh] : closed_meshes_and_more()) {
    SCOPED_TRACE(name);
    if (mesh.triangle_count() > 400) continue;
    const Model model(mesh);
    for (const BspOptions& options :
         {BspOptions{.axis_planes = false, .max_growth = 1000}, BspOptions{.split_weight = 0, .max_growth = 1000},
          BspOptions{.split_weight = 100, .candidates = 1, .max_growth = 1000}}) {
      const MspTree tree(model, options);
      for (const Vec3& p : telling_points(model, 160, 2)) expect_located(tree, model, p, counts);
    }
  }
  for (const std::size_t on : counts.on) EXPECT_GT(on, 100U);
}

// Half of the coordinates are those of planes of faces: so many points lie in one, on a line of edges, or on a corner.
TEST(MspTree, LocatesQuartersOfVoxelsInAndAroundSolidsOfThem) {
  Random random(5);
  KindCounts counts;
  std::size_t made = 0;
  for (int i = 0; i < 16; ++i) {
    const Model model(test::mesh_of(test::random_voxels(random, 6, 3), test::Skin::outer, random));
    if (self_overlap(model)) continue;
    const MspTree tree(model);
    const oracle::MeshSet truth = oracle::solid_set(model.mesh(), Pose{});
    ++made;
    for (int j = 0; j < 40; ++j) {
      const auto step = [&] {
        const auto n = static_cast<double>(random.below(17));
        return random.below(2) == 0 ? std::floor(0.25 * n) : 0.25 * n - 0.5;
      };
      const Vec3 p{step(), step(), step()};
      expect_located(tree, model, p, counts);
      const oracle::Location slow = oracle::locate(oracle::exact(p), truth);
      ASSERT_EQ(tree.locate(p).side == Side::boundary, slow.on_face);
      ASSERT_EQ(tree.locate(p).winding_number, slow.winding_number);
    }
  }
  EXPECT_GT(made, 4U);
  for (const std::size_t on : counts.on) EXPECT_GT(on, 10U);
}

TEST(MspTree, NamesTheNearestTriangleOfPointsOnTheSurface) {
  for (const char* name : {"gen:box", "gen:gear", "gen:torus"}) {
    SCOPED_TRACE(name);
    const Model model(on_grid(generated(name), 4096));
    const MspTree tree(model);
    for (const Vec3& p : telling_points(model, 400, 3)) {
      const MspLocation found = tree.locate(p);
      const std::optional<SurfacePoint> nearest = nearest_point(p, model);
      ASSERT_EQ(found.side == Side::boundary, nearest->upper == 0);
      if (found.side != Side::boundary) continue;
      ASSERT_EQ(found.triangle, nearest->element);
    }
  }
}

struct VertexOrder {
  bool operator()(const Vec3& a, const Vec3& b) const { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }
};

// Every point of space lies in one region, so a vertex is a region, and an edge or a face one or several.
TEST(MspTree, HasOneRegionForEachVertexAndAtLeastOneForEachEdgeAndFace) {
  for (const auto& [name, mesh] : closed_meshes_and_more()) {
    SCOPED_TRACE(name);
    const MspStatistics s = MspTree(Model(mesh)).statistics();
    std::set<Vec3, VertexOrder> vertices;
    std::set<std::pair<Vec3, Vec3>, bool (*)(const std::pair<Vec3, Vec3>&, const std::pair<Vec3, Vec3>&)> edges(
        [](const auto& a, const auto& b) {
          const VertexOrder less;
          return less(a.first, b.first) || (!less(b.first, a.first) && less(a.second, b.second));
        });
    for (Index t = 0; t < mesh.triangle_count(); ++t)
      for (int i = 0; i < 3; ++i) {
        const Vec3 p = vertex_of(mesh, t, i), q = vertex_of(mesh, t, i + 1);
        vertices.insert(p);
        edges.insert(VertexOrder{}(p, q) ? std::pair(p, q) : std::pair(q, p));
      }
    EXPECT_EQ(s.vertices, vertices.size());
    EXPECT_GE(s.edges, edges.size());
    EXPECT_GE(s.faces, s.triangles);
    EXPECT_LT(static_cast<double>(s.edges), 8.0 * static_cast<double>(edges.size()));
  }
}

TEST(MspTree, OfABoxIsSixPlanesEachWithItsLinesAndPoints) {
  const MspStatistics s = MspTree(Model(test::box_between({0, 0, 0}, {1, 2, 3})), {.axis_planes = false}).statistics();
  EXPECT_EQ(s.triangles, 12U);
  EXPECT_EQ(s.planes, 6U);
  EXPECT_EQ(s.vertices, 8U);
  EXPECT_EQ(s.edges, 18U);  // twelve, and a diagonal of each side
  EXPECT_EQ(s.lines, s.edges);
  EXPECT_EQ(s.points, s.vertices);
  EXPECT_EQ(s.faces, 12U);
  EXPECT_EQ(s.splits, 0U);
}

TEST(MspTree, IsTheSameEachTime) {
  const Model model(generated("gen:noise-sphere"));
  const MspStatistics a = MspTree(model).statistics(), b = MspTree(model).statistics();
  EXPECT_EQ(std::tie(a.planes, a.lines, a.points, a.depth, a.bytes),
            std::tie(b.planes, b.lines, b.points, b.depth, b.bytes));
}

TEST(MspTree, OfABallIsNoChainInAnyDimension) {
  const MspStatistics s = MspTree(Model(icosphere_mesh(1, 4))).statistics();
  EXPECT_LT(s.depth, 70U);
}

std::string msp_error_of(const TriangleMesh& mesh, const BspOptions& options = {}) {
  return test::message_of([&] { static_cast<void>(MspTree(Model(mesh), options)); });
}

TEST(MspTree, RefusesWhatIsNoSolidAndSaysWhy) {
  EXPECT_NE(msp_error_of(oracle::single_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})).find("this one is open: 3 edges"),
            std::string::npos);
  const TriangleMesh crossing =
      oracle::joined(test::box_between({0, 0, 0}, {2, 2, 2}), test::box_between({1, 1, 1}, {3, 3, 3}));
  EXPECT_NE(msp_error_of(crossing).find("and this one does: "), std::string::npos);
  EXPECT_NE(msp_error_of(test::box_between({0, 0, 0}, {1, 1, 1}), {.candidates = 0}), "");
}

TEST(MspTree, RefusesPointsThatAreNotFiniteAndGivesUpWhereItWouldGrowTooMuch) {
  const MspTree tree(Model(test::box_between({0, 0, 0}, {1, 1, 1})));
  EXPECT_THROW(static_cast<void>(tree.locate({std::numeric_limits<double>::infinity(), 0, 0})), Error);
  EXPECT_THROW(static_cast<void>(tree.locate({0, std::numeric_limits<double>::quiet_NaN(), 0})), Error);
  EXPECT_NE(msp_error_of(generated("gen:torus-knot"), {.max_growth = 1.5}).find("more than 1.5 times as many"),
            std::string::npos);
}

TEST(MspTree, OfRealMeshesLocatesWhatEveryTriangleTells) {
  const auto data = test::data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA";
  for (const char* name : {"fandisk", "rocker-arm", "spot"}) {
    SCOPED_TRACE(name);
    const Model model(read_mesh((*data / "meshes" / (std::string(name) + ".obj")).string()));
    const MspTree tree(model);
    KindCounts counts;
    for (const Vec3& p : telling_points(model, 300, 9)) expect_located(tree, model, p, counts);
    EXPECT_GT(counts.on[0], 30U);
  }
}

}  // namespace
}  // namespace toccata
