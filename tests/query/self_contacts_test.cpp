#include "toccata/query/self_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "narrow/triangles/triangle_pair_block.hpp"
#include "oracle/meshes.hpp"
#include "support/data.hpp"
#include "support/mesh_soups.hpp"
#include "support/self_meshes.hpp"
#include "support/simd_levels.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/io/model_file.hpp"

namespace toccata {
namespace {

using Pairs = std::vector<std::pair<Index, Index>>;

Pairs pairs_of(const TriangleMesh& mesh, const Pose& pose = {}) {
  const Model model(mesh);
  Pairs pairs;
  for (const Contact& contact : self_contacts(model, pose)) pairs.emplace_back(contact.element_a, contact.element_b);
  EXPECT_EQ(self_overlap(model, pose), !pairs.empty());
  return pairs;
}

/// The same whether or not the triangles share vertices by number.
Pairs pairs_either_way(const TriangleMesh& mesh) {
  Pairs welded = pairs_of(mesh);
  EXPECT_EQ(pairs_of(test::unwelded(mesh)), welded);
  return welded;
}

TEST(SelfContacts, ClosedMeshesMeetThemselvesNowhere) {
  EXPECT_EQ(pairs_either_way(icosphere_mesh(1, 2)), Pairs{});
  EXPECT_EQ(pairs_either_way(test::box_between({0, 0, 0}, {1, 2, 3})), Pairs{});
  EXPECT_EQ(pairs_either_way(torus_mesh({})), Pairs{});
}

TEST(SelfContacts, NeighboursInOnePlaneAreProper) {
  EXPECT_EQ(pairs_either_way({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}}), Pairs{});
}

TEST(SelfContacts, NeighboursFoldedOntoEachOtherMeet) {
  EXPECT_EQ(pairs_either_way({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.9, 0}}, {{0, 1, 2}, {2, 1, 3}}}), Pairs{});
  EXPECT_EQ(pairs_either_way({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.7, 0}}, {{0, 1, 2}, {2, 1, 3}}}),
            (Pairs{{0, 1}}));
}

TEST(SelfContacts, TrianglesOfOneVertexMeetOnlyElsewhere) {
  const std::vector<Vec3> points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {-1, -1, 1}, {-1, -1, -1}, {1, 1, 1}, {1, 1, -1}};
  EXPECT_EQ(pairs_either_way({points, {{0, 1, 2}, {0, 3, 4}}}), Pairs{});
  EXPECT_EQ(pairs_either_way({points, {{0, 1, 2}, {0, 5, 6}}}), (Pairs{{0, 1}}));
}

/// Two triangles over few points, so that they share corners, lie in one plane, and lack area often.
TriangleMesh likely_neighbours(Random& random) {
  const int size = random.below(2) == 0 ? 2 : 1000;
  std::vector<Vec3> points;
  for (int i = 0; i < 5; ++i) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<double>(random.below(static_cast<std::uint64_t>(size)));
    points.push_back(p);
  }
  const auto corner = [&] { return static_cast<Index>(random.below(5)); };
  return {points, {{corner(), corner(), corner()}, {corner(), corner(), corner()}}};
}

TEST(SelfContacts, NeighboursThatBlocksTellApartHaveNothingElseInCommon) {
  for (const Pose& pose : {Pose{}, Pose{Mat3{}, {0.5, -3, 1}}})
    test::at_every_simd_level([&](SimdLevel level) {
      Random random(5);
      int told = 0, proper = 0;
      for (int i = 0; i < 400; ++i) {
        const TriangleMesh mesh = likely_neighbours(random);
        TrianglePairBlock block{};
        const auto vertices = mesh.vertices();
        const auto triangle = [&](std::size_t t) -> Triangle {
          const auto& [p, q, r] = mesh.triangles()[t];
          return {{vertices[p], vertices[q], vertices[r]}};
        };
        set_pair(block, 3, triangle(0), triangle(1));
        block.count = 4;
        classify_neighbours(pose, {&block, 1});
        const bool meets = !oracle::self_intersecting_pairs(oracle::surface_set(mesh, pose)).empty();
        const bool known_apart = ((block.intersection | block.unknown) >> 3 & 1) == 0;
        EXPECT_FALSE(known_apart && meets) << name_of(level) << ", case " << i;
        EXPECT_FALSE((block.intersection >> 3 & 1) != 0 && !meets) << name_of(level) << ", case " << i;
        told += known_apart ? 1 : 0;
        proper += meets ? 0 : 1;
      }
      EXPECT_GT(told, proper / 3) << name_of(level);
    });
}

