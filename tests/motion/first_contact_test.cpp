#include "toccata/motion/first_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "motion/moving_polygon.hpp"
#include "support/data.hpp"
#include "support/motion_cases.hpp"
#include "support/motion_data.hpp"
#include "support/motion_judge.hpp"
#include "toccata/core/error.hpp"

namespace toccata::test {
namespace {

MovingPoint resting(const Vec3& p) { return {p, p}; }

/// The triangle (0, 0, 0), (1, 0, 0), (0, 1, 0), which rests.
const std::array<MovingPoint, 3> corner_of_the_plane{resting({0, 0, 0}), resting({1, 0, 0}), resting({0, 1, 0})};

FirstContact at(double time) { return {true, time, time}; }

/// A point that falls onto the triangle from height 1 to −1.
VertexFace falling_on(double x, double y) { return {{{x, y, 1}, {x, y, -1}}, corner_of_the_plane}; }

/// The edge along x from −1 to 1, and one across it that falls from height 1 to −1.
EdgeEdge falling_across(double x) {
  return {{resting({-1, 0, 0}), resting({1, 0, 0})},
          {MovingPoint{{x, -1, 1}, {x, -1, -1}}, MovingPoint{{x, 1, 1}, {x, 1, -1}}}};
}

TEST(FirstContact, CornersAndEdgesBelongToTheFaceAndTheNextDoubleDoesNot) {
  for (const double x : {0.0, 0.25, 0.5, 1.0}) EXPECT_EQ(first_contact(falling_on(x, 0)), at(0.5));
  EXPECT_EQ(first_contact(falling_on(0.5, 0.5)), at(0.5));
  EXPECT_FALSE(first_contact(falling_on(0.5, 0.5000000000000001)).hit);
  EXPECT_FALSE(first_contact(falling_on(-0x1p-1074, 0)).hit);
  EXPECT_EQ(first_contact(falling_across(1)), at(0.5));
  EXPECT_FALSE(first_contact(falling_across(1.0000000000000002)).hit);
}

TEST(FirstContact, ContactAtTheStartAndAtTheEndCounts) {
  VertexFace pair = falling_on(0.25, 0.25);
  pair.vertex.start.z = 0;
  EXPECT_EQ(first_contact(pair), at(0));
  pair.vertex = {{0.25, 0.25, 3}, {0.25, 0.25, 0}};
  EXPECT_EQ(first_contact(pair), at(1));
  pair.vertex.end.z = 0x1p-1074;
  EXPECT_FALSE(first_contact(pair).hit);
}

TEST(FirstContact, ATimeThatIsNoMultipleLiesBetweenTwo) {
  const VertexFace pair{{{0.25, 0.25, 1}, {0.25, 0.25, -2}}, corner_of_the_plane};
  const FirstContact contact = first_contact(pair);
  EXPECT_TRUE(contact.hit);
  EXPECT_EQ(contact.upper - contact.lower, 0x1p-40);
  EXPECT_LT(contact.lower, 1.0 / 3);
  EXPECT_GT(contact.upper, 1.0 / 3);
}

TEST(FirstContact, WhatOnlyGrazesIsMetAndWhatMissesByAHairIsNot) {
  const auto grazing_at = [](double height) {
    return EdgeEdge{{MovingPoint{{2, -1, height}, {-2, -1, height}}, MovingPoint{{2, 1, height}, {-2, 1, height}}},
                    {MovingPoint{{-2, 0, -1}, {-2, 0, 1}}, MovingPoint{{2, 0, 1}, {2, 0, -1}}}};
  };
  EXPECT_EQ(first_contact(grazing_at(0)), at(0.5));
  EXPECT_FALSE(first_contact(grazing_at(-0x1p-1000)).hit);
  const FirstContact contact = first_contact(grazing_at(0x1p-1000));
  EXPECT_TRUE(contact.hit && contact.lower < 0.5 && contact.upper == 0.5);
}

TEST(FirstContact, WhatSlidesInThePlaneMeetsTheEdgeFirst) {
  EXPECT_EQ(first_contact(VertexFace{{{-1, 0.5, 0}, {3, 0.5, 0}}, corner_of_the_plane}), at(0.25));
  EXPECT_FALSE(first_contact(VertexFace{{{-1, 1.0625, 0}, {3, 1.0625, 0}}, corner_of_the_plane}).hit);
}

TEST(FirstContact, WhatRestsOrMovesAlikeMeetsAtOnceOrNever) {
  const Vec3 way{3, -4, 5};
  const auto moving = [&](const Vec3& p) { return MovingPoint{p, p + way}; };
  const std::array<MovingPoint, 3> face{moving({0, 0, 0}), moving({8, 0, 0}), moving({0, 8, 0})};
  EXPECT_EQ(first_contact(VertexFace{moving({1, 1, 0}), face}), at(0));
  EXPECT_FALSE(first_contact(VertexFace{moving({1, 1, 1}), face}).hit);
  EXPECT_EQ(first_contact(VertexFace{resting({1, 0, 0}), corner_of_the_plane}), at(0));
}

TEST(FirstContact, FeaturesThatHaveCollapsedAreSegmentsAndPoints) {
  const MovingPoint origin = resting({0, 0, 0});
  const MovingPoint through{{-1, -1, -1}, {1, 1, 1}}, beside{{-1, -1, -1}, {1, 1, 1.0000000000000002}};
  EXPECT_EQ(first_contact(VertexFace{through, {origin, origin, origin}}), at(0.5));
  EXPECT_FALSE(first_contact(VertexFace{beside, {origin, origin, origin}}).hit);
  EXPECT_EQ(first_contact(EdgeEdge{{through, through}, {origin, origin}}), at(0.5));
  EXPECT_FALSE(first_contact(EdgeEdge{{beside, beside}, {origin, origin}}).hit);
  // A face that is a segment for one moment, and all in one plane.
  const std::array<MovingPoint, 3> folding{resting({0, 0, 0}), resting({1, 0, 0}), MovingPoint{{3, 1, 0}, {3, -1, 0}}};
  EXPECT_EQ(first_contact(VertexFace{resting({2, 0, 0}), folding}), at(0.5));
}

TEST(FirstContact, TheLargestAndTheLeastDoublesAreAnswered) {
  const double large = std::numeric_limits<double>::max(), least = 0x1p-1074;
  for (const double unit : {large, least}) {
    const VertexFace pair{{{0, 0, unit}, {0, 0, -unit}},
                          {resting({-unit, -unit, 0}), resting({unit, -unit, 0}), resting({0, unit, 0})}};
    EXPECT_EQ(first_contact(pair), at(0.5));
    VertexFace missed = pair;
    missed.face[0] = missed.face[1];
    EXPECT_FALSE(first_contact(missed).hit);
  }
}

TEST(FirstContact, ACoordinateThatIsNotFiniteIsAnError) {
  VertexFace pair = falling_on(0, 0);
  pair.face[2].end.y = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)first_contact(pair), Error);
  EdgeEdge edges = falling_across(0);
  edges.b[1].start.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)first_contact(edges), Error);
  EXPECT_THROW((void)first_contact_each(std::span<const EdgeEdge>(&edges, 1)), Error);
}

