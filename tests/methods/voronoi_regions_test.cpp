#include "toccata/methods/voronoi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "oracle/convex.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

using Kind = ConvexFeature::Kind;

oracle::ConvexSet set_of_regions(const VoronoiRegions& regions) {
  std::vector<Vec3> vertices;
  for (Index i = 0; i < regions.vertex_count(); ++i) vertices.push_back(regions.vertex(i));
  return oracle::hull_set(vertices);
}

/// By brute force: the feature that has the nearest point in its relative interior.
std::optional<ConvexFeature> feature_by_brute_force(const VoronoiRegions& regions, const Vec3& point) {
  const oracle::ConvexSet set = set_of_regions(regions);
  if (regions.dimension() == 3 && oracle::side_of(oracle::exact(point), set) < 0) return {};
  const oracle::RationalPoint on = oracle::nearest_points(oracle::point_set(point), set).on_b;
  const HullTopology& t = regions.topology();
  const auto vertex = [&](Index i) { return oracle::exact(regions.vertex(i)); };
  for (const ConvexFeature& f : regions.features()) {
    if (f.kind == Kind::vertex && on == vertex(f.index)) return f;
    if (f.kind == Kind::edge) {
      const auto from = vertex(t.origin[f.index]), along = vertex(t.target(f.index)) - from, to_it = on - from;
      const oracle::Rational share = dot(along, to_it);
      if (is_zero(cross(along, to_it)) && share > 0 && share < dot(along, along)) return f;
    }
    if (f.kind == Kind::face) {
      const Index h = t.face_start[f.index];
      const auto a = vertex(t.origin[h]), b = vertex(t.origin[h + 1]), c = vertex(t.origin[h + 2]);
      const bool is_front = oracle::orientation(a, b, c, oracle::exact(point)) >= 0;
      if (oracle::orientation(a, b, c, on) == 0 && is_front) return f;
    }
  }
  ADD_FAILURE() << "the nearest point lies on no feature";
  return {};
}

Vec3 grid_point(Random& random, int reach) {
  const std::uint64_t count = 2 * static_cast<std::uint64_t>(reach) + 1;
  const auto along = [&] { return static_cast<double>(static_cast<int>(random.below(count)) - reach); };
  const double x = along(), y = along(), z = along();
  return {x, y, z};
}

Vec3 any_point(Random& random, double reach) {
  const double x = random.between(-reach, reach), y = random.between(-reach, reach), z = random.between(-reach, reach);
  return {x, y, z};
}

std::vector<Vec3> any_points(Random& random, int count, bool on_grid) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(on_grid ? grid_point(random, 3) : any_point(random, 3));
  return points;
}

/// From a cold start, from any start, and by looking at every region: one has it, and that is the nearest feature's.
void expect_as_brute_force(const VoronoiRegions& regions, const Vec3& point, Random& random) {
  const auto truth = feature_by_brute_force(regions, point);
  EXPECT_EQ(regions.region_of(point), truth);
  const std::vector<ConvexFeature> all = regions.features();
  EXPECT_EQ(regions.region_of(point, all[random.below(all.size())]), truth);
  for (const ConvexFeature& feature : all) EXPECT_EQ(regions.contains(feature, point), feature == truth);
}

void expect_regions_as_brute_force(const VoronoiRegions& regions, Random& random, int points) {
  for (int i = 0; i < points; ++i)
    expect_as_brute_force(regions, i % 2 == 0 ? grid_point(random, 6) : any_point(random, 6), random);
}

TEST(VoronoiRegions, OfHullsAreThoseOfTheNearestFeatures) {
  Random random(1);
  for (int i = 0; i < 40; ++i) {
    const ConvexHull hull(any_points(random, 4 + i % 20, i % 3 != 0));
    expect_regions_as_brute_force(VoronoiRegions(hull), random, 6);
  }
}

TEST(VoronoiRegions, OfBoxesHaveThe26OutsideOnes) {
  Random random(2);
  const VoronoiRegions regions(Box{{1, 2, 3}, {1, 0, 0}});
  EXPECT_EQ(regions.features().size(), 26U);
  expect_regions_as_brute_force(regions, random, 60);
}

