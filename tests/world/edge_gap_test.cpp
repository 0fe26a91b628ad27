#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "oracle/convex.hpp"
#include "toccata/core/random.hpp"
#include "world/character_mover/thing_edges.hpp"
#include "world/character_mover/thing_planes.hpp"

// What `edge_gap` tells of points and segments beside triangles is compared with the exact distance of the two.
namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

/// A point, or the segment between two, and a triangle.
struct EdgeCase {
  std::array<Vec3, 2> core;
  bool is_point = false;
  Triangle triangle{};

  [[nodiscard]] FewCorners corners() const {
    FewCorners few;
    few.add(core[0]);
    if (!is_point) few.add(core[1]);
    return few;
  }
  [[nodiscard]] std::optional<EdgeGap> told() const { return edge_gap(corners(), edges_of(triangle)); }
  [[nodiscard]] oracle::ConvexSet core_set() const {
    return is_point ? oracle::point_set(core[0]) : oracle::segment_set(core[0], core[1]);
  }
  [[nodiscard]] oracle::ConvexSet triangle_set() const {
    return oracle::triangle_set(triangle[0], triangle[1], triangle[2]);
  }
  /// What is nearer need not be told.
  [[nodiscard]] double nearest_told() const {
    return 0x1p-19 * std::max(corners().extent, edges_of(triangle).corners.extent);
  }
  /// What heights of the two may be off by.
  [[nodiscard]] double slack() const { return height_slack(corners().extent, edges_of(triangle).corners.extent); }
};

