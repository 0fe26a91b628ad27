#include "toccata/query/overlap.hpp"

#include <gtest/gtest.h>

#include "query/meshes/posed_mesh.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "support/error_message.hpp"
#include "support/mesh_pairs.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/contacts.hpp"

namespace toccata {
namespace {

using test::message_of;

Model box(double lower, double upper) { return Model(test::box_between({lower, lower, lower}, {upper, upper, upper})); }

Model open_square() {
  return Model(TriangleMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {0, 0}));
}

void expect_message(const std::function<void()>& question, const std::vector<std::string>& parts) {
  const std::string message = message_of(question);
  for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
}

TEST(Overlap, BoxesApartTouchingAndOverlapping) {
  const Model unit = box(0, 1);
  EXPECT_FALSE(overlap(unit, unit, {.pose_b = Pose::translation(1.0000001, 0, 0)}));
  EXPECT_TRUE(overlap(unit, unit, {.pose_b = Pose::translation(1, 0, 0)}));
  EXPECT_TRUE(overlap(unit, unit, {.pose_b = Pose::translation(1, 1, 1)})) << "in one corner";
  EXPECT_TRUE(overlap(unit, unit, {.pose_b = Pose::translation(0.5, 0.5, 0.5)}));
  EXPECT_TRUE(overlap(unit, unit));
}

TEST(Overlap, OneUnitInTheLastPlaceApartFarFromTheOrigin) {
  const Model unit = box(0, 1);
  const double far = 0x1p20;
  const double next = std::nextafter(far + 1, 2 * far);
  EXPECT_TRUE(
      overlap(unit, unit, {.pose_a = Pose::translation(far, 0, 0), .pose_b = Pose::translation(far + 1, 0, 0)}));
  EXPECT_FALSE(overlap(unit, unit, {.pose_a = Pose::translation(far, 0, 0), .pose_b = Pose::translation(next, 0, 0)}));
}

TEST(Overlap, AModelInsideASolidCountsAndInsideASurfaceDoesNot) {
  const Model inner = box(0.4, 0.6), outer = box(0, 1);
  EXPECT_TRUE(overlap(inner, outer));
  EXPECT_TRUE(overlap(outer, inner));
  EXPECT_FALSE(overlap(inner, outer, {.solid_b = Solid::none}));
  EXPECT_TRUE(overlap(inner, outer, {.solid_a = Solid::none})) << "a surface inside a solid";
  EXPECT_FALSE(overlap(inner, outer, {.solid_a = Solid::none, .solid_b = Solid::none}));
  EXPECT_TRUE(contacts(inner, outer).empty());
  EXPECT_FALSE(first_contact(inner, outer).has_value());
}

TEST(Overlap, AnOpenMeshIsNoSolid) {
  const Model square = open_square(), unit = box(0, 1);
  EXPECT_TRUE(overlap(square, unit));
  expect_message([&] { (void)overlap(square, unit, {.solid_a = Solid::all}); },
                 {"model a", "open", "4 edges", "surface"});
  expect_message([&] { (void)overlap(unit, square, {.solid_b = Solid::all}); }, {"model b", "open"});
}

TEST(Overlap, ASingularPoseIsForSurfacesOnly) {
  const Model unit = box(0, 1);
  Pose flat;
  flat.linear[2] = {};
  expect_message([&] { (void)overlap(unit, unit, {.pose_b = flat}); }, {"model b", "singular", "surface"});
  EXPECT_TRUE(overlap(unit, unit, {.pose_b = flat, .solid_b = Solid::none}));
  flat.offset.z = 2;
  EXPECT_FALSE(overlap(unit, unit, {.pose_b = flat, .solid_b = Solid::none}));
}

TEST(Overlap, PosesAndWorldVerticesMustBeFinite) {
  const Model unit = box(0, 1), large = box(0, 1e200);
  const double infinity = std::numeric_limits<double>::infinity();
  expect_message([&] { (void)overlap(unit, unit, {.pose_a = Pose::translation(0, infinity, 0)}); },
                 {"model a", "pose", "not finite"});
  Pose enlarging;
  enlarging.linear[0].x = 1e200;
  expect_message([&] { (void)contacts(unit, large, {.pose_b = enlarging}); }, {"model b", "vertex 1 ", "1e+200"});
  EXPECT_FALSE(overlap(unit, large, {.pose_b = Pose::translation(2, 0, 0)}));
}

TEST(Contacts, AreAscendingAndNameFaces) {
  const Model square = open_square(), unit = box(-0.5, 0.5);
  const auto found = contacts(square, unit);
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(test::same(found, test::contacts_by_brute_force(square, unit, {})));
  for (const Contact& contact : found) EXPECT_EQ(contact.face_a, 0U) << "both triangles are of face 0";
  EXPECT_EQ(first_contact(square, unit)->element_b, found.front().element_b);
}

TEST(Contacts, HugeAndTinyCoordinatesInOneQuestion) {
  const Model tiny(TriangleMesh({{0, 0, 0}, {5e-324, 0, 0}, {0, 5e-324, 0}}, {{0, 1, 2}}));
  const Model huge(TriangleMesh({{-1e308, 0, 0}, {1e308, 1e308, 0}, {1e308, -1e308, 0}}, {{0, 1, 2}}));
  EXPECT_EQ(contacts(tiny, huge).size(), 1U);
  EXPECT_TRUE(contacts(tiny, huge, {.pose_b = Pose::translation(0, 0, 5e-324)}).empty());
}

TEST(Queries, ManyThreadsMayShareOneModel) {
  Random random(11);
  const Model a(test::random_soup(random, 120, 0.2, 0)), b(test::random_soup(random, 120, 0.2, 0));
  std::vector<PairQuery> queries;
  for (int i = 0; i < 64; ++i) queries.push_back(test::random_poses("rigid", random));
  std::vector<std::vector<Contact>> found(queries.size());
  parallel_for(queries.size(), 8, [&](std::size_t i) { found[i] = contacts(a, b, queries[i]); });
  for (std::size_t i = 0; i < queries.size(); ++i) EXPECT_TRUE(test::same(found[i], contacts(a, b, queries[i])));
}

TEST(PosedMesh, BoxLeavesOutUnusedVertices) {
  const Model model(TriangleMesh({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {-7, 0, 0}, {0, 1, 0}, {8, 8, 8}}, {{1, 2, 4}}));
  const PosedMesh posed(model, Pose::translation(1, 2, 3));
  EXPECT_TRUE(contains(posed.box(), {{1, 2, 3}, {2, 3, 3}}));
  EXPECT_TRUE(contains({{0.999, 1.999, 2.999}, {2.001, 3.001, 3.001}}, posed.box()));
}

// Two rods side by side, askew in the world, so that the boxes around them meet there.
TEST(Overlap, PairsThatTheirTurnedBoxesTellApartAreNotWalked) {
  const Model rod(box_mesh({4, 0.1, 0.1}));
  const Mat3 askew = rotation_about({0, 0, 1}, 45);
  const auto query_at = [&](double apart) {
    return PairQuery{.pose_a = {askew, {}}, .pose_b = {askew, apart * askew.column(1)}};
  };
  Workspace workspace;
  EXPECT_FALSE(overlap(rod, rod, query_at(1), workspace));
  EXPECT_EQ(workspace.counts().volume_tests, 1U);
  EXPECT_TRUE(contacts(rod, rod, query_at(1), workspace).empty());
  EXPECT_EQ(workspace.counts().volume_tests, 1U);
  EXPECT_TRUE(overlap(rod, rod, query_at(0.15), workspace));
  EXPECT_GT(workspace.counts().volume_tests, 1U);
}

}  // namespace
}  // namespace toccata
