#include "toccata/methods/voronoi.hpp"

#include <gtest/gtest.h>

#include "methods/voronoi_walks.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

TEST(VoronoiWalk, TellsWhatGjkTellsInEveryFamily) {
  Random random(7);
  for (const std::string& family : test::walk_families())
    for (int i = 0; i < 3; ++i) EXPECT_EQ(test::fault_of_walks(family, random, 8), "") << family << " " << i;
}

struct Moved {
  ConvexHull hull;
  VoronoiRegions regions;
};

Moved moved_hull(std::uint64_t seed, int vertices) {
  Random random(seed);
  const ConvexHull hull = test::walked_hull(random, vertices, false);
  return {hull, VoronoiRegions(hull)};
}

// The lecture: "easy to exploit coherence (remember the closest feature from the last frame)".
TEST(VoronoiWalk, SmallStepsNeedFewStepsWhateverTheNumberOfFeatures) {
  const Moved a = moved_hull(1, 512), b = moved_hull(2, 512);
  TrackedPair tracked;
  const auto ask = [&](int i) {
    const Pose pose{rotation_about({1, 2, 3}, 0.2 * i), {2.5, 0.002 * i, 0}};
    return distance_by_voronoi_walk(PosedPolytope(a.hull), a.regions, PosedPolytope(b.hull, pose), b.regions, tracked);
  };
  tracked.state = TrackedPair::State::apart;  // at the first vertices: a long walk
  ask(0);
  const VoronoiCounts cold = tracked.counts;
  for (int i = 1; i <= 200; ++i) ask(i);
  EXPECT_GT(cold.steps, 5U);
  EXPECT_LT(tracked.counts.steps - cold.steps, 200U);
  EXPECT_GT(tracked.counts.kept, 100U);
  EXPECT_LT(tracked.counts.searched, 10U);
  EXPECT_EQ(tracked.counts.questions, 201U);
}

// Where nothing is known a walk begins at the vertices that face each other, which are close to the nearest ones
// wherever the frames of the shapes are; of 512 vertices and more the guide of the hull tells which.
TEST(VoronoiWalk, TheFirstQuestionNeedsFewStepsToo) {
  Random random(17);
  for (const int vertices : {8, 100, 511, 512, 2000}) {
    const Moved a = moved_hull(1, vertices), b = moved_hull(2, vertices);
    for (int i = 0; i < 10; ++i) {
      const Vec3 way = test::vector_within(random, 1);
      const Pose pose{rotation_about({1, 2, 3}, 37.0 * i), (2.2 / std::sqrt(dot(way, way))) * way};
      const PosedPolytope posed_a(a.hull), posed_b(b.hull, pose);
      TrackedPair tracked;
      EXPECT_EQ(distance_by_voronoi_walk(posed_a, a.regions, posed_b, b.regions, tracked),
                distance_by_gjk(posed_a, posed_b));
      EXPECT_EQ(tracked.counts.walked, 1U) << vertices << " " << i;
      EXPECT_LE(tracked.counts.steps, 12U) << vertices << " " << i;
    }
  }
}

TEST(VoronoiWalk, PenetrationIsDetectedAndLeft) {
  const Moved a = moved_hull(3, 32), b = moved_hull(4, 32);
  TrackedPair tracked;
  const auto ask = [&](double x) {
    const PosedPolytope posed_a(a.hull), posed_b(b.hull, Pose::translation(x, 0.1, 0.2));
    const Distance distance = distance_by_voronoi_walk(posed_a, a.regions, posed_b, b.regions, tracked);
    EXPECT_EQ(distance, distance_by_gjk(posed_a, posed_b));
    EXPECT_EQ(distance.upper == 0, overlap(posed_a, posed_b));
    return distance.upper;
  };
  for (int tenths = 30; tenths > 0; --tenths) ask(0.1 * tenths);
  EXPECT_EQ(tracked.state, TrackedPair::State::meeting);
  for (int tenths = 0; tenths < 30; ++tenths) ask(0.1 * tenths);
  EXPECT_EQ(tracked.state, TrackedPair::State::apart);
}

// The lecture: "cannot loop forever": each pair of features is strictly nearer than the one before.
TEST(VoronoiWalk, EveryVisitIsStrictlyNearerAndTheLastIsTheNearest) {
  std::size_t longest = 0;
  for (int seed = 0; seed < 20; ++seed) {
    const Moved a = moved_hull(static_cast<std::uint64_t>(seed), 64);
    const Moved b = moved_hull(static_cast<std::uint64_t>(seed) + 100, 200);
    const PosedPolytope posed_a(a.hull), posed_b(b.hull, {rotation_about({1, 2, 3}, 9.0 * seed), {1.6, 1.1, -1.3}});
    TrackedPair tracked;
    VoronoiPath path;
    const Distance distance = distance_by_voronoi_walk(posed_a, a.regions, posed_b, b.regions, tracked, path);
    EXPECT_EQ(distance, distance_by_gjk(posed_a, posed_b)) << seed;
    ASSERT_FALSE(path.visits.empty()) << seed;
    for (std::size_t i = 1; i < path.visits.size(); ++i)
      EXPECT_LT(path.visits[i].distance_squared, path.visits[i - 1].distance_squared) << seed;
    EXPECT_EQ(path.end, WalkEnd::nearest) << seed;
    EXPECT_EQ(path.visits.back().on_a, tracked.on_a) << seed;
    EXPECT_EQ(path.visits.back().on_b, tracked.on_b) << seed;
    EXPECT_NEAR(path.visits.back().distance_squared, distance.upper * distance.upper, 1e-12) << seed;
    longest = std::max(longest, path.visits.size());
  }
  EXPECT_GT(longest, 8U);
}

