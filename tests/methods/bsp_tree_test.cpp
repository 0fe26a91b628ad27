#include "toccata/methods/bsp_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "methods/closed_meshes.hpp"
#include "oracle/oracle.hpp"
#include "oracle/test_meshes.hpp"
#include "support/data.hpp"
#include "support/error_message.hpp"
#include "support/mesh_soups.hpp"
#include "support/voxel_solids.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/narrow/triangle_triangle.hpp"
#include "toccata/query/self_contacts.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata {
namespace {

using test::closed_meshes, test::generated, test::telling_points, test::vertex_of;

void expect_located_alike(const BspTree& tree, const Model& model, const Vec3& p) {
  const BspLocation found = tree.locate(p);
  const PointLocation truth = locate(p, model);
  ASSERT_EQ(found.side, truth.side) << p.x << " " << p.y << " " << p.z;
  ASSERT_EQ(found.winding_number, truth.winding_number) << p.x << " " << p.y << " " << p.z;
}

TEST(BspTree, LocatesAsTheModelDoes) {
  for (const auto& [name, mesh] : closed_meshes()) {
    SCOPED_TRACE(name);
    const Model model(mesh);
    const BspTree tree(model);
    for (const Vec3& p : telling_points(model, 2000, 1)) expect_located_alike(tree, model, p);
  }
}

TEST(BspTree, LocatesAsTheModelDoesWhicheverPlanesAreChosen) {
  for (const auto& [name, mesh] : closed_meshes()) {
    SCOPED_TRACE(name);
    if (mesh.triangle_count() > 700) continue;
    const Model model(mesh);
    for (const BspOptions& options :
         {BspOptions{.axis_planes = false, .max_growth = 1000}, BspOptions{.split_weight = 0, .max_growth = 1000},
          BspOptions{.split_weight = 100, .candidates = 1, .max_growth = 1000}}) {
      const BspTree tree(model, options);
      for (const Vec3& p : telling_points(model, 400, 2)) expect_located_alike(tree, model, p);
    }
  }
}

/// The least triangle that the point lies on, in rationals.
Index least_triangle_on(const Vec3& p, const oracle::MeshSet& set) {
  for (std::size_t t = 0; t < set.triangles.size(); ++t)
    if (oracle::contains(set.triangles[t], oracle::exact(p))) return static_cast<Index>(t);
  return 0;
}

TEST(BspTree, LocatesSolidsOfVoxelsAsRationalsDoAndNamesTheLeastTriangleThatAPointLiesOn) {
  Random random(5);
  std::size_t on_faces = 0, made = 0;
  for (int i = 0; i < 30; ++i) {
    const Model model(test::mesh_of(test::random_voxels(random, 5, 3), test::Skin::outer, random));
    if (self_overlap(model)) continue;  // where voxels meet in a corner or an edge, triangles of both may
    const BspTree tree(model);
    const oracle::MeshSet truth = oracle::solid_set(model.mesh(), Pose{});
    ++made;
    for (int j = 0; j < 60; ++j) {
      const auto half = [&] { return 0.5 * static_cast<double>(random.below(9)) - 0.5; };
      const Vec3 p{half(), half(), half()};
      const oracle::Location expected = oracle::locate(oracle::exact(p), truth);
      const BspLocation found = tree.locate(p);
      ASSERT_EQ(found.side == Side::boundary, expected.on_face);
      ASSERT_EQ(found.winding_number, expected.winding_number);
      if (!expected.on_face) continue;
      ASSERT_EQ(found.triangle, least_triangle_on(p, truth));
      ++on_faces;
    }
  }
  EXPECT_GT(made, 5U);
  EXPECT_GT(on_faces, 100U);
}

TEST(BspTree, IsMeasuredAsItIs) {
  const Model model(generated("gen:torus-knot"));
  const BspTree tree(model);
  const BspStatistics& s = tree.statistics();
  EXPECT_EQ(s.triangles, model.mesh().triangle_count());
  EXPECT_EQ(s.fragments, s.triangles + s.splits);
  EXPECT_EQ(s.leaves, s.nodes + 1);
  EXPECT_LT(s.growth(), 4);
  EXPECT_LT(s.depth, 60U);
  EXPECT_LE(s.mean_depth, static_cast<double>(s.depth));
  EXPECT_EQ(tree.back_to_front({0, 0, 5}).size(), s.fragments);
}

TEST(BspTree, TakesCoplanarTrianglesOnce) {
  const BspTree tree(Model(test::box_between({0, 0, 0}, {1, 2, 3})), {.axis_planes = false});
  EXPECT_EQ(tree.statistics().nodes, 6U);
  EXPECT_EQ(tree.statistics().splits, 0U);
}

TEST(BspTree, OfAConvexSolidIsALongChainWithoutPlanesAcrossAxesAndShortWithThem) {
  const Model ball(icosphere_mesh(1, 3));
  EXPECT_EQ(BspTree(ball, {.axis_planes = false}).statistics().depth, 1280U);
  EXPECT_LT(BspTree(ball).statistics().depth, 60U);
}

double area_of(std::span<const Vec3> polygon) {
  Vec3 sum;
  for (std::size_t i = 2; i < polygon.size(); ++i) sum += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  return 0.5 * length(sum);
}

TEST(BspTree, KeepsTheWholeSurface) {
  for (const auto& [name, mesh] : closed_meshes()) {
    if (name == "tiny" || name == "huge" || name == "denormal" || name == "far") continue;
    SCOPED_TRACE(name);
    std::vector<double> area(mesh.triangle_count());
    const BspTree tree{Model(mesh)};
    for (const BspFragment& fragment : tree.back_to_front({})) {
      ASSERT_GE(fragment.corners.size(), 3U);
      area[fragment.triangle] += area_of(fragment.corners);
    }
    for (Index t = 0; t < area.size(); ++t) {
      const std::vector<Vec3> corners{vertex_of(mesh, t, 0), vertex_of(mesh, t, 1), vertex_of(mesh, t, 2)};
      EXPECT_NEAR(area[t], area_of(corners), 1e-9);
    }
  }
}

struct Ray {
  Vec3 origin;
  Vec3 motion;
};

/// From telling points to telling points, some of which lie on the surface.
std::vector<Ray> telling_rays(const Model& model, std::size_t count) {
  const std::vector<Vec3> from = telling_points(model, count, 3), to = telling_points(model, count, 4);
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 way = to[(5 * i + i / 8) % count] - from[i];
    if (way == Vec3{} || !is_finite(way)) continue;
    rays.push_back({from[i], way});
    rays.push_back({from[i] - 4.0 * way, 8.0 * way});
  }
  return rays;
}

