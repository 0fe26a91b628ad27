#include "toccata/shapes/close_mesh.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "support/error_message.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata {
namespace {

using Triangles = std::vector<std::array<Index, 3>>;

/// The mesh without what it shares: every triangle has three vertices of its own, each moved by at most `by`.
TriangleMesh shaken_soup(const TriangleMesh& mesh, double by, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> vertices;
  Triangles triangles;
  for (const auto& triangle : mesh.triangles()) {
    const auto first = static_cast<Index>(vertices.size());
    for (const Index corner : triangle) {
      const double third = by / 3;
      vertices.push_back(mesh.vertices()[corner] + Vec3{random.between(-third, third), random.between(-third, third),
                                                        random.between(-third, third)});
    }
    triangles.push_back({first, first + 1, first + 2});
  }
  return {std::move(vertices), std::move(triangles)};
}

/// A box whose front lower edge has a vertex in the middle on one side only, `apart` away from it.
TriangleMesh box_with_a_crack(double apart) {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}, {0.5, 0, apart}},
          {{0, 2, 3},
           {0, 3, 1},
           {4, 5, 7},
           {4, 7, 6},
           {0, 8, 4},
           {8, 1, 5},
           {8, 5, 4},
           {2, 6, 7},
           {2, 7, 3},
           {0, 4, 6},
           {0, 6, 2},
           {1, 3, 7},
           {1, 7, 5}}};
}

TEST(CloseMesh, VerticesOfASoupBecomeOneWhereTheyAreWithinTheGap) {
  const TriangleMesh sphere = generate_mesh("icosphere", {});
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const TriangleMesh soup = shaken_soup(sphere, 1e-5, seed);
    ASSERT_FALSE(is_closed(soup));
    const RepairedMesh made = close_mesh(soup, 4e-5);
    EXPECT_TRUE(made.closed);
    EXPECT_EQ(made.mesh.triangle_count(), sphere.triangle_count());
    EXPECT_EQ(made.mesh.vertices().size(), sphere.vertices().size());
    EXPECT_EQ(made.repair, (MeshRepair{3 * sphere.triangles().size() - sphere.vertices().size(), 0, 0, 0, 0}));
    EXPECT_FALSE(close_mesh(soup, 1e-9).closed) << "a gap that is too narrow";
  }
}

TEST(CloseMesh, NoVertexMovesFartherThanTheGap) {
  const TriangleMesh soup = shaken_soup(generate_mesh("icosphere", {}), 1e-2, 7);
  const double gap = 0.02;
  const RepairedMesh made = close_mesh(soup, gap);
  ASSERT_EQ(made.repair.collapsed_triangles, 0U);
  for (std::size_t t = 0; t < soup.triangles().size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_LE(length(made.mesh.vertices()[made.mesh.triangles()[t][k]] - soup.vertices()[soup.triangles()[t][k]]),
                gap);
}

TEST(CloseMesh, ACrackBesideAVertexIsFilledByAFaceOfItsOwn) {
  for (const double apart : {0.0, 1e-4}) {
    const TriangleMesh box = box_with_a_crack(apart);
    const RepairedMesh made = close_mesh(box, 2e-4);
    EXPECT_TRUE(made.closed);
    EXPECT_EQ(made.repair, (MeshRepair{0, 0, 1, 1, 0}));
    EXPECT_EQ(made.mesh.face_count(), box.face_count() + 1);
    EXPECT_EQ(made.mesh.face_of(box.triangle_count()), box.face_count());
    EXPECT_NEAR(inspect(made.mesh).signed_volume, 1, 1e-3);
  }
  EXPECT_FALSE(close_mesh(box_with_a_crack(1e-2), 1e-3).closed);
}

TEST(CloseMesh, AHoleThatIsWiderStaysAndTheRestAsItIs) {
  const TriangleMesh sphere = generate_mesh("icosphere", {});
  const TriangleMesh open(std::vector<Vec3>(sphere.vertices().begin(), sphere.vertices().end()),
                          Triangles(sphere.triangles().begin() + 1, sphere.triangles().end()));
  const RepairedMesh made = close_mesh(open, 1e-3);
  EXPECT_FALSE(made.closed);
  EXPECT_EQ(made.repair, (MeshRepair{0, 0, 0, 0, 1}));
  EXPECT_EQ(made.mesh.triangle_count(), open.triangle_count());
  EXPECT_EQ(boundary_count(open), 1U);
  EXPECT_EQ(closing_gap(open), std::nullopt);
}

TEST(CloseMesh, TheClosingGapClosesAndHalfOfItDoesNot) {
  const TriangleMesh soup = shaken_soup(generate_mesh("box", {}), 1e-4, 3);
  const std::optional<double> gap = closing_gap(soup);
  ASSERT_TRUE(gap);
  EXPECT_TRUE(close_mesh(soup, *gap).closed);
  EXPECT_FALSE(close_mesh(soup, *gap / 2).closed);
  EXPECT_GT(boundary_count(soup), 0U);
  EXPECT_EQ(closing_gap(generate_mesh("box", {})), 0.0);
  EXPECT_EQ(boundary_count(generate_mesh("box", {})), 0U);
}

TEST(CloseMesh, AClosedMeshIsNotTouchedAndAWrongGapIsAnError) {
  const TriangleMesh box = generate_mesh("box", {});
  const RepairedMesh same = close_mesh(box, 100);
  EXPECT_TRUE(same.closed);
  EXPECT_EQ(same.repair, MeshRepair{});
  EXPECT_EQ(same.mesh.triangle_count(), box.triangle_count());
  for (const double gap :
       {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_NE(test::message_of([&] { (void)close_mesh(box, gap); }).find("positive"), std::string::npos);
}

TEST(CloseMesh, WhatIsNarrowerThanTheGapAltogetherStaysAsItIs) {
  const TriangleMesh speck({{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}}, {{0, 1, 2}});
  const RepairedMesh made = close_mesh(speck, 1);
  EXPECT_FALSE(made.closed);
  EXPECT_EQ(made.mesh.triangle_count(), 1U);
}

}  // namespace
}  // namespace toccata
