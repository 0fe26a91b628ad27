#include "toccata/query/manifolds.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/convex_cases.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/manifold.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {
namespace {

double deepest_of(const Manifold& manifold) {
  double depth = manifold.points[0].depth;
  for (int i = 1; i < manifold.count; ++i) depth = std::fmax(depth, manifold.points[static_cast<std::size_t>(i)].depth);
  return depth;
}

/// A sheet over the square from −size to size, of cells that are cut either way; `height(x, y)` tells z.
template <class Height>
TriangleMesh sheet(Random& random, Index cells, double size, double shift, const Height& height) {
  std::vector<Vec3> vertices;
  for (Index j = 0; j <= cells; ++j)
    for (Index i = 0; i <= cells; ++i) {
      const bool is_inner = i > 0 && j > 0 && i < cells && j < cells;
      const double step = 2 * size / cells, by = is_inner ? shift * step : 0;
      const double x = -size + step * i + random.between(-by, by), y = -size + step * j + random.between(-by, by);
      vertices.push_back({x, y, height(x, y)});
    }
  std::vector<std::array<Index, 3>> triangles;
  for (Index j = 0; j < cells; ++j)
    for (Index i = 0; i < cells; ++i) {
      const Index a = j * (cells + 1) + i, b = a + 1, d = a + cells + 1, c = d + 1;
      const bool first = random.below(2) == 0;
      triangles.push_back(first ? std::array{a, b, c} : std::array{a, b, d});
      triangles.push_back(first ? std::array{a, c, d} : std::array{b, c, d});
    }
  return {vertices, triangles};
}

double flat(double, double) { return 0; }

/// Spheres, boxes, capsules, hulls, cylinders, cones and ellipsoids of about size 1.
Model small_body(Random& random) {
  switch (random.below(7)) {
    case 0:
      return Sphere(random.between(0.2, 0.6));
    case 1:
      return Box({random.between(0.2, 0.6), random.between(0.2, 0.6), random.between(0.2, 0.6)});
    case 2:
      return Capsule({0, 0, -0.3}, {0, 0, 0.3}, random.between(0.1, 0.4));
    case 3:
      return Cylinder(random.between(0.2, 0.5), random.between(0.2, 0.5));
    case 4:
      return Cone(random.between(0.2, 0.5), random.between(0.2, 0.5));
    case 5:
      return Ellipsoid({random.between(0.2, 0.6), random.between(0.2, 0.6), random.between(0.2, 0.6)});
    default: {
      std::vector<Vec3> points(12);
      for (Vec3& point : points) point = test::random_vector(random, 0.5);
      return ConvexHull(points);
    }
  }
}

const Model& ground() {
  static const Model model(HalfSpace({0, 0, 0}, {0, 0, 1}));
  return model;
}

/// Puts the body so deep into the half-space z <= 0.
Pose pose_at_depth(const Model& body, const Mat3& turned, double x, double y, double depth) {
  const Pose high{turned, {x, y, 5}};
  const double gap = distance(ground(), body, {.pose_b = high}).upper;
  return {turned, {x, y, 5 - gap - depth}};
}

TEST(Manifolds, OfConvexShapesAreTheirManifold) {
  const PairQuery query{.pose_b = Pose::translation(0.5, 0.25, 1.375)};
  const auto found = manifolds(Box({1, 1, 1}), Box({0.5, 0.5, 0.5}), query);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(static_cast<const Manifold&>(found[0]), manifold(Box({1, 1, 1}), Box({0.5, 0.5, 0.5}), query));
  EXPECT_TRUE(manifolds(Sphere(1), Sphere(1), {.pose_b = Pose::translation(3, 0, 0)}).empty());
  EXPECT_TRUE(manifolds(HalfSpace({0, 0, 0}, {0, 0, 1}), HalfSpace({0, 0, 0}, {1, 0, 0})).empty());
}

/// However a flat floor is cut into triangles, a body on it has one normal and its whole depth.
TEST(Manifolds, OfAFlatFloorDoNotCatchOnItsInnerEdges) {
  Random random(7);
  for (int round = 0; round < 12; ++round) {
    const Model floor(sheet(random, 1 + static_cast<Index>(random.below(8)), 3, 0.3, flat));
    for (int i = 0; i < 25; ++i) {
      const Model body = small_body(random);
      const double depth = i % 5 == 0 ? 0 : std::pow(10, random.between(-8, -1.2));
      const Mat3 turned = i % 3 == 0 ? Mat3{} : test::random_rotation(random);
      const Pose pose = pose_at_depth(body, turned, random.between(-2, 2), random.between(-2, 2), depth);
      const PairQuery query{.pose_b = pose};
      if (!overlap(floor, body, query)) continue;
      const auto found = manifolds(floor, body, query);
      ASSERT_EQ(found.size(), 1U) << "round " << round << ", body " << i << " " << name_of(body.shape());
      EXPECT_GE(found[0].normal.z, 1 - 1e-9) << "round " << round << ", body " << i << " " << name_of(body.shape());
      EXPECT_NEAR(deepest_of(found[0]), depth, 1e-9) << "round " << round << ", body " << i;
      const auto back = manifolds(body, floor, {.pose_a = pose});
      ASSERT_EQ(back.size(), 1U);
      EXPECT_LE(back[0].normal.z, -1 + 1e-9);
    }
  }
}

TEST(Manifolds, OfABoxThatRestsOnManyTrianglesHaveItsCorners) {
  Random random(3);
  for (const Index cells : {1U, 2U, 7U, 20U}) {
    const Model floor(sheet(random, cells, 3, 0.3, flat));
    const auto found =
        manifolds(floor, Box({0.75, 0.5, 0.25}), {.pose_b = Pose::translation(0.11, 0.07, 0.25 - 0.0078125)});
    ASSERT_EQ(found.size(), 1U);
    ASSERT_EQ(found[0].count, 4);
    for (const ManifoldPoint& point : found[0].points) {
      EXPECT_NEAR(std::fabs(point.position.x - 0.11), 0.75, 1e-12) << cells;
      EXPECT_NEAR(std::fabs(point.position.y - 0.07), 0.5, 1e-12) << cells;
      EXPECT_NEAR(point.depth, 0.0078125, 1e-12);
    }
  }
}

/// A ball that rolls over edges and vertices of a bumpy surface is pushed from the nearest point of the surface.
TEST(Manifolds, OfABallLeadFromTheNearestPointOfTheSurface) {
  Random random(11);
  const Model hills(
      sheet(random, 9, 3, 0.3, [](double x, double y) { return 0.4 * std::sin(3 * x) * std::cos(2 * y); }));
  const Model ball(Sphere(0.15));
  int seen = 0;
  for (int i = 0; i < 4000; ++i) {
    const Pose pose =
        Pose::translation(random.between(-2.5, 2.5), random.between(-2.5, 2.5), random.between(-0.3, 0.6));
    const Distance centre = distance(hills, Point({0, 0, 0}), {.pose_b = pose});
    if (!(centre.upper < 0.15 && centre.upper > 0.12)) continue;
    ++seen;
    const auto found = manifolds(hills, ball, {.pose_b = pose});
    ASSERT_FALSE(found.empty());
    const Vec3 way = (1 / centre.upper) * (centre.on_b - centre.on_a);
    bool is_there = false;
    for (const ModelManifold& one : found) {
      is_there =
          is_there || (dot(one.normal, way) > 1 - 1e-9 && std::fabs(deepest_of(one) - (0.15 - centre.upper)) < 1e-9);
      // Nothing pushes harder than that, nor to where the surface is.
      EXPECT_LE(deepest_of(one), 0.15 - centre.upper + 1e-9) << i;
    }
    EXPECT_TRUE(is_there) << i;
  }
  EXPECT_GT(seen, 100);
}

/// A closed mesh that is convex, met by something a little: some manifold tells a way out of the whole mesh, which
/// mostly is hardly longer than the shortest (not so where two sharp corners meet), and none leads inwards.
TEST(Manifolds, OfAConvexMeshTellAShortWayOut) {
  Random random(5);
  const Model box_mesh(generate_mesh("box"));
  const TriangleMesh& mesh = box_mesh.mesh();
  const Model hull(ConvexHull(std::vector<Vec3>(mesh.vertices().begin(), mesh.vertices().end())));
  int seen = 0, longer = 0;
  for (int i = 0; i < 1500; ++i) {
    const Model body = small_body(random);
    const Vec3 way = test::random_vector(random, 1);
    const Pose far{test::random_rotation(random), 6 / length(way) * way};
    const Distance apart = distance(hull, body, {.pose_b = far});
    const Vec3 in = (apart.upper + 0.004) / apart.upper * (apart.on_a - apart.on_b);
    PairQuery query{.pose_b = {far.linear, far.offset + in}};
    const Penetration deep = penetration(hull, body, query);
    if (!(deep.lower > 1e-6)) continue;
    ++seen;
    const auto found = manifolds(box_mesh, body, query);
    const Pose pose = query.pose_b;
    double shortest = 10;
    for (const ModelManifold& one : found) {
      EXPECT_GE(dot(one.normal, deep.direction), -1e-6) << i;
      query.pose_b.offset = pose.offset + (deepest_of(one) + 1e-7) * one.normal;
      if (!overlap(hull, body, query)) shortest = std::fmin(shortest, deepest_of(one));
    }
    EXPECT_LE(shortest, 0.5) << i << " " << name_of(body.shape());
    longer += shortest > 1.5 * deep.upper ? 1 : 0;
  }
  EXPECT_GT(seen, 500);
  EXPECT_LE(longer, seen / 20) << "of " << seen;
}

/// A mesh on a mesh, and a mesh on a half-space.
TEST(Manifolds, OfAMeshThatRestsHaveItsCorners) {
  Random random(3);
  const Model crate(test::box_between({-0.5, -0.25, -0.5}, {0.5, 0.25, 0.5}));
  const Model floor(sheet(random, 5, 3, 0.3, flat));
  const Pose pose = Pose::translation(0.2, 0.3, 0.5 - 0.0078125);
  for (const Model* under : {&floor, &ground()}) {
    const auto found = manifolds(*under, crate, {.pose_b = pose});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].normal.z, 1, 1e-12);
    ASSERT_EQ(found[0].count, 4);
    for (const ManifoldPoint& point : found[0].points) {
      EXPECT_NEAR(std::fabs(point.position.x - 0.2), 0.5, 1e-12);
      EXPECT_NEAR(std::fabs(point.position.y - 0.3), 0.25, 1e-12);
      EXPECT_NEAR(point.depth, 0.0078125, 1e-12);
    }
  }
}