TEST(FirstContact, ManyAreAnsweredAsOneByOneOnAnyNumberOfThreads) {
  std::vector<VertexFace> pairs;
  std::vector<EdgeEdge> edges;
  Random random(7);
  for (const MotionFamily& family : motion_families()) {
    for (int i = 0; i < 20; ++i) {
      const MovingPoints points = family.draw(random);
      pairs.push_back(vertex_face(points));
      edges.push_back(edge_edge(points));
    }
  }
  const std::vector<FirstContact> alone = first_contact_each(pairs, own_thread);
  for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_EQ(alone[i], first_contact(pairs[i]));
  EXPECT_EQ(first_contact_each(pairs, 3), alone);
  EXPECT_EQ(first_contact_each(edges, 3), first_contact_each(edges, own_thread));
}

/// Every question of the public data has its known answer, and the oracle's time.
template <class Pair>
void expect_right(const std::vector<MotionQuery<Pair>>& queries, std::size_t hits) {
  std::size_t found = 0;
  for (const MotionQuery<Pair>& query : queries) {
    const FirstContact contact = first_contact(query.pair);
    found += contact.hit;
    EXPECT_EQ(contact.hit, query.is_hit) << query.name;
    const auto wrong = wrong_answer(query.pair, contact);
    EXPECT_FALSE(wrong) << query.name << ": " << *wrong;
    EXPECT_EQ(first_contact_by_integers(differences(query.pair)), contact) << query.name;
  }
  EXPECT_EQ(found, hits);
}

TEST(FirstContact, OfThePublicQuestionsNoneIsMissedAndNoneIsAFalseAlarm) {
  const auto data = data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA to the folder with ccd";
  expect_right(vertex_face_queries(*data), 82);
  expect_right(edge_edge_queries(*data), 68);
}

}  // namespace
}  // namespace toccata::test
