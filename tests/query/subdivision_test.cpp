// Meshes in place of limit surfaces, and questions about limit surfaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "query/subdivision/level_mesh.hpp"
#include "query/subdivision/refinement_rules.hpp"
#include "query/subdivision_cages.hpp"
#include "support/error_message.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/nearest.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::test {
namespace {

/// Where a vertex without sharp edges comes to lie at last: the eigenvectors of the rules (M. Halstead, M. Kass,
/// T. DeRose, "Efficient, fair interpolation using Catmull-Clark surfaces", 1993; C. T. Loop, 1987).
Vec3 limit_of(const LevelMesh& mesh, Index vertex) {
  Spokes spokes;
  spokes.gather(mesh, vertex);
  const double n = spokes.count();
  Vec3 ends{}, diagonals{};
  for (const Index end : spokes.ends) ends += mesh.points[end];
  if (mesh.scheme == SubdivisionScheme::loop) {
    const double share = 1 / (3 / (8 * loop_weight(spokes.count())) + n);
    return (1 - n * share) * mesh.points[vertex] + share * ends;
  }
  for (const Index side : mesh.sides_at(vertex)) diagonals += mesh.points[mesh.end_of(mesh.next(side))];
  return (n * n * mesh.points[vertex] + 4 * ends + diagonals) / (n * (n + 5));
}

std::vector<Vec3> limit_points(const SubdivisionCage& cage, int levels) {
  LevelMesh mesh = first_level(cage);
  while (mesh.level < levels) mesh = subdivided(mesh, std::vector<char>(mesh.face_count(), 1));
  std::vector<Vec3> points;
  for (Index v = 0; v < mesh.points.size(); ++v) points.push_back(limit_of(mesh, v));
  return points;
}

/// The greatest distance of limit points from the mesh, each held against the bound.
double expect_limit_near(const SubdivisionCage& cage, const SubdividedMesh& refined, int levels) {
  const Model mesh(refined.mesh);
  double farthest = 0;
  for (const Vec3& p : limit_points(cage, levels)) {
    const std::optional<SurfacePoint> nearest = nearest_point(p, mesh);
    EXPECT_LE(nearest->lower, refined.distance_to_limit);
    farthest = std::max(farthest, nearest->lower);
  }
  return farthest;
}

bool is_closed_case(const CageCase& c) { return SubdivisionCage(c.polygons, c.scheme).closed(); }

TEST(Refine, LimitPointsAreAsNearAsItSays) {
  Random random(3);
  for (const CageCase& c : cage_cases(random)) {
    if (!is_closed_case(c)) continue;
    const SubdivisionCage cage(c.polygons, c.scheme);
    for (int levels = 1; levels < 3; ++levels) expect_limit_near(cage, refine(cage, {.levels = levels}), 3);
  }
}

TEST(Refine, ReachesATolerance) {
  Random random(4);
  for (const CageCase& c : cage_cases(random)) {
    const CageFeatures features = random_features(c.polygons, true, random);
    const SubdivisionCage cage(c.polygons, c.scheme, features);
    const SubdividedMesh refined = refine(cage, {.tolerance = 0.1});
    EXPECT_EQ(refined.status, Status::exact);
    EXPECT_LE(refined.distance_to_limit, 0.1);
    EXPECT_EQ(refined.triangle_distances.size(), refined.mesh.triangle_count());
    EXPECT_EQ(refined.mesh.face_count(), c.polygons.first.size() - 1);
    EXPECT_EQ(Model(refined.mesh).closed(), cage.closed());
  }
}

TEST(Refine, IsFinerOnlyWhereItMustBeAndHasNoCracks) {
  const SubdivisionCage cage(cube_cage(), SubdivisionScheme::catmull_clark);
  const SubdividedMesh refined = refine(cage, {.tolerance = 0.01});
  EXPECT_EQ(refined.status, Status::exact);
  EXPECT_LE(refined.distance_to_limit, 0.01);
  EXPECT_TRUE(Model(refined.mesh).closed());
  // Eight extraordinary vertices are refined often; to do so everywhere would take 12 · 4^level triangles.
  EXPECT_GT(refined.deepest_level, 5);
  EXPECT_LT(refined.mesh.triangle_count(), 12U << (2 * refined.deepest_level - 3));
  const double farthest = expect_limit_near(cage, refined, 4);
  EXPECT_GT(farthest, 0.01 / 8);
}

TEST(Refine, OfRegularQuadranglesIsAsNearAsTheSplineAllows) {
  const Index around = 12, across = 8;
  const PolygonMesh torus = torus_cage(around, across, false);
  const SubdivisionCage cage(torus, SubdivisionScheme::catmull_clark);
  const SubdividedMesh refined = refine(cage, {.levels = 2});
  const Model mesh(refined.mesh);
  // The limit of a regular cage is its uniform bicubic B-spline.
  const auto basis = [](double t) {
    return std::array{(1 - t) * (1 - t) * (1 - t) / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
                      (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6, t * t * t / 6};
  };
  double farthest = 0;
  Random random(5);
  for (int sample = 0; sample < 300; ++sample) {
    const auto bu = basis(random.unit()), bv = basis(random.unit());
    const auto i = static_cast<Index>(random.below(around)), j = static_cast<Index>(random.below(across));
    Vec3 p{};
    for (Index k = 0; k < 4; ++k)
      for (Index l = 0; l < 4; ++l) p += bu[k] * bv[l] * torus.vertices[((i + k) % around) * across + (j + l) % across];
    const double off = nearest_point(p, mesh)->lower;
    EXPECT_LE(off, refined.distance_to_limit);
    farthest = std::max(farthest, off);
  }
  EXPECT_GT(farthest, refined.distance_to_limit / 4);
}

TEST(Refine, EndsBeforeTheMeshGrowsTooLarge) {
  const SubdivisionCage cage(cube_cage(), SubdivisionScheme::catmull_clark);
  const SubdividedMesh refined = refine(cage, {.tolerance = 1e-9, .max_triangles = 1000});
  EXPECT_EQ(refined.status, Status::not_converged);
  EXPECT_LE(refined.mesh.triangle_count(), 2000U);
  EXPECT_GT(refined.distance_to_limit, 1e-9);
  expect_limit_near(cage, refined, 4);
}

TEST(Refine, ACreaseAllAroundMakesAPlaneEndInACircleOfSplines) {
  // The corners of the limit of a flat square with smooth borders are those of the border's B-spline: (a + 4 v + b) /
  // 6.
  const SubdivisionCage square(sheet_cage(1, false), SubdivisionScheme::catmull_clark);
  const SubdividedMesh refined = refine(square, {.tolerance = 0.01});
  const Vec3 corner = (Vec3{1, 0, 0} + Vec3{0, 1, 0}) / 6;
  EXPECT_LE(nearest_point(corner, Model(refined.mesh))->upper, refined.distance_to_limit);
  EXPECT_GT(nearest_point(Vec3{0, 0, 0}, Model(refined.mesh))->lower, 0.2);
  // Sharp corners stay.
  const SubdivisionCage sharp(sheet_cage(1, false), SubdivisionScheme::catmull_clark,
                              {.border = CageBorder::sharp_corner});
  EXPECT_EQ(nearest_point(Vec3{0, 0, 0}, Model(refine(sharp, {.levels = 2}).mesh))->upper, 0);
  EXPECT_LT(refine(sharp, {.levels = 2}).distance_to_limit, 1e-12);
}

TEST(Refine, ACubeOfSharpEdgesStaysOne) {
  CageFeatures features;
  const PolygonMesh cube = cube_cage();
  for (std::size_t i = 0; i < cube.corners.size(); ++i) {
    const std::size_t face = i / 4;
    features.creases.push_back({cube.corners[i], cube.corners[4 * face + (i + 1) % 4]});
  }
  const SubdividedMesh refined = refine({cube, SubdivisionScheme::catmull_clark, features});
  EXPECT_LT(refined.distance_to_limit, 1e-12);
  EXPECT_EQ(distance(Model(refined.mesh), Box({1, 1, 1})).upper, 0);
  EXPECT_LE(nearest_point(Vec3{1, 1, 1}, Model(refined.mesh))->upper, 0);
}

TEST(LimitDistance, AgreesWithAFineMesh) {
  const SubdivisionCage cage(cube_cage(), SubdivisionScheme::catmull_clark);
  const SubdividedMesh fine = refine(cage, {.tolerance = 0.01});
  Random random(6);
  for (int i = 0; i < 6; ++i) {
    const Pose pose = Pose::translation(random.between(1.5, 3), random.between(-2, 2), random.between(-2, 2)) *
                      Pose::rotation({1, 2, 3}, random.between(0, 360));
    const Model box = Box({0.5, 0.3, 0.2});
    const LimitDistance found = distance(cage, box, {.pair = {.pose_b = pose}, .tolerance = 1e-5});
    const Distance mesh = distance(Model(fine.mesh), box, {.pose_b = pose, .solid_a = Solid::none});
    EXPECT_EQ(found.status, Status::exact);
    EXPECT_LE(found.upper - found.lower, 1e-5);
    EXPECT_LE(found.lower, mesh.upper + fine.distance_to_limit);
    EXPECT_GE(found.upper, mesh.lower - fine.distance_to_limit);
  }
}

TEST(LimitDistance, OfTheTopOfACubeIsThatOfItsLimitPoint) {
  // By symmetry the middle of a face of the cube's limit is its highest point: the centre of a face is, a level later,
  // a regular vertex with a known limit.
  const SubdivisionCage cage(cube_cage(), SubdivisionScheme::catmull_clark);
  double top = 0;
  for (const Vec3& p : limit_points(cage, 1)) top = std::max(top, p.z);
  const LimitDistance found = distance(cage, HalfSpace({0, 0, 3}, {0, 0, -1}), {.tolerance = 1e-7});
  EXPECT_LE(found.lower, 3 - top + 1e-12);
  EXPECT_GE(found.upper, 3 - top - 1e-12);
  EXPECT_LE(found.upper - found.lower, 1e-7);
}

TEST(LimitDistance, OfASurfaceWithinASolidOrCrossingItIsZero) {
  const SubdivisionCage cage(cube_cage(), SubdivisionScheme::catmull_clark);
  for (const auto& [solid, at] : {std::pair<Model, double>{Sphere(9), 0}, {Box({0.5, 0.5, 0.5}), 0.8}}) {
    const LimitDistance found = distance(cage, solid, {.pair = {.pose_b = Pose::translation(at, 0, 0)}});
    EXPECT_EQ(found.upper, 0);
    EXPECT_EQ(found.lower, 0);
    EXPECT_EQ(found.status, Status::exact);
  }
}

TEST(Refine, IsExactOnlyWhereItIsAsNearAsWasAsked) {
  const SubdivisionCage cage(cube_cage(), SubdivisionScheme::catmull_clark);
  const double reached = refine(cage, {.levels = 2}).distance_to_limit;
  for (const double tolerance : {reached, reached * (1 - 1e-15)}) {
    const SubdividedMesh made = refine(cage, {.tolerance = tolerance});
    EXPECT_EQ(made.status == Status::exact, made.distance_to_limit <= tolerance);
  }
}

TEST(LimitOverlap, SaysNoYesAndUndecided) {
  const SubdivisionCage cage(cube_cage(), SubdivisionScheme::catmull_clark);
  const auto ask = [&](double height, double tolerance) {
    return overlap(cage, HalfSpace({0, 0, height}, {0, 0, -1}), {.tolerance = tolerance});
  };
  double top = 0;
  for (const Vec3& p : limit_points(cage, 1)) top = std::max(top, p.z);
  EXPECT_FALSE(ask(top + 1e-3, 1e-6).overlap);
  EXPECT_EQ(ask(top + 1e-3, 1e-6).status, Status::exact);
  EXPECT_TRUE(ask(top - 1e-2, 1e-9).overlap);
  EXPECT_EQ(ask(top - 1e-2, 1e-9).status, Status::exact);
  const LimitOverlap near = ask(top, 1e-6);
  EXPECT_TRUE(near.overlap);
  EXPECT_EQ(near.status, Status::undecided);
  EXPECT_LE(near.distance, 1e-6);
}

TEST(LimitOverlap, WhatLiesWithinAClosedCageMeetsItAsASolidOnly) {
  const SubdivisionCage cage(bipyramid_cage(6), SubdivisionScheme::loop);
  const Model inner = Sphere(0.05);
  EXPECT_TRUE(overlap(cage, inner).overlap);
  EXPECT_EQ(overlap(cage, inner).status, Status::exact);
  EXPECT_EQ(distance(cage, inner).upper, 0);
  LimitQuery surface{.pair = {.solid_a = Solid::none}};
  EXPECT_FALSE(overlap(cage, inner, surface).overlap);
  EXPECT_GT(distance(cage, inner, surface).lower, 0.05);
  EXPECT_FALSE(overlap(cage, inner, {.pair = {.pose_b = Pose::translation(0, 0, 3)}}).overlap);
  EXPECT_TRUE(overlap(cage, Sphere(9)).overlap);
  EXPECT_EQ(overlap(cage, Sphere(9)).status, Status::exact);
}

TEST(SubdivisionCage, RefusesWhatIsNoSurface) {
  const auto cage = [](std::vector<Vec3> points, const std::vector<std::vector<Index>>& faces,
                       SubdivisionScheme scheme = SubdivisionScheme::catmull_clark, CageFeatures features = {}) {
    (void)SubdivisionCage(polygons_of(std::move(points), faces), scheme, std::move(features));
  };
  const std::vector<Vec3> five{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  const std::vector<Vec3> three(five.begin(), five.begin() + 3);
  const std::vector<Vec3> four(five.begin(), five.begin() + 4);
  const auto expect = [](const auto& make, const std::string& words) {
    EXPECT_NE(message_of(make).find(words), std::string::npos) << words << ": " << message_of(make);
  };
  expect([&] { cage({{0, 0, std::nan("")}}, {{0, 0, 0}}); }, "vertex 0 of the cage");
  expect([&] { cage(three, {{0, 1}}); }, "has 2 corners");
  expect([&] { cage(four, {{0, 1, 2, 3}}, SubdivisionScheme::loop); }, "Loop's scheme is for triangles");
  expect([&] { cage(three, {{0, 1, 3}}); }, "names vertex 3");
  expect([&] { cage(three, {}); }, "at least one face");
  expect([&] { SubdivisionCage({three, {0, 1, 2}, {0, 9, 3}}, SubdivisionScheme::loop); }, "falls after face 1");
  expect(
      [&] {
        SubdivisionCage({three, {0, 1, 2}, {0, 2}}, SubdivisionScheme::loop);
      },
      "end with the number of corners");
  // Four triangles, each from both sides, around six vertices: two of them at every vertex.
  const std::vector<std::vector<Index>> doubled{{0, 1, 2}, {2, 1, 0}, {0, 3, 4}, {4, 3, 0},
                                                {1, 3, 5}, {5, 3, 1}, {2, 4, 5}, {5, 4, 2}};
  const std::vector<Vec3> six{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {2, 1, 0}};
  expect([&] { cage(six, doubled, SubdivisionScheme::loop); }, "are one triangle from two sides");
  expect([&] { cage(four, {{0, 1, 2}}); }, "vertex 3 of the cage, at (0, 0, 1), is of no face");
  expect([&] { cage(three, {{0, 1, 2, 1}}); }, "twice");
  expect([&] { cage(five, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}); }, "more than two faces");
  expect([&] { cage(four, {{0, 1, 2}, {0, 1, 3}}); }, "turn one of them round");
  expect([&] { cage(three, {{0, 1, 2}, {2, 1, 0}}, SubdivisionScheme::loop); }, "lies between two triangles");
  expect([&] { cage(three, {{0, 1, 2}}, SubdivisionScheme::loop, {.creases = {{0, 7, 1}}}); }, "no edge of the cage");
  expect([&] { cage(three, {{0, 1, 2}}, SubdivisionScheme::loop, {.creases = {{0, 1, -1}}}); }, "at least 0");
  expect([&] { cage(three, {{0, 1, 2}}, SubdivisionScheme::loop, {.corners = {{5, 1}}}); }, "names vertex 5");
  expect([&] { (void)refine({cube_cage(), SubdivisionScheme::catmull_clark}, {.tolerance = 0}); }, "tolerance");
}

/// Two cubes with one corner in common: the corner of the second is that of the first.
PolygonMesh cubes_at_a_corner() {
  PolygonMesh cubes = cube_cage();
  const std::size_t count = cubes.corners.size();
  for (std::size_t i = 0; i < count; ++i) cubes.corners.push_back(cubes.corners[i] == 0 ? 6 : cubes.corners[i] + 7);
  for (Index v = 1; v < 8; ++v) cubes.vertices.push_back(cubes.vertices[v] + Vec3{2, 2, 2});
  for (Index f = 1; f <= 6; ++f) cubes.first.push_back(24 + 4 * f);
  return cubes;
}

TEST(SubdivisionCage, WhereFacesMeetInAVertexOnlyEachGroupHasOneThatStays) {
  const CageFeatures features{.creases = {{6, 8}, {6, 7}}};
  const SubdivisionCage cage(cubes_at_a_corner(), SubdivisionScheme::catmull_clark, features);
  EXPECT_TRUE(cage.closed());
  ASSERT_EQ(cage.polygons().vertices.size(), 16U);
  EXPECT_EQ(cage.polygons().vertices[15], (Vec3{1, 1, 1}));
  EXPECT_EQ(cage.features().corners, (std::vector<CageCorner>{{6}, {15}}));
  EXPECT_EQ(cage.features().creases, (std::vector<CageCrease>{{15, 8}, {6, 7}}));
  const SubdividedMesh refined = refine(cage, {.tolerance = 0.1});
  EXPECT_TRUE(Model(refined.mesh).closed());
  EXPECT_EQ(std::count(refined.mesh.vertices().begin(), refined.mesh.vertices().end(), Vec3{1, 1, 1}), 2);
  EXPECT_EQ(cage.posed({}).polygons().corners, cage.polygons().corners);
}

TEST(SubdivisionCage, AVertexOfTwoFacesHasNoTrianglesThatLieUponEachOther) {
  const SubdividedMesh refined =
      refine({cage_with_a_vertex_of_two(), SubdivisionScheme::catmull_clark}, {.tolerance = 0.01});
  EXPECT_EQ(refined.status, Status::exact);
  std::set<std::array<Index, 3>> seen;
  for (std::array<Index, 3> triangle : refined.mesh.triangles()) {
    std::sort(triangle.begin(), triangle.end());
    EXPECT_TRUE(seen.insert(triangle).second);
  }
}

/// As a mesh in which some faces have vertices of their own.
TriangleMesh soup_of(const PolygonMesh& polygons, Index first_face, Index end_face) {
  PolygonMesh soup = polygons;
  for (Index i = polygons.first[first_face]; i < polygons.first[end_face]; ++i) {
    soup.vertices.push_back(polygons.vertices[polygons.corners[i]]);
    soup.corners[i] = static_cast<Index>(soup.vertices.size() - 1);
  }
  return triangulate(soup);
}

TEST(SubdivisionCage, OfAMeshJoinsSeamsAndNothingElse) {
  const SubdivisionScheme scheme = SubdivisionScheme::catmull_clark;
  const auto of_mesh = [&](const TriangleMesh& mesh) { return SubdivisionCage::of_mesh(mesh, scheme); };
  const PolygonMesh cube = cube_cage();
  for (Index faces = 0; faces <= 6; ++faces) {  // have vertices of their own
    const SubdivisionCage cage = of_mesh(soup_of(cube, 0, faces));
    EXPECT_TRUE(cage.closed()) << faces;
    EXPECT_EQ(cage.polygons().vertices.size(), 8U) << faces;
  }
  // Two cubes side by side share four places, and a pinched sheet of two vertices one: each part is its own.
  PolygonMesh two = cube;
  for (const Index corner : cube.corners) two.corners.push_back(corner + 8);
  for (const Vec3& v : cube.vertices) two.vertices.push_back(v + Vec3{2, 0, 0});
  for (Index f = 1; f <= 6; ++f) two.first.push_back(24 + 4 * f);
  EXPECT_TRUE(of_mesh(triangulate(two)).closed());
  EXPECT_EQ(of_mesh(triangulate(two)).polygons().vertices.size(), 16U);
  const SubdivisionCage sheet = of_mesh(soup_of(pinched_sheet(false), 1, 2));
  EXPECT_EQ(sheet.polygons().vertices.size(), 8U);
  EXPECT_TRUE(sheet.features().corners.empty());
  EXPECT_EQ(of_mesh(triangulate(pinched_sheet(false))).features().corners.size(), 2U);
}

TEST(SubdivisionCage, ErrorsNameWhatTheMeshHas) {
  const PolygonMesh fins = polygons_of({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}},
                                       {{1, 2, 3}, {2, 1, 4}, {1, 2, 5}});
  const auto of_mesh = [](const TriangleMesh& mesh, const CageFeatures& features) {
    return message_of([&] { (void)SubdivisionCage::of_mesh(mesh, SubdivisionScheme::loop, features); });
  };
  EXPECT_EQ(of_mesh(triangulate(fins), {}).find("the edge 1–2, from (0, 0, 0) to (1, 0, 0), is shared by more"), 0U)
      << of_mesh(triangulate(fins), {});
  const PolygonMesh one = polygons_of({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{1, 2, 3}});
  const auto with = [&](const CageFeatures& features) { return of_mesh(triangulate(one), features); };
  EXPECT_EQ(with({}), "");
  EXPECT_EQ(with({.creases = {{1, 2}}, .corners = {{3}}}), "");
  EXPECT_NE(with({.corners = {{0}}}).find("names vertex 0, but no face has it"), std::string::npos);
  EXPECT_NE(with({.corners = {{4}}}).find("there are 4 vertices"), std::string::npos);
  EXPECT_NE(with({.creases = {{1, 2, -1}}}).find("the edge 1–2, from (0, 0, 0)"), std::string::npos);
}

}  // namespace
}  // namespace toccata::test