TEST(BspTree, CastsRaysAsTheModelDoes) {
  for (const auto& [name, mesh] : closed_meshes()) {
    SCOPED_TRACE(name);
    const Model model(mesh);
    const BspTree tree(model);
    const bool is_slow = name == "tiny" || name == "huge" || name == "denormal";  // for all is by rationals
    for (const auto& [origin, motion] : telling_rays(model, is_slow ? 16 : 400)) {
      const std::optional<RayHit> found = tree.cast_ray(origin, motion), truth = cast_ray(origin, motion, model);
      ASSERT_EQ(found.has_value(), truth.has_value());
      if (!found) continue;
      ASSERT_EQ(found->element, truth->element);
      ASSERT_EQ(found->face, truth->face);
      ASSERT_EQ(found->upper, truth->upper);
      ASSERT_EQ(found->point, truth->point);
      ASSERT_EQ(found->normal, truth->normal);
    }
  }
}

/// By every triangle.
bool meets_by_all(const Vec3& from, const Vec3& to, const Model& model) {
  const TriangleMesh& mesh = model.mesh();
  for (Index t = 0; t < mesh.triangle_count(); ++t)
    if (overlap(Triangle{{from, to, to}},
                Triangle{{vertex_of(mesh, t, 0), vertex_of(mesh, t, 1), vertex_of(mesh, t, 2)}}))
      return true;
  return locate(from, model).side == Side::inside;
}

