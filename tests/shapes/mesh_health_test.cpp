#include "toccata/shapes/mesh_health.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "toccata/core/random.hpp"

namespace toccata {
namespace {

using Triangles = std::vector<std::array<Index, 3>>;

const std::vector<Vec3> cube_vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                         {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const Triangles cube_triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                                  {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};

/// The faults of a kind are as many as were counted, and in different places.
void expect_faults(const TriangleMesh& mesh, const MeshHealth& health) {
  std::array<std::size_t, 6> counts{};
  std::set<std::pair<MeshFaultKind, std::array<Index, 2>>> edges;
  for (const MeshFault& fault : mesh_faults(mesh)) {
    counts[static_cast<std::size_t>(fault.kind)] += fault.count();
    EXPECT_GT(fault.count(), 0U);
    for (const auto& edge : fault.edges) EXPECT_TRUE(edges.insert({fault.kind, edge}).second);
  }
  EXPECT_EQ(counts, (std::array{health.boundary_edges, health.non_manifold_edges, health.flipped_edges,
                                health.degenerate_triangles, health.duplicate_triangles, health.unused_vertices}));
}

MeshHealth health_of(const std::vector<Vec3>& vertices, const Triangles& triangles) {
  const TriangleMesh mesh(vertices, triangles);
  const MeshHealth health = inspect(mesh);
  EXPECT_EQ(is_closed(mesh), health.closed);
  EXPECT_EQ(health.closed, health.unbalanced_edges == 0);
  expect_faults(mesh, health);
  return health;
}

/// A triangle alone, and a square of which one half is there twice.
TEST(MeshFaults, WhatHangsTogetherIsOneFault) {
  const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {6, 1, 0}, {9, 9, 9}},
                          {{0, 1, 2}, {3, 4, 5}, {4, 6, 5}, {0, 0, 1}, {3, 4, 5}});
  using Edges = std::vector<std::array<Index, 2>>;
  using Numbers = std::vector<Index>;
  const std::vector<MeshFault> faults = mesh_faults(mesh);
  ASSERT_EQ(faults.size(), 7U);
  EXPECT_EQ(faults[0].edges, (Edges{{0, 2}, {0, 1}, {2, 1}}));
  EXPECT_EQ(faults[1].edges, (Edges{{5, 6}, {4, 6}}));
  EXPECT_EQ(faults[2].edges, (Edges{{5, 4}}));
  EXPECT_EQ(faults[3].edges, (Edges{{3, 5}, {3, 4}}));
  EXPECT_EQ(faults[4].triangles, Numbers{3});
  EXPECT_EQ(faults[5].triangles, Numbers{4});
  EXPECT_EQ(faults[6].vertices, Numbers{7});
  EXPECT_EQ(faults[1].kind, MeshFaultKind::boundary_edges);
  EXPECT_EQ(faults[2].kind, MeshFaultKind::non_manifold_edges);
  EXPECT_EQ(faults[3].kind, MeshFaultKind::flipped_edges);
}

TEST(MeshHealth, Cube) {
  const MeshHealth health = health_of(cube_vertices, cube_triangles);
  EXPECT_EQ(health.vertices, 8U);
  EXPECT_EQ(health.distinct_vertices, 8U);
  EXPECT_EQ(health.triangles, 12U);
  EXPECT_EQ(health.faces, 12U);
  EXPECT_EQ(health.components, 1U);
  EXPECT_EQ(health.boundary_edges + health.non_manifold_edges + health.flipped_edges, 0U);
  EXPECT_EQ(health.degenerate_triangles + health.duplicate_triangles + health.unused_vertices, 0U);
  EXPECT_TRUE(health.closed);
  EXPECT_EQ(health.signed_volume, 1);
  EXPECT_EQ(health.lower, (Vec3{0, 0, 0}));
  EXPECT_EQ(health.upper, (Vec3{1, 1, 1}));
}

TEST(MeshHealth, CubeInsideOutHasNegativeVolume) {
  Triangles triangles = cube_triangles;
  for (auto& t : triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(health_of(cube_vertices, triangles).signed_volume, -1);
}

TEST(MeshHealth, OpenCube) {
  const MeshHealth health = health_of(cube_vertices, {cube_triangles.begin() + 2, cube_triangles.end()});
  EXPECT_FALSE(health.closed);
  EXPECT_EQ(health.unbalanced_edges, 4U);
  EXPECT_EQ(health.boundary_edges, 4U);
  EXPECT_EQ(health.signed_volume, 0);
}

TEST(MeshHealth, FlippedFace) {
  Triangles triangles = cube_triangles;
  std::swap(triangles[5][0], triangles[5][1]);
  const MeshHealth health = health_of(cube_vertices, triangles);
  EXPECT_EQ(health.flipped_edges, 3U);
  EXPECT_EQ(health.unbalanced_edges, 3U);
  EXPECT_EQ(health.boundary_edges, 0U);
}

TEST(MeshHealth, DuplicatedFace) {
  Triangles triangles = cube_triangles;
  triangles.push_back({triangles[3][1], triangles[3][2], triangles[3][0]});
  const MeshHealth health = health_of(cube_vertices, triangles);
  EXPECT_EQ(health.duplicate_triangles, 1U);
  EXPECT_EQ(health.non_manifold_edges, 3U);
  EXPECT_EQ(health.unbalanced_edges, 3U);
}

TEST(MeshHealth, FaceAndItsReverseEncloseNothingButAreClosed) {
  const MeshHealth health = health_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  EXPECT_TRUE(health.closed);
  EXPECT_EQ(health.duplicate_triangles, 1U);
  EXPECT_EQ(health.flipped_edges, 0U);
  EXPECT_EQ(health.signed_volume, 0);
}

TEST(MeshHealth, VertexOnAnEdgeOpensTheMesh) {
  // The edge 0–1 of the bottom is split by a ninth vertex; the front still uses it whole.
  std::vector<Vec3> vertices = cube_vertices;
  vertices.push_back({0.5, 0, 0});
  Triangles triangles = cube_triangles;
  triangles[0] = {0, 2, 8};
  triangles.push_back({8, 2, 1});
  const MeshHealth health = health_of(vertices, triangles);
  EXPECT_FALSE(health.closed);
  EXPECT_EQ(health.boundary_edges, 3U);
}

TEST(MeshHealth, ComponentsJoinAtAVertex) {
  std::vector<Vec3> vertices = cube_vertices;
  Triangles triangles = cube_triangles;
  const auto add_cube_at = [&](double shift) {
    const Index first = static_cast<Index>(vertices.size());
    for (const Vec3& v : cube_vertices) vertices.push_back(v + Vec3{shift, shift, shift});
    for (const auto& t : cube_triangles) triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  };
  add_cube_at(5);
  EXPECT_EQ(health_of(vertices, triangles).components, 2U);
  add_cube_at(1);  // touches the first at (1, 1, 1)
  const MeshHealth health = health_of(vertices, triangles);
  EXPECT_EQ(health.components, 2U);
  EXPECT_EQ(health.vertices, 24U);
  EXPECT_EQ(health.distinct_vertices, 23U);
  EXPECT_TRUE(health.closed);
  EXPECT_EQ(health.signed_volume, 3);
}

TEST(MeshHealth, ThreeTrianglesAtOneEdge) {
  const MeshHealth health = health_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}, {9, 9, 9}},
                                      {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_EQ(health.non_manifold_edges, 1U);
  EXPECT_EQ(health.boundary_edges, 6U);
  EXPECT_EQ(health.unbalanced_edges, 7U);
  EXPECT_EQ(health.unused_vertices, 1U);
  EXPECT_EQ(health.upper, (Vec3{1, 1, 1}));  // the unused vertex does not count
}

TEST(MeshHealth, TrianglesWithoutArea) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const MeshHealth health =
      health_of({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {0, 1, 0}, {0.1, 0.1, 0.1}, {tiny, 0, 0}, {0, tiny, 0}},
                {{0, 1, 2}, {0, 0, 3}, {3, 3, 3}, {0, 4, 2}, {0, 5, 6}, {0, 1, 3}});
  // 0.1 (1, 1, 1) lies on the line exactly; the tiny one has area, though no double could tell how much.
  EXPECT_EQ(health.degenerate_triangles, 4U);
}

