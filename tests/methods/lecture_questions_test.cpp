// The questions and worked examples of the lectures that several methods share, each shown (docs/methods/questions.md
// lists them).
#include <gtest/gtest.h>

#include <algorithm>

#include "toccata/core/random.hpp"
#include "toccata/methods/sphere_ways.hpp"
#include "toccata/methods/voronoi.hpp"
#include "toccata/narrow/primitives.hpp"

namespace toccata {
namespace {

using Kind = ConvexFeature::Kind;

/// The plane of a region beyond which a point lies, the farthest, if any.
const RegionBound* plane_in_error(const std::vector<RegionBound>& bounds, const Vec3& point) {
  const RegionBound* worst = nullptr;
  double farthest = 0;
  for (const RegionBound& bound : bounds) {
    const double height = dot(bound.plane.normal, point) - bound.plane.offset;
    const double beyond = bound.ahead ? -height : height;
    if (beyond > farthest) {
      farthest = beyond;
      worst = &bound;
    }
  }
  return worst;
}

/// The region beside one, on the other side of a plane.
ConvexFeature beyond(const RegionBound& bound, const HullTopology& topology) {
  using Between = RegionBound::Kind;
  const ConvexFeature edge{Kind::edge, std::min(bound.index, topology.twin[bound.index])};
  if (bound.kind == Between::vertex_edge)
    return bound.ahead ? ConvexFeature{Kind::vertex, topology.origin[bound.index]} : edge;
  if (bound.kind == Between::edge_face)
    return bound.ahead ? edge : ConvexFeature{Kind::face, topology.face[bound.index]};
  // Behind the plane of a face: of a triangle that is its other side.
  return {Kind::face, 1 - bound.index};
}

/// The walk of the lecture, without coherence: from a feature on, through the plane that is in error.
std::vector<ConvexFeature> walk_from(const ConvexFeature& start, const Vec3& point, const VoronoiRegions& regions) {
  std::vector<ConvexFeature> way{start};
  while (way.size() < 20) {
    const std::vector<RegionBound> bounds = regions.bounds(way.back());
    const RegionBound* wrong = plane_in_error(bounds, point);
    if (wrong == nullptr) break;
    way.push_back(beyond(*wrong, regions.topology()));
  }
  return way;
}

TEST(LectureQuestion, TheWalkOverATrianglesRegionsIsLedByThePlanesInError) {
  // The triangle of the slide, and a point beyond two of its edges' planes: from the face over an edge to a vertex.
  const Triangle triangle{{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{1, 3, 0}}};
  const VoronoiRegions regions(triangle);
  const ConvexFeature front{Kind::face, regions.face_plane(0).normal.z > 0 ? 0U : 1U};
  const Vec3 point{6, -0.5, 1};
  const std::vector<ConvexFeature> way = walk_from(front, point, regions);
  ASSERT_EQ(way.size(), 3U);
  EXPECT_EQ(way[1].kind, Kind::edge);
  EXPECT_EQ(way[2].kind, Kind::vertex);
  EXPECT_EQ(regions.vertex(way[2].index), (Vec3{4, 0, 0}));
  EXPECT_EQ(way[2], *regions.region_of(point));
}

TEST(LectureQuestion, TheWalkEndsInTheRightRegionWhereverItBegins) {
  const VoronoiRegions regions(Triangle{{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{1, 3, 0}}});
  Random random(41);
  std::size_t longest = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 point{random.between(-6, 6), random.between(-6, 6), random.between(-3, 3)};
    for (const ConvexFeature& start : regions.features()) {
      const std::vector<ConvexFeature> way = walk_from(start, point, regions);
      ASSERT_LT(way.size(), 20U) << "does not end";
      EXPECT_EQ(way.back(), *regions.region_of(point));
      longest = std::max(longest, way.size());
    }
  }
  EXPECT_LE(longest, 6U);
}

/// The six bits in the box's own frame name the feature that is nearest; is the sphere as near as that?
bool overlap_by_codes(const PosedSphere& sphere, const Vec3& half, const Pose& pose) {
  const Vec3 from = sphere.centre - pose.offset;
  Vec3 local, nearest;
  for (int axis = 0; axis < 3; ++axis) local[axis] = dot(pose.linear.column(axis), from);
  const unsigned code = box_region(local, -1 * half, half);
  for (int axis = 0; axis < 3; ++axis) {
    const unsigned bits = code >> (2 * axis) & 3U;
    nearest[axis] = bits == 0 ? local[axis] : bits == 1 ? -half[axis] : half[axis];
  }
  const Vec3 way = transform(pose, nearest) - sphere.centre;
  return dot(way, way) <= sphere.radius * sphere.radius;
}

TEST(LectureQuestion, SixBitsNameTheNearestFeatureOfATurnedBoxAndNotOfASheared) {
  Random random(43);
  const Vec3 half{1, 2, 0.5};
  const Pose turned{rotation_about({1, 2, 3}, 40), {0.5, -1, 2}};
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const PosedSphere sphere({random.between(-3, 4), random.between(-4, 3), random.between(0, 4)}, 0.75);
    EXPECT_EQ(overlap_by_codes(sphere, half, turned), overlap(sphere, PosedBox(Box(half), turned)));
    hits += overlap_by_codes(sphere, half, turned);
  }
  EXPECT_GT(hits, 100);
  // The planes of a sheared box are not at right angles. Above its slanted end the code says "the top", whose nearest
  // point in its own coordinates is an edge's; the ball meets the slope.
  const Pose sheared = Pose::from_numbers({1, 3, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  int wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 local{random.between(-3, 3), random.between(-3, 3), 0};
    const Vec3 cube{1, 1, 1};
    if (box_region(local, -1 * cube, cube) == 0) continue;
    Vec3 nearest = local;
    for (int axis = 0; axis < 3; ++axis) nearest[axis] = std::clamp(local[axis], -1.0, 1.0);
    const Vec3 centre = transform(sheared, local), way = transform(sheared, nearest) - centre;
    const PosedSphere short_of_it(centre, 0.99 * length(way));
    wrong += overlap(short_of_it, PosedBox(Box(cube), sheared));
  }
  EXPECT_GT(wrong, 100);
}

}  // namespace
}  // namespace toccata