/// Two triangles that share one corner, anywhere in either, and lie on both sides of each other's planes.
TriangleMesh crossing_at_a_corner(Random& random) {
  while (true) {
    std::vector<Vec3> points{{}};
    while (points.size() < 5) points.push_back({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
    std::array<std::array<Index, 3>, 2> triangles{{{0, 1, 2}, {0, 3, 4}}};
    for (auto& triangle : triangles) {
      std::rotate(triangle.begin(), triangle.begin() + static_cast<std::ptrdiff_t>(random.below(3)), triangle.end());
      if (random.below(2) == 0) std::swap(triangle[0], triangle[1]);
    }
    const auto parted = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
      const Vec3 normal = cross(points[i] - points[0], points[j] - points[0]);
      return dot(normal, points[k] - points[0]) * dot(normal, points[l] - points[0]) < -1e-6;
    };
    if (parted(1, 2, 3, 4) && parted(3, 4, 1, 2)) return {points, {triangles[0], triangles[1]}};
  }
}

TEST(SelfContacts, BlocksTellAllThatCrossEachOthersPlanesAndHaveOneCornerInCommon) {
  test::at_every_simd_level([&](SimdLevel level) {
    Random random(6);
    int proper = 0;
    for (int i = 0; i < 200; ++i) {
      const TriangleMesh mesh = crossing_at_a_corner(random);
      TrianglePairBlock block{};
      const auto triangle = [&](std::size_t t) -> Triangle {
        const auto& [p, q, r] = mesh.triangles()[t];
        return {{mesh.vertices()[p], mesh.vertices()[q], mesh.vertices()[r]}};
      };
      set_pair(block, 0, triangle(0), triangle(1));
      block.count = 1;
      classify_neighbours({}, {&block, 1});
      const bool meets = !oracle::self_intersecting_pairs(oracle::surface_set(mesh, {})).empty();
      EXPECT_EQ((block.intersection | block.unknown) != 0, meets) << name_of(level) << ", case " << i;
      proper += meets ? 0 : 1;
    }
    EXPECT_GT(proper, 50);
    EXPECT_LT(proper, 150);
  });
}

TEST(SelfContacts, AVertexInAnEdgeIsMet) {
  // A T-junction: the middle of an edge is another triangle's vertex.
  EXPECT_EQ(
      pairs_either_way({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {1, -1, 1}, {2, -1, 1}}, {{0, 1, 2}, {3, 4, 5}}}),
      (Pairs{{0, 1}}));
}

TEST(SelfContacts, DuplicatesAreMet) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Pairs pair{{0, 1}};
  EXPECT_EQ(pairs_either_way({points, {{0, 1, 2}, {0, 1, 2}}}), pair);
  EXPECT_EQ(pairs_either_way({points, {{0, 1, 2}, {2, 1, 0}}}), pair);
  const Contact contact = self_contacts(Model({points, {{0, 1, 2}, {1, 0, 2}}})).front();
  EXPECT_EQ(contact.intersection.kind, IntersectionKind::polygon);
  EXPECT_EQ(contact.intersection.count, 3);
}

/// What docs/truth.md says of triangles without area.
TEST(SelfContacts, TrianglesWithoutArea) {
  // Points: a segment from 0 to 2 with the middle 1, and 3, 4 beside it.
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, -1, 0}};
  const Pairs none{}, pair{{0, 1}};
  EXPECT_EQ(pairs_either_way({points, {{0, 1, 2}, {0, 2, 3}}}), none) << "a cap on the edge that it fills";
  EXPECT_EQ(pairs_either_way({points, {{0, 1, 2}, {0, 4, 1}}}), none) << "and on the part of it";
  EXPECT_EQ(pairs_either_way({points, {{0, 2, 3}, {0, 4, 1}}}), pair) << "a T-junction that nothing fills";
  EXPECT_EQ(pairs_either_way({points, {{0, 2, 2}, {0, 2, 3}}}), none) << "an edge as a triangle";
  EXPECT_EQ(pairs_either_way({points, {{0, 0, 0}, {0, 2, 3}}}), none) << "a vertex as a triangle";
  EXPECT_EQ(pairs_either_way({points, {{1, 1, 1}, {0, 2, 3}}}), pair) << "a point on an edge";
  EXPECT_EQ(pairs_either_way({points, {{0, 2, 2}, {0, 0, 2}}}), pair) << "the same vertices";
  EXPECT_EQ(pairs_either_way({points, {{3, 3, 3}, {3, 3, 3}}}), pair) << "the same vertex";
  EXPECT_EQ(pairs_either_way({points, {{0, 2, 2}, {0, 1, 1}}}), pair) << "segments, one along the other";
}

TEST(SelfContacts, SegmentsThatCrossInTheirMiddles) {
  const std::vector<Vec3> points{{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}};
  EXPECT_EQ(pairs_either_way({points, {{0, 1, 2}, {3, 1, 4}}}), Pairs{}) << "both have the middle as vertex";
  EXPECT_EQ(pairs_either_way({points, {{0, 1, 2}, {3, 4, 4}}}), (Pairs{{0, 1}}));
}