TEST(VoronoiRegions, OfFlatShapes) {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    std::vector<Vec3> points = any_points(random, 3 + i % 6, true);
    for (Vec3& p : points) p.z = p.x;  // of a plane
    expect_regions_as_brute_force(VoronoiRegions(ConvexHull(points)), random, 6);
    const std::vector<Vec3> corners = any_points(random, 3, true);
    expect_regions_as_brute_force(VoronoiRegions(Triangle{{{corners[0], corners[1], corners[2]}}}), random, 6);
    expect_regions_as_brute_force(VoronoiRegions(Segment(corners[0], corners[1])), random, 3);
    expect_regions_as_brute_force(VoronoiRegions(Point(corners[0])), random, 1);
  }
}

TEST(VoronoiRegions, FarFromTheOriginAndTiny) {
  Random random(4);
  for (const double scale : {1e-200, 1e-9, 1e9, 1e120})
    for (int i = 0; i < 4; ++i) {
      std::vector<Vec3> points = any_points(random, 8, false);
      const Vec3 away = (i % 2) * Vec3{1e6, -3e6, 2e6};
      for (Vec3& p : points) p = scale * (p + away);
      const VoronoiRegions regions{ConvexHull(points)};
      for (int k = 0; k < 4; ++k) expect_as_brute_force(regions, scale * (any_point(random, 6) + away), random);
    }
}

// The lecture asks how the planes are defined, and says that regions share them.
TEST(VoronoiRegions, EveryPlaneIsSharedByTwoRegionsOnItsTwoSides) {
  Random random(5);
  const VoronoiRegions regions{ConvexHull(any_points(random, 30, false))};
  std::multiset<std::tuple<RegionBound::Kind, Index, bool>> sides;
  for (const ConvexFeature& feature : regions.features())
    for (const RegionBound& bound : regions.bounds(feature)) sides.insert({bound.kind, bound.index, bound.ahead});
  const auto half_edges = static_cast<Index>(regions.topology().origin.size());
  for (Index h = 0; h < half_edges; ++h)
    for (const auto kind : {RegionBound::Kind::vertex_edge, RegionBound::Kind::edge_face})
      for (const bool ahead : {false, true}) EXPECT_EQ(sides.count({kind, h, ahead}), 1U);
  EXPECT_EQ(sides.size(), 4U * half_edges + regions.topology().face_count());
}

TEST(VoronoiRegions, PlanesStandAtRightAnglesToWhatTheyBound) {
  Random random(6);
  const VoronoiRegions regions{ConvexHull(any_points(random, 30, false))};
  const HullTopology& t = regions.topology();
  for (Index h = 0; h < t.origin.size(); ++h) {
    const Vec3 from = regions.vertex(t.origin[h]), along = regions.vertex(t.target(h)) - from;
    const RegionPlane end = regions.vertex_edge_plane(h), rim = regions.edge_face_plane(h);
    const Vec3 normal = regions.face_plane(t.face[h]).normal;
    for (const RegionPlane& plane : {end, rim}) {
      EXPECT_NEAR(dot(plane.normal, plane.normal), 1, 1e-14);
      EXPECT_NEAR(dot(plane.normal, from), plane.offset, 1e-14);
    }
    EXPECT_NEAR(dot(end.normal, along), std::sqrt(dot(along, along)), 1e-14);
    EXPECT_NEAR(dot(rim.normal, along), 0, 1e-12);
    EXPECT_NEAR(dot(rim.normal, normal), 0, 1e-12);
    EXPECT_GT(dot(rim.normal, regions.vertex(t.target(t.next(h))) - from), 0);
  }
}

TEST(VoronoiRegions, APointThatIsNotFiniteIsRefused) {
  EXPECT_THROW((void)VoronoiRegions(Box{{1, 1, 1}}).region_of({NAN, 0, 0}), Error);
}

}  // namespace
}  // namespace toccata