TEST(BspTree, TellsWhetherASegmentMeetsTheSolid) {
  for (const auto& [name, mesh] : closed_meshes()) {
    SCOPED_TRACE(name);
    const Model model(mesh);
    const BspTree tree(model);
    const std::vector<Vec3> from = telling_points(model, 160, 6), to = telling_points(model, 160, 7);
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Vec3 end = to[(3 * i + i / 8) % to.size()];
      ASSERT_EQ(tree.overlap(from[i], end), meets_by_all(from[i], end, model));
      ASSERT_EQ(tree.overlap(from[i], from[i]), locate(from[i], model).side != Side::outside);
    }
  }
}

/// Where a ray from the eye passes within a polygon, clear of its border: how far along it, else less than 0.
double passes_clearly(const Vec3& eye, const Vec3& way, std::span<const Vec3> polygon) {
  double least = HUGE_VAL, greatest = -HUGE_VAL, size = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 p = polygon[i] - eye, q = polygon[(i + 1) % polygon.size()] - eye;
    const double beside = dot(cross(p, q), way);
    least = std::min(least, beside);
    greatest = std::max(greatest, beside);
    size = std::max(size, dot(p, p));
  }
  if (std::max(least, -greatest) < 1e-9 * size) return -1;
  const Vec3 normal = cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
  return dot(normal, polygon[0] - eye) / dot(normal, way);
}

// The time of entry is smaller than any double, by one axis rounded up and by another down.
TEST(BspTree, MeetsAnEdgeAtATimeThatUnderflows) {
  const double size = std::ldexp(37, -115), off = -std::ldexp(7, -166), far = std::ldexp(1, 960);
  std::vector<Vec3> corners;
  const TriangleMesh box = generated("gen:box");
  for (const Vec3& p : box.vertices())
    corners.push_back({p.x > 0 ? size : -4 * size, p.y > 0 ? -3 * size : -8 * size, p.z > 0 ? size : -size});
  const Model model(box.with_vertices(corners));
  const BspTree tree(model);
  const Vec3 origin{off, -3 * off, 0}, motion{far, -3 * far, 0};
  EXPECT_TRUE(cast_ray(origin, motion, model));
  EXPECT_TRUE(tree.cast_ray(origin, motion));
  EXPECT_TRUE(tree.overlap(origin, origin + motion));
}

TEST(BspTree, DrawsFromBackToFront) {
  Random random(8);
  std::size_t crossings = 0;
  for (const char* name :
       {"gen:torus-knot?around=120&sides=6", "gen:gear", "gen:noise-sphere?roughness=0.8", "gen:box"}) {
    SCOPED_TRACE(name);
    const BspTree tree(Model(generated(name)));
    for (int i = 0; i < 40; ++i) {
      const Vec3 eye = test::random_vector(random, i % 2 == 0 ? 3 : 0.4), way = test::random_vector(random, 1) - eye;
      double last = HUGE_VAL;
      for (const BspFragment& fragment : tree.back_to_front(eye)) {
        const double distance = passes_clearly(eye, way, fragment.corners);
        if (distance <= 1e-6) continue;
        EXPECT_LE(distance, last * (1 + 1e-9));
        last = distance;
        ++crossings;
      }
    }
  }
  EXPECT_GT(crossings, 150U);
}

TEST(BspTree, IsTheSameEachTime) {
  const Model model(generated("gen:noise-sphere"));
  const BspTree a(model), b(model);
  EXPECT_EQ(a.statistics().splits, b.statistics().splits);
  EXPECT_EQ(a.statistics().nodes, b.statistics().nodes);
  EXPECT_EQ(a.statistics().depth, b.statistics().depth);
}

std::string error_of(const TriangleMesh& mesh, const BspOptions& options = {}) {
  return test::message_of([&] { static_cast<void>(BspTree(Model(mesh), options)); });
}