TEST(MeshHealth, MinusZeroIsZeroAndSoupIsWelded) {
  std::vector<Vec3> vertices;
  Triangles triangles;
  for (const auto& t : cube_triangles) {
    const Index first = static_cast<Index>(vertices.size());
    for (const Index v : t) {
      Vec3 p = cube_vertices[v];
      if (first % 2 == 1)
        for (int axis = 0; axis < 3; ++axis) p[axis] = p[axis] == 0 ? -0.0 : p[axis];
      vertices.push_back(p);
    }
    triangles.push_back({first, first + 1, first + 2});
  }
  const MeshHealth health = health_of(vertices, triangles);
  EXPECT_EQ(health.vertices, 36U);
  EXPECT_EQ(health.distinct_vertices, 8U);
  EXPECT_TRUE(health.closed);
}

/// The quick way to tell whether a mesh is closed says what counting all edges says, of surfaces that hang together
/// through vertices of their own, through equal ones, or not at all.
TEST(MeshHealth, ClosedIsToldAsByCounting) {
  Random random(11);
  std::size_t closed = 0;
  for (int round = 0; round < 4000; ++round) {
    std::vector<Vec3> vertices = cube_vertices;
    Triangles triangles = cube_triangles;
    const auto number = [&](std::size_t count) {
      return static_cast<Index>(std::floor(random.between(0, static_cast<double>(count))));
    };
    for (Index changes = number(4); changes > 0; --changes) {
      auto& triangle = triangles[number(triangles.size())];
      Index& corner = triangle[number(3)];
      switch (number(6)) {
        case 0:  // an equal vertex
        case 1: {
          Vec3 twin = vertices[corner];
          if (twin.x == 0) twin.x = -0.0;
          vertices.push_back(twin);
          corner = static_cast<Index>(vertices.size() - 1);
          break;
        }
        case 2:  // without area, there and back
          triangles.push_back({corner, corner, triangle[number(3)]});
          break;
        case 3:  // its reverse, and it again
          triangles.push_back({triangle[0], triangle[2], triangle[1]});
          triangles.push_back({triangles.back()[0], triangles.back()[2], triangles.back()[1]});
          break;
        case 4:
          corner = number(vertices.size());
          break;
        default:
          triangles.push_back({triangle[1], triangle[0], triangle[2]});
      }
    }
    closed += health_of(vertices, triangles).closed ? 1 : 0;  // compares
  }
  EXPECT_GT(closed, 800U);
  EXPECT_LT(closed, 3600U);
}

TEST(MeshHealth, VolumeFarAwayTinyAndHuge) {
  const auto volume = [](double scale, double shift) {
    std::vector<Vec3> vertices = cube_vertices;
    for (Vec3& v : vertices) v = scale * (v + Vec3{shift, shift, shift});
    return inspect(TriangleMesh(vertices, cube_triangles)).signed_volume;
  };
  EXPECT_EQ(volume(1, 0x1p40), 1);
  EXPECT_EQ(volume(0x1p-300, 0), 0x1p-900);
  EXPECT_EQ(volume(0x1p1000, 0), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace toccata