TEST(SelfContacts, SharingIsToldByWorldCoordinates) {
  // The pose makes one point of the two triangles' tips, which are 1e-9 apart.
  const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e-9, 0, 0}, {-1, 0, 0}, {0, -1, 0}},
                          {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(pairs_of(mesh), (Pairs{{0, 1}}));
  EXPECT_EQ(pairs_of(mesh, Pose::translation(1e9, 1e9, 1e9)), Pairs{});
}

TEST(SelfContacts, ZeroHasOneSign) {
  EXPECT_EQ(
      pairs_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {3, 4, 5}}}),
      Pairs{});
}

/// Trap T13 of self traversal: (i, j) and (j, i), or (i, i).
TEST(SelfContacts, EachPairOnceTheLesserFirst) {
  Random random(7);
  const TriangleMesh soup = test::random_soup(random, 400, 0.3, 0);
  const Pairs pairs = pairs_of(soup);
  EXPECT_GT(pairs.size(), 500U);
  for (const auto& [first, second] : pairs) EXPECT_LT(first, second);
  for (std::size_t i = 1; i < pairs.size(); ++i) EXPECT_LT(pairs[i - 1], pairs[i]);
}

/// Trap T14: adjacency by vertex numbers fails on a soup of triangles.
TEST(SelfContacts, ASoupIsAnsweredLikeTheWeldedMesh) {
  Random random(11);
  for (int i = 0; i < 20; ++i) pairs_either_way(test::random_self_mesh("sheets", random).mesh);
  EXPECT_EQ(pairs_of(test::unwelded(icosphere_mesh(1, 3))), Pairs{});
}

TEST(SelfContacts, NothingOfNothing) {
  EXPECT_EQ(pairs_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}), Pairs{});
  EXPECT_EQ(pairs_of({{{0, 0, 0}}, {{0, 0, 0}}}), Pairs{});
}

TEST(SelfContacts, WhatIsNotFiniteIsAnError) {
  const Model model(test::box_between({0, 0, 0}, {1, 1, 1}));
  EXPECT_THROW((void)self_contacts(model, Pose::translation(std::numeric_limits<double>::quiet_NaN(), 0, 0)), Error);
  EXPECT_THROW((void)self_overlap(model, scaled(Pose::translation(1e308, 0, 0), 1.7e308)), Error);
}

/// Every so many-th of all pairs of triangles.
struct Sample {
  Index step = 1;
  [[nodiscard]] bool holds(Index i, Index j) const { return (7 * i + j) % step == 0; }
};

/// The pairs of a sample that meet, by rational arithmetic wherever their boxes overlap.
Pairs pairs_by_oracle(const TriangleMesh& mesh, const Sample& sample) {
  const oracle::MeshSet set = oracle::surface_set(mesh, {});
  const Model model(mesh);
  std::vector<Aabb> boxes;
  for (Index i = 0; i < mesh.triangle_count(); ++i) boxes.push_back(fit_aabb(world_triangle(model, {}, i).vertex));
  Pairs pairs;
  for (Index i = 0; i < boxes.size(); ++i)
    for (Index j = i + 1; j < boxes.size(); ++j)
      if (sample.holds(i, j) && overlap(boxes[i], boxes[j]) &&
          !oracle::self_intersecting_pairs({{set.triangles[i], set.triangles[j]}}).empty())
        pairs.emplace_back(i, j);
  return pairs;
}

struct RealSoup {
  const char* file;
  std::size_t pairs;  ///< of triangles in which it meets itself
  Sample sample;
};

void PrintTo(const RealSoup& soup, std::ostream* out) { *out << soup.file; }

class RealSoupAgainstItself : public testing::TestWithParam<RealSoup> {};

/// Meshes that are not manifold, or whose parts have vertices of their own at one place.
TEST_P(RealSoupAgainstItself, AsTheOracleSays) {
  const auto data = test::data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA to the folder of real models";
  const TriangleMesh mesh = read_mesh(*data / "meshes" / GetParam().file);
  const Sample sample = GetParam().sample;
  Pairs found = pairs_of(mesh);
  EXPECT_EQ(found.size(), GetParam().pairs);
  std::erase_if(found, [&](const auto& pair) { return !sample.holds(pair.first, pair.second); });
  EXPECT_EQ(found, pairs_by_oracle(mesh, sample));
  EXPECT_FALSE(found.empty());
}

INSTANTIATE_TEST_SUITE_P(Files, RealSoupAgainstItself,
                         testing::Values(RealSoup{"cow.obj", 81, {13}}, RealSoup{"env.obj", 588, {1}},
                                         RealSoup{"rob.obj", 202, {1}}, RealSoup{"suzanne.obj", 91, {1}},
                                         RealSoup{"teapot.obj", 161, {13}}));

}  // namespace
}  // namespace toccata