/// In the corner between a floor and two walls there are three normals.
TEST(Manifolds, OfABallInACornerAreThree) {
  const Model room(TriangleMesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {4, 4, 0}, {4, 0, 4}, {0, 4, 4}},
                                {{0, 1, 4}, {0, 4, 2}, {0, 5, 1}, {0, 3, 5}, {0, 2, 6}, {0, 6, 3}}));
  const auto found = manifolds(room, Sphere(1), {.pose_b = Pose::translation(0.99, 0.98, 0.97)});
  ASSERT_EQ(found.size(), 3U);
  Vec3 sum;
  for (const ModelManifold& one : found) {
    EXPECT_EQ(one.count, 1);
    sum = sum + deepest_of(one) * one.normal;
  }
  EXPECT_NEAR(sum.x, 0.01, 1e-12);
  EXPECT_NEAR(sum.y, 0.02, 1e-12);
  EXPECT_NEAR(sum.z, 0.03, 1e-12);
}

/// A box beside a block whose top ends a little above the box's: it is pushed aside, and not up by its whole height.
TEST(Manifolds, OfABoxBesideABlockLeadAside) {
  const Model block(test::box_between({-4, -4, -4}, {0, 4, 0}));
  const auto found =
      manifolds(block, Box({0.5, 0.5, 0.5}), {.pose_b = Pose::translation(0.5 - 0.01, 0.3, -0.5 + 1e-4)});
  ASSERT_FALSE(found.empty());
  for (const ModelManifold& one : found) {
    EXPECT_LE(deepest_of(one), 0.0101);
    EXPECT_GE(one.normal.x + one.normal.z, 0.99);
  }
}