/// On a small lattice, where nearly every case is a degenerate one, or anywhere.
Vec3 random_place(Random& random, bool on_lattice) {
  const auto coordinate = [&] { return on_lattice ? static_cast<double>(random.below(4)) : random.between(-2, 2); };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

EdgeCase random_edge_case(Random& random) {
  const bool on_lattice = random.below(3) == 0;
  EdgeCase one;
  one.is_point = random.below(4) == 0;
  for (Vec3& corner : one.triangle.vertex) corner = random_place(random, on_lattice);
  for (Vec3& end : one.core) end = random_place(random, on_lattice);
  Triangle& t = one.triangle;
  switch (random.below(10)) {
    case 0:
      t.vertex[2] = t[0] + random.unit() * (t[1] - t[0]);  // a needle
      break;
    case 1:
      t.vertex[1] = t[0];
      break;
    case 2:
      one.core[1] = one.core[0];
      break;
    case 3:
      one.core[1] = one.core[0] + random.between(-2, 2) * (t[1] - t[0]);  // parallel to an edge
      break;
    case 4:
      one.core[1] = one.core[0] + (t[1] - t[0]) + 0x1p-30 * random_place(random, false);  // and nearly so
      break;
    case 5:
      one.core[0] = t[0] + random.unit() * (t[1] - t[0]);  // on one
      break;
    default:
      break;
  }
  const Vec3 far = random.below(2) == 0 ? Vec3{} : std::exp2(random.between(0, 16)) * random_place(random, false);
  const double size = std::exp2(random.between(-30, 30));
  const auto put = [&](Vec3& v) { v = size * (v + far); };
  std::for_each(t.vertex.begin(), t.vertex.end(), put);
  std::for_each(one.core.begin(), one.core.end(), put);
  return one;
}

/// The least or greatest height along a vector of the corners of a set.
Rational least_height(const oracle::ConvexSet& set, const oracle::RationalPoint& along) {
  Rational least = dot(along, set.vertices.front());
  for (const oracle::RationalPoint& corner : set.vertices) least = std::min(least, dot(along, corner));
  return least;
}

/// What is wrong with an answer; empty if nothing is.
std::string fault_of(const EdgeCase& one, const EdgeGap& gap) {
  const oracle::ConvexSet core = one.core_set(), triangle = one.triangle_set();
  const Rational square = oracle::squared_distance(core, triangle);
  const Rational told = exact(gap.distance), tolerance = exact(8 * one.slack());
  if (told * told > square) return "the distance is told to be more than it is";
  if ((told + tolerance) * (told + tolerance) < square) return "the distance is more than is told";
  const oracle::RationalPoint normal = exact(gap.normal), foot = exact(gap.foot);
  if (abs(dot(normal, normal) - Rational(1)) > exact(0x1p-50)) return "the normal is not of length 1";
  if (least_height(core, normal) + least_height(triangle, -normal) < told)
    return "the normal does not tell the distance";
  const oracle::ConvexSet point = oracle::point_set(gap.foot);
  if (oracle::squared_distance(point, triangle) > tolerance * tolerance) return "the foot is not on the triangle";
  const Rational reach = told + tolerance + tolerance;
  if (oracle::squared_distance(point, core) > reach * reach) return "the foot is not the nearest point";
  return {};
}

/// The exact square of the distance from the nearest of the edges.
Rational square_to_edges(const EdgeCase& one) {
  const oracle::ConvexSet core = one.core_set();
  const Triangle& t = one.triangle;
  return std::min({oracle::squared_distance(core, oracle::segment_set(t[0], t[1])),
                   oracle::squared_distance(core, oracle::segment_set(t[1], t[2])),
                   oracle::squared_distance(core, oracle::segment_set(t[2], t[0]))});
}

TEST(EdgeGap, IsTheExactDistanceButForRounding) {
  Random random(20);
  int told = 0, nearest_at_an_edge = 0;
  for (int i = 0; i < 600; ++i) {
    SCOPED_TRACE(i);
    const EdgeCase one = random_edge_case(random);
    const std::optional<EdgeGap> gap = one.told();
    if (gap) {
      ++told;
      EXPECT_EQ(fault_of(one, *gap), "");
    }
    const Rational square = oracle::squared_distance(one.core_set(), one.triangle_set());
    const Rational of_edges = square_to_edges(one), near = exact(one.nearest_told());
    if (square <= near * near) continue;
    if (of_edges == square) ++nearest_at_an_edge;
    // Where the nearest point is within the face, and an edge clearly farther, no edge is told.
    if (of_edges > square * exact(1 + 0x1p-20)) {
      EXPECT_FALSE(gap);
    }
  }
  EXPECT_GT(nearest_at_an_edge, 200);
  EXPECT_GT(told, nearest_at_an_edge * 9 / 10);
}

TEST(EdgeGap, OfSimplePlaces) {
  const Triangle triangle{{Vec3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  const auto of = [&](const Vec3& from, const Vec3& to) { return EdgeCase{{from, to}, from == to, triangle}.told(); };
  const auto across = of({2, -1, -3}, {2, -1, 5});  // crosses an edge at right angles
  ASSERT_TRUE(across);
  EXPECT_NEAR(across->distance, 1, 1e-12);
  EXPECT_NEAR(length(across->normal - Vec3{0, -1, 0}), 0, 1e-12);
  EXPECT_NEAR(length(across->foot - Vec3{2, 0, 0}), 0, 1e-12);
  const auto beside = of({-3, -4, 0}, {-3, -4, 0});  // a point, nearest to a corner
  ASSERT_TRUE(beside);
  EXPECT_NEAR(beside->distance, 5, 1e-12);
  EXPECT_FALSE(of({1, 1, 1}, {1, 1, 3}));   // over the face
  EXPECT_FALSE(of({1, 1, -1}, {1, 1, 1}));  // through it
  EXPECT_FALSE(of({2, 0, -1}, {2, 0, 1}));  // through an edge
  EXPECT_FALSE(of({2, 0, 0}, {2, -3, 0}));  // begins on one
}

/// Three of its corners are the core: only points and segments are told.
TEST(EdgeGap, OfACoreOfMoreCornersIsNotTold) {
  FewCorners core;
  for (const Vec3& corner : {Vec3{0, -1, 0}, Vec3{1, -1, 0}, Vec3{0, -1, 1}}) core.add(corner);
  EXPECT_FALSE(edge_gap(core, edges_of(Triangle{{Vec3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}})));
  EXPECT_FALSE(edge_gap(FewCorners{}, edges_of(Triangle{{Vec3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}})));
}

}  // namespace
}  // namespace toccata::test
