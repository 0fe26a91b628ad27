// What two solids have in common as a closed mesh: closed, of the volume that is proved, and holding the points that
// both hold.
#include "query/volume/overlap_bodies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "support/data.hpp"
#include "support/voxel_solids.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/shapes/shape.hpp"

namespace toccata::test {
namespace {

double mesh_volume(const TriangleMesh& mesh) {
  const Vec3 origin = mesh.vertices()[0];
  double six = 0;
  for (const auto& [i, j, k] : mesh.triangles())
    six += dot(mesh.vertices()[i] - origin, cross(mesh.vertices()[j] - origin, mesh.vertices()[k] - origin));
  return six / 6;
}

void expect_edges_balance(const TriangleMesh& mesh) {
  std::vector<std::array<Index, 2>> there, back;
  for (const auto& t : mesh.triangles())
    for (std::size_t i = 0; i < 3; ++i) {
      there.push_back({t[i], t[(i + 1) % 3]});
      back.push_back({t[(i + 1) % 3], t[i]});
      EXPECT_NE(t[i], t[(i + 1) % 3]);
    }
  std::sort(there.begin(), there.end());
  std::sort(back.begin(), back.end());
  EXPECT_EQ(there, back);
}

/// How often the surface winds about the point, by solid angles (A. van Oosterom, J. Strackee, 1983): not a whole
/// number where the point is too near to tell.
double winding_by_angles(const TriangleMesh& mesh, const Pose& pose, const Vec3& point) {
  double sum = 0;
  for (const auto& t : mesh.triangles()) {
    std::array<Vec3, 3> r{};
    std::array<double, 3> size{};
    for (std::size_t i = 0; i < 3; ++i) {
      r[i] = transform(pose, mesh.vertices()[t[i]]) - point;
      size[i] = std::sqrt(dot(r[i], r[i]));
    }
    sum += std::atan2(dot(r[0], cross(r[1], r[2])), size[0] * size[1] * size[2] + dot(r[0], r[1]) * size[2] +
                                                        dot(r[1], r[2]) * size[0] + dot(r[2], r[0]) * size[1]);
  }
  return sum / (2 * std::numbers::pi);
}

/// Points about the body are in it where they are in both, and else not.
void expect_holds_what_both_hold(const TriangleMesh& a, const TriangleMesh& b, const PairQuery& query,
                                 const TriangleMesh& body, std::size_t points) {
  Vec3 lower = body.vertices()[0], upper = lower;
  for (const Vec3& p : body.vertices())
    for (int axis = 0; axis < 3; ++axis) {
      lower[axis] = std::min(lower[axis], p[axis]);
      upper[axis] = std::max(upper[axis], p[axis]);
    }
  Random random(7);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < points; ++i) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = lower[axis] + random.between(-0.05, 1.05) * (upper[axis] - lower[axis]);
    const double in_a = winding_by_angles(a, query.pose_a, p), in_b = winding_by_angles(b, query.pose_b, p);
    const double in_body = winding_by_angles(body, {}, p);
    if (std::abs(in_a - std::round(in_a)) > 1e-6 || std::abs(in_b - std::round(in_b)) > 1e-6) continue;
    EXPECT_NEAR(in_body, std::round(in_a) * std::round(in_b), 1e-6) << p.x << ' ' << p.y << ' ' << p.z;
    inside += in_body > 0.5 ? 1U : 0U;
  }
  EXPECT_GT(inside, 0U);
}

/// Looks at the body in every way, and returns it.
OverlapBodies expect_body(const TriangleMesh& a, const TriangleMesh& b, const PairQuery& query,
                          std::size_t points = 200) {
  Workspace workspace;
  OverlapBodies bodies = overlap_bodies(Model(a), Model(b), query, workspace);
  EXPECT_EQ(bodies.missing, "");
  EXPECT_EQ(bodies.pieces.size(), 1U);
  if (bodies.pieces.size() != 1) return bodies;
  const TriangleMesh& body = bodies.pieces[0];
  expect_edges_balance(body);
  const OverlapVolume volume = overlap_volume(Model(a), Model(b), query);
  EXPECT_EQ(volume, bodies.volume);
  EXPECT_NEAR(mesh_volume(body), volume.lower, 1e-10 * std::abs(volume.upper) + 1e-15);
  expect_holds_what_both_hold(a, b, query, body, points);
  return bodies;
}