TEST(Manifolds, LeadOutwardsOfASolidThatIsInsideOutOrMirrored) {
  const TriangleMesh box = test::box_between({-1, -1, -1}, {1, 1, 1});
  std::vector<std::array<Index, 3>> turned(box.triangles().begin(), box.triangles().end());
  for (auto& triangle : turned) std::swap(triangle[1], triangle[2]);
  const Model plain(box), inside_out(TriangleMesh({box.vertices().begin(), box.vertices().end()}, turned));
  Pose mirror;
  mirror.linear[2] = {0, 0, -1};
  for (const Model* model : {&plain, &inside_out})
    for (const Pose& pose : {Pose{}, mirror}) {
      // The middle of the ball is within.
      const auto found = manifolds(*model, Sphere(0.5), {.pose_a = pose, .pose_b = Pose::translation(0.1, 0.2, 0.75)});
      ASSERT_EQ(found.size(), 1U);
      EXPECT_NEAR(found[0].normal.z, 1, 1e-12);
      EXPECT_NEAR(deepest_of(found[0]), 0.75, 1e-12);
    }
}

TEST(Manifolds, OfWhatLiesWithinASolidLeadOutOfIt) {
  Random random(1);
  const Model block(test::box_between({-2, -2, -2}, {2, 2, 2}));
  const auto found = manifolds(block, Sphere(0.25), {.pose_b = Pose::translation(0.3, -0.2, 1.5)});
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].count, 1);
  EXPECT_NEAR(found[0].normal.z, 1, 1e-6);
  EXPECT_NEAR(found[0].points[0].depth, 0.75, 0.1);
  const Model inner(sheet(random, 2, 0.5, 0, flat));
  EXPECT_TRUE(overlap(block, inner));
  EXPECT_TRUE(manifolds(block, inner).empty());
}