TEST(VoronoiWalk, AWalkIntoPenetrationEndsBelow) {
  const Moved a = moved_hull(3, 32), b = moved_hull(4, 32);
  const PosedPolytope posed_a(a.hull), posed_b(b.hull, Pose::translation(0.4, 0.1, 0.2));
  TrackedPair tracked;
  VoronoiPath path;
  const auto ask = [&] {
    return distance_by_voronoi_walk(posed_a, a.regions, posed_b, b.regions, tracked, path).upper;
  };
  EXPECT_EQ(ask(), 0);
  EXPECT_EQ(path.end, WalkEnd::below);
  EXPECT_EQ(ask(), 0);
  EXPECT_EQ(path.end, WalkEnd::not_walked);
  EXPECT_TRUE(path.visits.empty());
}

// By the method that looks at all axes: what it takes for the widest gap is the distance between a vertex and a face
// and between two edges.
TEST(VoronoiWalk, TheDistanceIsTheWidestGapOfSeparatingAxes) {
  Random random(11);
  int planes = 0;
  for (int i = 0; i < 60; ++i) {
    const Moved a = moved_hull(random.below(1000), 8), b = moved_hull(random.below(1000), 10);
    const PosedPolytope posed_a(a.hull), posed_b(b.hull, Pose::translation(2.2, random.between(-1, 1), 0.3));
    TrackedPair tracked;
    const Distance d = distance_by_voronoi_walk(posed_a, a.regions, posed_b, b.regions, tracked);
    EXPECT_EQ(test::gap_fault(posed_a, posed_b, tracked, d.upper), "") << i;
    if (std::fabs(test::widest_gap(posed_a, posed_b) - d.upper) > 1e-9) continue;
    ++planes;
    // What is nearer or farther by a thousandth would be seen.
    EXPECT_NE(test::gap_fault(posed_a, posed_b, tracked, 0.999 * d.upper), "") << i;
    EXPECT_NE(test::gap_fault(posed_a, posed_b, tracked, 1.001 * d.upper), "") << i;
  }
  EXPECT_GT(planes, 10);
}

TEST(VoronoiWalk, WhatIsKeptMayBeOfAnotherPair) {
  Random random(9);
  const Moved big = moved_hull(5, 128), small = moved_hull(6, 8);
  const PosedPolytope posed_big(big.hull), posed_small(small.hull, Pose::translation(2, 1, 1));
  const Distance truth = distance_by_gjk(posed_big, posed_small);
  for (int i = 0; i < 100; ++i) {
    TrackedPair any;
    any.state = static_cast<TrackedPair::State>(random.below(3));
    any.cores_meet = random.below(4) == 0;
    any.on_a = {static_cast<ConvexFeature::Kind>(random.below(3)), static_cast<Index>(random.below(400))};
    any.on_b = {static_cast<ConvexFeature::Kind>(random.below(3)), static_cast<Index>(random.below(40))};
    EXPECT_EQ(distance_by_voronoi_walk(posed_big, big.regions, posed_small, small.regions, any), truth);
  }
}

// The vertices of a box are in the world, its regions in its own frame.
TEST(VoronoiWalk, AnyFeaturesOfTurnedBoxesMayBeKept) {
  const Box box({0.5, 1, 1.5});
  const VoronoiRegions regions(box);
  const PosedPolytope a(box, {rotation_about({1, 2, 3}, 40), {}}),
      b(box, {rotation_about({3, -1, 1}, 70), {2.5, 1, 1}});
  const Distance truth = distance_by_gjk(a, b);
  for (const ConvexFeature& on_a : regions.features())
    for (const ConvexFeature& on_b : regions.features()) {
      TrackedPair any{on_a, on_b, TrackedPair::State::apart};
      EXPECT_EQ(distance_by_voronoi_walk(a, regions, b, regions, any), truth);
    }
}

TEST(VoronoiWalk, RegionsOfAnotherShapeOfAsManyVerticesChangeNothing) {
  const Moved a = moved_hull(5, 20), b = moved_hull(6, 20), other = moved_hull(7, 20);
  ASSERT_EQ(b.hull.vertex_count(), other.hull.vertex_count());
  TrackedPair tracked;
  for (int i = 0; i < 40; ++i) {
    const PosedPolytope posed_a(a.hull), posed_b(b.hull, {rotation_about({1, 2, 3}, 3.0 * i), {2.2, 0.1, 0.05 * i}});
    EXPECT_EQ(distance_by_voronoi_walk(posed_a, a.regions, posed_b, other.regions, tracked),
              distance_by_gjk(posed_a, posed_b));
  }
}

TEST(VoronoiWalk, RegionsOfAnEqualHullBuiltApartAreAsGood) {
  const Moved a = moved_hull(5, 20), again = moved_hull(5, 20), b = moved_hull(6, 20);
  const PosedPolytope posed_a(a.hull), posed_b(b.hull, Pose::translation(2.2, 0.1, 0.3));
  TrackedPair tracked;
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(distance_by_voronoi_walk(posed_a, again.regions, posed_b, b.regions, tracked),
              distance_by_gjk(posed_a, posed_b));
  EXPECT_EQ(tracked.counts.walked, 1U);
  EXPECT_EQ(tracked.counts.kept, 2U);
}

TEST(VoronoiWalk, RegionsOfAnotherShapeAreRefused) {
  const Moved big = moved_hull(5, 128), small = moved_hull(6, 8);
  TrackedPair tracked;
  EXPECT_THROW((void)distance_by_voronoi_walk(PosedPolytope(big.hull), small.regions, PosedPolytope(small.hull),
                                              small.regions, tracked),
               Error);
}

}  // namespace
}  // namespace toccata
