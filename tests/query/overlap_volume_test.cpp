#include "toccata/query/overlap.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "support/error_message.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/shapes/shape.hpp"

namespace toccata::test {
namespace {

Model box_model(const Vec3& half) { return Model(box_mesh(half)); }

void expect_holds(const OverlapVolume& found, double truth, double slack = 0) {
  EXPECT_LE(found.lower, truth + slack);
  EXPECT_GE(found.upper, truth - slack);
}

void expect_narrow(const OverlapVolume& found, double share) {
  EXPECT_LE(found.upper - found.lower, share * found.upper);
}

TEST(OverlapVolume, OfShiftedBoxesIsTheProductOfTheirCommonEdges) {
  const Model box = box_model({1, 1, 1});
  for (const Vec3& by : {Vec3{0.5, 0.25, 1.5}, Vec3{1.99, 0, 0}, Vec3{0, 0, 0}, Vec3{1, 1, 0}, Vec3{-0.5, 0, 0}}) {
    const OverlapVolume found = overlap_volume(box, box, {.pose_b = Pose::translation(by)});
    expect_holds(found, (2 - std::abs(by.x)) * (2 - std::abs(by.y)) * (2 - std::abs(by.z)), 1e-15);
    expect_narrow(found, 1e-14);
    EXPECT_EQ(found.status, Status::exact);
  }
}

TEST(OverlapVolume, OfBoxesThatOnlyTouchIsNothing) {
  const Model box = box_model({1, 1, 1});
  for (const Vec3& by : {Vec3{2, 0, 0}, Vec3{2, 2, 0.5}, Vec3{-2, -2, -2}, Vec3{3, 0, 0}}) {
    const OverlapVolume found = overlap_volume(box, box, {.pose_b = Pose::translation(by)});
    EXPECT_EQ(found.lower, 0);
    EXPECT_LE(found.upper, 1e-25);
  }
}

TEST(OverlapVolume, OfWhatLiesInsideIsItsOwn) {
  const Model outer = box_model({2, 2, 2}), inner = box_model({0.5, 0.5, 0.5});
  expect_holds(overlap_volume(outer, inner), 1);
  expect_holds(overlap_volume(inner, outer), 1);
  expect_narrow(overlap_volume(inner, outer), 1e-14);
}

TEST(OverlapVolume, OfATurnedBoxHoldsThePrism) {
  const Model box = box_model({1, 1, 1});
  // A square and one turned by 45° have an octagon in common.
  const OverlapVolume found = overlap_volume(box, box, {.pose_b = Pose::rotation({0, 0, 1}, 45)});
  expect_holds(found, 2 * 8 * (std::numbers::sqrt2 - 1), 1e-14);
  expect_narrow(found, 1e-13);
}

TEST(OverlapVolume, OfAMirroredOrInsideOutMeshIsTheSame) {
  const Model box = box_model({1, 1, 1});
  const Pose mirrored{{{Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, {0.5, 0, 0}};
  expect_holds(overlap_volume(box, box, {.pose_b = mirrored}), 1.5 * 4);
}

TEST(OverlapVolume, OfSpheresIsTheLens) {
  const Model ball = Sphere{1};
  for (const double apart : {0.5, 1.0, 1.9}) {
    const double lens = std::numbers::pi * (4 + apart) * (2 - apart) * (2 - apart) / 12;
    const OverlapVolume found = overlap_volume(ball, ball, {.pose_b = Pose::translation(apart, 0, 0)});
    expect_holds(found, lens);
    expect_narrow(found, apart > 1.5 ? 0.2 : 0.02);
    EXPECT_EQ(found.status, Status::not_converged);
  }
}

TEST(OverlapVolume, OfACylinderThroughAPlateHoldsTheClosedForm) {
  const Model rod = Cylinder{0.25, 2}, plate = Box{{1, 1, 0.1}};
  const OverlapVolume found = overlap_volume(rod, plate);
  expect_holds(found, std::numbers::pi * 0.0625 * 0.2);
  expect_narrow(found, 0.001);
}

TEST(OverlapVolume, OfAConeAnEllipsoidAndACapsuleInAHalfSpaceHoldsTheClosedForms) {
  const Model ground = HalfSpace{{0, 0, 0}, {0, 0, 1}};
  const Model ellipsoid = Ellipsoid{{1, 2, 3}}, capsule = Capsule{{-1, 0, 0}, {1, 0, 0}, 0.5};
  expect_holds(overlap_volume(ground, ellipsoid), 0.5 * 4 / 3 * std::numbers::pi * 6);
  expect_narrow(overlap_volume(ground, ellipsoid), 0.01);
  const double whole = std::numbers::pi * 0.25 * 2 + 4.0 / 3 * std::numbers::pi * 0.125;
  expect_holds(overlap_volume(capsule, ground), 0.5 * whole);
  const Model cone = Cone{1, 1};
  const Pose below = Pose::translation(0, 0, -5);
  expect_holds(overlap_volume(cone, ground, {.pose_a = below}), std::numbers::pi * 2 / 3);
}

TEST(OverlapVolume, OfAMeshThatPassesThroughItselfIsABracketByCells) {
  // Two boxes in one mesh, which overlap: the union counts each place once.
  TriangleMesh left = box_mesh({1, 1, 1}, {-0.5, 0, 0}), right = box_mesh({1, 1, 1}, {0.5, 0, 0});
  std::vector<Vec3> vertices(left.vertices().begin(), left.vertices().end());
  std::vector<std::array<Index, 3>> triangles(left.triangles().begin(), left.triangles().end());
  for (const auto& t : right.triangles())
    triangles.push_back({t[0] + static_cast<Index>(vertices.size()), t[1] + static_cast<Index>(vertices.size()),
                         t[2] + static_cast<Index>(vertices.size())});
  vertices.insert(vertices.end(), right.vertices().begin(), right.vertices().end());
  const Model both(TriangleMesh(vertices, triangles)), probe = box_model({3, 0.5, 0.5});
  const OverlapVolume found = overlap_volume(both, probe);
  expect_holds(found, 3);
  expect_narrow(found, 0.2);
  EXPECT_EQ(found.status, Status::not_converged);
}

TEST(OverlapVolume, OfACompoundOfSeparatePartsIsTheirSum) {
  const Shape half = Box{{0.5, 0.5, 0.5}};
  const Model two(Compound({{half, Pose::translation(-1, 0, 0)}, {half, Pose::translation(1, 0, 0)}}));
  const Model bar = Box{{2, 0.25, 0.25}};
  const OverlapVolume found = overlap_volume(two, bar);
  expect_holds(found, 2 * 0.25);
  expect_narrow(found, 1e-9);
}

TEST(OverlapVolume, ExchangedIsTheSame) {
  const Model gear(gear_mesh({.teeth = 9})), torus(torus_mesh({.tube_radius = 0.3, .around = 24, .sides = 12}));
  const Pose p = Pose::rotation({1, 2, 3}, 40), q = Pose::translation(0.3, 0.2, 0.1);
  EXPECT_EQ(overlap_volume(gear, torus, {.pose_a = p, .pose_b = q}),
            overlap_volume(torus, gear, {.pose_a = q, .pose_b = p}));
}

TEST(OverlapVolume, BeyondDoublesIsAnIntervalWithoutAnEndThatIsNotExact) {
  const Model box = box_model({1e150, 1e150, 1e150});
  const OverlapVolume volume = overlap_volume(box, box, {.pose_b = Pose::translation(1e150, 0, 0)});
  EXPECT_EQ(volume.upper, HUGE_VAL);
  EXPECT_EQ(volume.status, Status::not_converged);
}

/// Where it lies within two surfaces of the mesh, or between them, though their triangles' boxes reach into it.
TEST(OverlapVolume, WithinNestedSurfacesIsThatOfOneSolid) {
  const auto octahedron = [](double r, bool inverted) {
    std::vector<Vec3> vertices{{r, 0, 0}, {-r, 0, 0}, {0, r, 0}, {0, -r, 0}, {0, 0, r}, {0, 0, -r}};
    std::vector<std::array<Index, 3>> faces;
    for (const Index x : {0U, 1U})
      for (const Index y : {2U, 3U})
        for (const Index z : {4U, 5U}) {
          const bool turned = ((x + y + z) % 2 != 0) != inverted;
          faces.push_back(turned ? std::array<Index, 3>{x, z, y} : std::array<Index, 3>{x, y, z});
        }
    return std::pair(vertices, faces);
  };
  auto [vertices, faces] = octahedron(100, false);
  const TriangleMesh box = box_mesh({2, 2, 2});
  const auto first = static_cast<Index>(vertices.size());
  vertices.insert(vertices.end(), box.vertices().begin(), box.vertices().end());
  for (const auto& [i, j, k] : box.triangles()) faces.push_back({first + i, first + j, first + k});
  const auto [small_vertices, small_faces] = octahedron(0.5, false);
  const Model nested(TriangleMesh(vertices, faces)), small(TriangleMesh(small_vertices, small_faces));
  const OverlapVolume found = overlap_volume(nested, small);
  expect_holds(found, 1.0 / 6, 1e-15);
  EXPECT_LE(found.lower, found.upper);
}

TEST(OverlapVolume, OfWhatIsTooSmallToBeEnclosedIsNotNothing) {
  const Model box = Box({2, 2, 2});
  const double pi = std::numbers::pi;
  for (const double thin : {1e-14, 1e-15}) {
    const OverlapVolume disc = overlap_volume(Cylinder(1, thin), box);
    EXPECT_LE(disc.lower, 2 * pi * thin);
    EXPECT_GE(disc.upper, 2 * pi * thin);
  }
  const OverlapVolume grain = overlap_volume(Sphere(1e-17, {1, 0, 0}), box);
  EXPECT_GE(grain.upper, 4 / 3.0 * pi * 1e-51);
  EXPECT_NE(grain.status, Status::exact);
}

TEST(OverlapVolume, OfSurfacesIsRefused) {
  const Model open(height_field_mesh({})), box = box_model({1, 1, 1});
  EXPECT_NE(message_of([&] { static_cast<void>(overlap_volume(open, box)); }).find("model a is taken as a surface"),
            std::string::npos);
  const Model ground = HalfSpace{{0, 0, 0}, {0, 0, 1}};
  EXPECT_NE(message_of([&] { static_cast<void>(overlap_volume(ground, ground)); }).find("has no end"),
            std::string::npos);
}

}  // namespace
}  // namespace toccata::test