Model random_part(Random& random) {
  switch (random.below(6)) {
    case 0:
      return Model(test::box_between({-0.5, -0.5, -0.5}, {0.5, 0.25, 0.5}));
    case 1:
      return Model(test::random_soup(random, 6, 0.7, 8));
    case 2:
      return Model(HeightField(3, 2, 0.5, 0.5, std::array{0.0, 0.5, 0.0, 0.25, 0.0, 0.5}));
    case 3:
      return Model(Compound(
          std::array{CompoundPart{Sphere(0.5)}, CompoundPart{Box({0.25, 0.25, 0.25}), Pose::translation(1, 0, 0)}}));
    default:
      return small_body(random);
  }
}

/// Any two models have manifolds exactly where they meet, and what these tell is in order.
TEST(Manifolds, AreThereExactlyWhereModelsMeet) {
  Random random(17);
  std::size_t met = 0;
  for (int i = 0; i < 3000; ++i) {
    const Model a = random_part(random), b = random_part(random);
    const bool whole = i % 3 == 0;
    const auto place = [&] {
      const Vec3 at = test::random_vector(random, 0.8);
      const Vec3 snapped{std::round(2 * at.x) / 2, std::round(2 * at.y) / 2, std::round(2 * at.z) / 2};
      return whole ? Pose{Mat3{}, snapped} : Pose{test::random_rotation(random), at};
    };
    const PairQuery query{place(), place()};
    const auto found = manifolds(a, b, query);
    const bool meet = overlap(a, b, query);
    if (!meet) {
      EXPECT_TRUE(found.empty()) << i;
      continue;
    }
    ++met;
    EXPECT_TRUE(!found.empty() || contacts(a, b, query).empty()) << i;
    for (const ModelManifold& one : found) {
      EXPECT_NEAR(length(one.normal), 1, 1e-12) << i;
      ASSERT_TRUE(one.count >= 1 && one.count <= 4) << i;
      for (std::size_t k = 0; k < static_cast<std::size_t>(one.count); ++k) {
        EXPECT_TRUE(is_finite(one.points[k].position) && std::isfinite(one.points[k].depth)) << i;
        EXPECT_LT(one.elements_a[k], a.element_count());
        EXPECT_LT(one.elements_b[k], b.element_count());
      }
      for (const ModelManifold& other : found)
        EXPECT_TRUE(&one == &other || length(one.normal - other.normal) > 1e-7) << i;
    }
    Workspace workspace;
    static_cast<void>(distance(a, b, query, workspace));
    EXPECT_EQ(manifolds(a, b, query, workspace), found) << i;
  }
  EXPECT_GT(met, 700U);
}

TEST(Models, TellWhatTheirPartsCostAndMakeThemOnThreads) {
  const Model knot(generate_mesh("torus-knot"));
  for (const PartCost& cost : knot.part_costs()) EXPECT_FALSE(cost.is_made);
  EXPECT_EQ(knot.part_costs().size(), all_model_parts.size());
  knot.prepare(std::array{ModelPart::turned_boxes}, 2);
  for (const PartCost& cost : knot.part_costs()) EXPECT_EQ(cost.is_made, cost.part == ModelPart::turned_boxes);
  knot.prepare();
  for (const PartCost& cost : knot.part_costs()) EXPECT_TRUE(cost.is_made);
  const Model fresh(generate_mesh("torus-knot"));
  const PairQuery query{.pose_b = Pose::translation(0.7, 0.4, 0.3)};
  EXPECT_EQ(distance(knot, knot, query), distance(fresh, fresh, query));
  EXPECT_EQ(manifolds(knot, Sphere(1), query), manifolds(fresh, Sphere(1), query));
  EXPECT_TRUE(Model(Sphere(1)).part_costs().empty());
  Model(Sphere(1)).prepare();
}

}  // namespace
}  // namespace toccata