std::size_t component_count(const TriangleMesh& mesh) { return mesh_parts(mesh).first_triangle.size(); }

TEST(OverlapBodies, BoxesHaveABoxInCommon) {
  const TriangleMesh box = box_mesh({1, 1, 1});
  // Most faces lie in one plane with others, edges meet, and corners lie on faces.
  for (const Vec3& by : {Vec3{0.5, 0.25, 1.5}, Vec3{1.75, 0, 0}, Vec3{0, 0, 0}, Vec3{1, 1, 0}, Vec3{-0.5, 0, 0.125}}) {
    const OverlapBodies bodies = expect_body(box, box, {.pose_b = Pose::translation(by)});
    ASSERT_EQ(bodies.pieces.size(), 1U);
    for (const Vec3& p : bodies.pieces[0].vertices())
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(std::abs(p[axis]), 1);
        EXPECT_LE(std::abs(p[axis] - by[axis]), 1);
      }
  }
}

TEST(OverlapBodies, OfBoxesThatOnlyTouchThereIsNone) {
  const Model box(box_mesh({1, 1, 1}));
  Workspace workspace;
  for (const Vec3& by :
       {Vec3{2, 0, 0}, Vec3{2, 2, 0.5}, Vec3{-2, -2, -2}, Vec3{0, 0, -2}, Vec3{0, -2, 0}, Vec3{3, 0, 0}}) {
    const OverlapBodies bodies = overlap_bodies(box, box, {.pose_b = Pose::translation(by)}, workspace);
    EXPECT_TRUE(bodies.pieces.empty());
    EXPECT_EQ(bodies.missing, "it is thinner than the rounding of coordinates");
  }
}