TEST(BspTree, RefusesWhatIsNoSolidAndSaysWhy) {
  EXPECT_EQ(
      error_of(oracle::single_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})),
      "a BSP tree is made of a closed mesh that does not intersect itself, and this one is open: 3 edges are used "
      "unequally often in the two directions; look at that from vertex 0 to vertex 2");
  const TriangleMesh crossing =
      oracle::joined(test::box_between({0, 0, 0}, {2, 2, 2}), test::box_between({1, 1, 1}, {3, 3, 3}));
  EXPECT_NE(error_of(crossing).find("and this one does: "), std::string::npos);
  const TriangleMesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}, {2, 1, 0}});
  EXPECT_EQ(error_of(flat), "triangle 0 has no area, so there is no plane of it to make a BSP tree with");
  EXPECT_EQ(test::message_of([] { static_cast<void>(BspTree(Model(Sphere(1)))); }),
            "a BSP tree is made of a closed mesh that does not intersect itself, and the model is no mesh");
}

TEST(BspTree, GivesUpWhereItWouldGrowTooMuchAndSaysHowFarItCame) {
  const TriangleMesh knot = generated("gen:torus-knot");
  const std::string message = error_of(knot, {.max_growth = 1.5});
  EXPECT_NE(message.find("the BSP tree of 5760 triangles has come to "), std::string::npos) << message;
  EXPECT_NE(message.find("more than 1.5 times as many"), std::string::npos) << message;
  EXPECT_EQ(error_of(knot, {.max_growth = 5}), "");
}

TEST(BspTree, RefusesNumbersThatAreNotFiniteAndOptionsThatMakeNoSense) {
  const BspTree tree(Model(test::box_between({0, 0, 0}, {1, 1, 1})));
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW(static_cast<void>(tree.locate({infinite, 0, 0})), Error);
  EXPECT_THROW(static_cast<void>(tree.cast_ray({0, 0, 0}, {0, 0, 0})), Error);
  EXPECT_THROW(static_cast<void>(tree.cast_ray({0, 0, 0}, {infinite, 0, 0})), Error);
  EXPECT_THROW(static_cast<void>(tree.overlap({0, infinite, 0}, {0, 0, 0})), Error);
  EXPECT_THROW(static_cast<void>(tree.overlap({-1, 5, 5}, {0, infinite, 0})), Error);
  EXPECT_THROW(static_cast<void>(tree.overlap({0.5, 0.5, 0.5}, {0, infinite, 0})), Error);
  EXPECT_THROW(static_cast<void>(tree.overlap({1e308, 0, 0}, {-1e308, 0, 0})), Error);
  EXPECT_THROW(static_cast<void>(tree.back_to_front({0, 0, infinite})), Error);
  EXPECT_NE(error_of(test::box_between({0, 0, 0}, {1, 1, 1}), {.candidates = 0}), "");
  EXPECT_NE(error_of(test::box_between({0, 0, 0}, {1, 1, 1}), {.max_growth = 0.5}), "");
}

TEST(BspTree, OfRealMeshesLocatesAndCastsAsTheModelDoes) {
  const auto data = test::data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA";
  for (const char* name : {"fandisk", "rocker-arm", "spot"}) {
    SCOPED_TRACE(name);
    const Model model(read_mesh((*data / "meshes" / (std::string(name) + ".obj")).string()));
    const BspTree tree(model);
    for (const Vec3& p : telling_points(model, 4000, 9)) expect_located_alike(tree, model, p);
    for (const auto& [origin, motion] : telling_rays(model, 1000)) {
      const std::optional<RayHit> found = tree.cast_ray(origin, motion), truth = cast_ray(origin, motion, model);
      ASSERT_EQ(found.has_value(), truth.has_value());
      if (!found) continue;
      ASSERT_EQ(std::tuple(found->element, found->upper), std::tuple(truth->element, truth->upper));
    }
  }
}

}  // namespace
}  // namespace toccata