TEST(OverlapBodies, TurnedMirroredAndInsideOutSolids) {
  const TriangleMesh box = box_mesh({1, 1, 1});
  expect_body(box, box, {.pose_b = Pose::rotation({0, 0, 1}, 45)});
  expect_body(box, box, {.pose_b = Pose::rotation({1, 2, 3}, 31) * Pose::translation(0.3, 0.2, 0.1)});
  const Pose mirrored{{{Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, {0.5, 0, 0}};
  Workspace workspace;
  for (const PairQuery& query : {PairQuery{.pose_b = mirrored}, PairQuery{.pose_a = mirrored},
                                 PairQuery{.pose_a = mirrored, .pose_b = mirrored * Pose::translation(0.25, 0.5, 0)}}) {
    const OverlapBodies bodies = overlap_bodies(Model(box), Model(box), query, workspace);
    ASSERT_EQ(bodies.pieces.size(), 1U);
    expect_edges_balance(bodies.pieces[0]);
    EXPECT_NEAR(mesh_volume(bodies.pieces[0]), bodies.volume.lower, 1e-12);  // outwards, whichever way the solids are
  }
}

TEST(OverlapBodies, SpheresToriAndKnots) {
  const TriangleMesh ball = icosphere_mesh(1, 3);
  expect_body(ball, ball, {.pose_b = Pose::translation(0.5, 0.25, 0.125)});
  expect_body(ball, ball, {.pose_b = Pose::translation(1, 0, 0)});
  const TriangleMesh torus = torus_mesh({});
  expect_body(torus, torus, {.pose_b = Pose::rotation({1, 0, 0}, 90) * Pose::translation(0.3, 0, 0)});
  const TriangleMesh knot = torus_knot_mesh({});
  expect_body(knot, knot, {.pose_b = Pose::rotation({0, 1, 1}, 17)});
}

TEST(OverlapBodies, ARodThroughAPlateLeavesHolesInItsFaces) {
  const TriangleMesh plate = box_mesh({3, 3, 0.25});
  const OverlapBodies in = expect_body(plate, prism_mesh(0.5, 4, 17), {.pose_b = Pose::translation(0.3, 0.2, -1)});
  ASSERT_EQ(in.pieces.size(), 1U);
  EXPECT_EQ(component_count(in.pieces[0]), 1U);
  // The bore of a tube: what both hold has a hole, and so have its faces.
  const TriangleMesh torus = torus_mesh({});
  const OverlapBodies ring = expect_body(torus, plate, {});
  ASSERT_EQ(ring.pieces.size(), 1U);
  EXPECT_EQ(component_count(ring.pieces[0]), 1U);
}

TEST(OverlapBodies, SeveralRegionsAreSeveralPiecesOfOneMesh) {
  const TriangleMesh torus = torus_mesh({}), plate = box_mesh({0.2, 5, 5});
  const OverlapBodies bodies = expect_body(torus, plate, {});
  ASSERT_EQ(bodies.pieces.size(), 1U);
  EXPECT_EQ(component_count(bodies.pieces[0]), 2U);
}

TEST(OverlapBodies, WhatLiesInsideIsTheBody) {
  const TriangleMesh outer = icosphere_mesh(2, 2), inner = torus_mesh({});
  const OverlapBodies bodies = expect_body(outer, inner, {.pose_a = Pose::rotation({1, 1, 0}, 10)});
  ASSERT_EQ(bodies.pieces.size(), 1U);
  EXPECT_EQ(bodies.pieces[0].triangle_count(), inner.triangle_count());
}

TEST(OverlapBodies, TheOrderOfTheTwoDoesNotMatter) {
  const Model torus(torus_mesh({})), ball(icosphere_mesh(1, 3));
  Workspace workspace;
  const Pose pose = Pose::translation(0.75, 0.5, 0.25);
  const OverlapBodies one = overlap_bodies(torus, ball, {.pose_b = pose}, workspace);
  const OverlapBodies other = overlap_bodies(ball, torus, {.pose_a = pose}, workspace);
  ASSERT_EQ(one.pieces.size(), 1U);
  ASSERT_EQ(other.pieces.size(), 1U);
  EXPECT_TRUE(std::ranges::equal(one.pieces[0].vertices(), other.pieces[0].vertices()));
  EXPECT_TRUE(std::ranges::equal(one.pieces[0].triangles(), other.pieces[0].triangles()));
}

TEST(OverlapBodies, OfVoxelsMostFacesOfWhichLieInOnePlane) {
  Random random(3);
  std::size_t seen = 0;
  for (int i = 0; i < 60; ++i) {
    const VoxelSolid a = random_voxels(random, 12, 3), b = random_voxels(random, 12, 3);
    const Model model_a(mesh_of(a, Skin::outer, random)), model_b(mesh_of(b, Skin::outer, random));
    const double common =
        static_cast<double>(std::count_if(a.begin(), a.end(), [&](const Voxel& voxel) { return b.contains(voxel); }));
    Workspace workspace;
    const OverlapBodies bodies = overlap_bodies(model_a, model_b, {}, workspace);
    if (common == 0) {
      EXPECT_TRUE(bodies.pieces.empty());
      continue;
    }
    if (!bodies.missing.empty()) {
      EXPECT_NE(bodies.missing.find("passes through itself"), std::string::npos) << bodies.missing;
      continue;
    }
    ASSERT_EQ(bodies.pieces.size(), 1U);
    ++seen;
    expect_edges_balance(bodies.pieces[0]);
    EXPECT_NEAR(mesh_volume(bodies.pieces[0]), common, 1e-9);
    expect_holds_what_both_hold(model_a.mesh(), model_b.mesh(), {}, bodies.pieces[0], 60);
  }
  EXPECT_GT(seen, 20U);
}

TEST(OverlapBodies, OfRoundShapesPolyhedraWithinThem) {
  Workspace workspace;
  const Model ball = Sphere{1}, rod = Cylinder(0.25, 2), plate = Box({1, 1, 0.125});
  for (const auto& [a, b, query] :
       {std::tuple(ball, ball, PairQuery{.pose_b = Pose::translation(1, 0, 0)}), std::tuple(rod, plate, PairQuery{})}) {
    const OverlapBodies bodies = overlap_bodies(a, b, query, workspace);
    ASSERT_EQ(bodies.pieces.size(), 1U) << bodies.missing;
    EXPECT_TRUE(bodies.are_within);
    expect_edges_balance(bodies.pieces[0]);
    EXPECT_NEAR(mesh_volume(bodies.pieces[0]), bodies.volume.lower, 1e-9);
    EXPECT_LT(mesh_volume(bodies.pieces[0]), bodies.volume.upper);
  }
}

TEST(OverlapBodies, WhatCannotBeToldIsLeftOutWithTheReason) {
  Workspace workspace;
  const TriangleMesh box = box_mesh({1, 1, 1});
  const auto missing = [&](const Model& a, const Model& b, const PairQuery& query = {}) {
    const OverlapBodies bodies = overlap_bodies(a, b, query, workspace);
    EXPECT_TRUE(bodies.pieces.empty());
    return bodies.missing;
  };
  EXPECT_EQ(missing(Model(box), Model(box), {.solid_b = Solid::none}), "a surface takes part, which has no inside");
  const Model below = HalfSpace({}, {0, 0, 1});
  EXPECT_EQ(missing(below, below), "what two half-spaces have in common has no end");
  // Two boxes in one mesh that pass through each other.
  std::vector<Vec3> vertices(box.vertices().begin(), box.vertices().end());
  std::vector<std::array<Index, 3>> triangles(box.triangles().begin(), box.triangles().end());
  for (const Vec3& p : box.vertices()) vertices.push_back(p + Vec3{0.5, 0.5, 0.5});
  for (const auto& [i, j, k] : box.triangles()) triangles.push_back({i + 8, j + 8, k + 8});
  EXPECT_EQ(missing(Model(TriangleMesh(vertices, triangles)), Model(box)),
            "a mesh passes through itself there, or has no inside that can be proved");
}

TEST(OverlapBodies, OfRealMeshes) {
  const auto data = data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA";
  const auto read = [&](const char* name) { return read_mesh((*data / "meshes" / name).string()); };
  const TriangleMesh spot = read("spot.obj"), arm = read("rocker-arm.obj");
  ASSERT_TRUE(Model(spot).closed());
  expect_body(spot, spot, {.pose_b = Pose::rotation({0, 1, 0}, 20)}, 20);
  ASSERT_TRUE(Model(arm).closed());
  expect_body(arm, arm, {.pose_b = Pose::rotation({1, 1, 0}, 90)}, 20);
}

TEST(OverlapBodies, AreToldToProgramsAsMeshesAlone) {
  const Model box(Box({1, 1, 1}));
  const std::vector<TriangleMesh> told = overlap_bodies(box, box, {.pose_b = Pose::translation(1.5, 0.5, 0)});
  ASSERT_EQ(told.size(), 1U);
  const OverlapVolume own = overlap_volume(Model(told[0]), box);
  EXPECT_NEAR(own.lower, 0.5 * 1.5 * 2, 1e-12);
  for (const double apart : {2.0, 5.0})
    EXPECT_TRUE(overlap_bodies(box, box, {.pose_b = Pose::translation(apart, 0, 0)}).empty());
  EXPECT_THROW((void)overlap_bodies(Model(box_mesh({1, 1, 1})), box, {.solid_a = Solid::none}), Error);
}

}  // namespace
}  // namespace toccata::test
