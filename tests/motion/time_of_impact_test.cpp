#include "toccata/motion/time_of_impact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "motion/integer_polynomial.hpp"
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

TimeOfImpact at(double time) { return {time, time}; }

/// A point that falls onto the triangle from height 1 to −1.
VertexFace falling_on(double x, double y) { return {{{x, y, 1}, {x, y, -1}}, corner_of_the_plane}; }

/// The edge along x from −1 to 1, and one across it that falls from height 1 to −1.
EdgeEdge falling_across(double x) {
  return {{resting({-1, 0, 0}), resting({1, 0, 0})},
          {MovingPoint{{x, -1, 1}, {x, -1, -1}}, MovingPoint{{x, 1, 1}, {x, 1, -1}}}};
}

TEST(TimeOfImpact, CornersAndEdgesBelongToTheFaceAndTheNextDoubleDoesNot) {
  for (const double x : {0.0, 0.25, 0.5, 1.0}) EXPECT_EQ(time_of_impact(falling_on(x, 0)), at(0.5));
  EXPECT_EQ(time_of_impact(falling_on(0.5, 0.5)), at(0.5));
  EXPECT_FALSE(time_of_impact(falling_on(0.5, 0.5000000000000001)));
  EXPECT_FALSE(time_of_impact(falling_on(-0x1p-1074, 0)));
  EXPECT_EQ(time_of_impact(falling_across(1)), at(0.5));
  EXPECT_FALSE(time_of_impact(falling_across(1.0000000000000002)));
}

TEST(TimeOfImpact, ContactAtTheStartAndAtTheEndCounts) {
  VertexFace pair = falling_on(0.25, 0.25);
  pair.vertex.start.z = 0;
  EXPECT_EQ(time_of_impact(pair), at(0));
  pair.vertex = {{0.25, 0.25, 3}, {0.25, 0.25, 0}};
  EXPECT_EQ(time_of_impact(pair), at(1));
  pair.vertex.end.z = 0x1p-1074;
  EXPECT_FALSE(time_of_impact(pair));
}

TEST(TimeOfImpact, ATimeThatIsNoMultipleLiesBetweenTwo) {
  const VertexFace pair{{{0.25, 0.25, 1}, {0.25, 0.25, -2}}, corner_of_the_plane};
  const std::optional<TimeOfImpact> contact = time_of_impact(pair);
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->upper - contact->lower, 0x1p-40);
  EXPECT_LT(contact->lower, 1.0 / 3);
  EXPECT_GT(contact->upper, 1.0 / 3);
}

TEST(TimeOfImpact, WhatOnlyGrazesIsMetAndWhatMissesByAHairIsNot) {
  const auto grazing_at = [](double height) {
    return EdgeEdge{{MovingPoint{{2, -1, height}, {-2, -1, height}}, MovingPoint{{2, 1, height}, {-2, 1, height}}},
                    {MovingPoint{{-2, 0, -1}, {-2, 0, 1}}, MovingPoint{{2, 0, 1}, {2, 0, -1}}}};
  };
  EXPECT_EQ(time_of_impact(grazing_at(0)), at(0.5));
  EXPECT_FALSE(time_of_impact(grazing_at(-0x1p-1000)));
  const std::optional<TimeOfImpact> contact = time_of_impact(grazing_at(0x1p-1000));
  EXPECT_TRUE(contact.has_value() && contact->lower < 0.5 && contact->upper == 0.5);
}

TEST(TimeOfImpact, WhatSlidesInThePlaneMeetsTheEdgeFirst) {
  EXPECT_EQ(time_of_impact(VertexFace{{{-1, 0.5, 0}, {3, 0.5, 0}}, corner_of_the_plane}), at(0.25));
  EXPECT_FALSE(time_of_impact(VertexFace{{{-1, 1.0625, 0}, {3, 1.0625, 0}}, corner_of_the_plane}));
}

TEST(TimeOfImpact, WhatRestsOrMovesAlikeMeetsAtOnceOrNever) {
  const Vec3 way{3, -4, 5};
  const auto moving = [&](const Vec3& p) { return MovingPoint{p, p + way}; };
  const std::array<MovingPoint, 3> face{moving({0, 0, 0}), moving({8, 0, 0}), moving({0, 8, 0})};
  EXPECT_EQ(time_of_impact(VertexFace{moving({1, 1, 0}), face}), at(0));
  EXPECT_FALSE(time_of_impact(VertexFace{moving({1, 1, 1}), face}));
  EXPECT_EQ(time_of_impact(VertexFace{resting({1, 0, 0}), corner_of_the_plane}), at(0));
}

TEST(TimeOfImpact, FeaturesThatHaveCollapsedAreSegmentsAndPoints) {
  const MovingPoint origin = resting({0, 0, 0});
  const MovingPoint through{{-1, -1, -1}, {1, 1, 1}}, beside{{-1, -1, -1}, {1, 1, 1.0000000000000002}};
  EXPECT_EQ(time_of_impact(VertexFace{through, {origin, origin, origin}}), at(0.5));
  EXPECT_FALSE(time_of_impact(VertexFace{beside, {origin, origin, origin}}));
  EXPECT_EQ(time_of_impact(EdgeEdge{{through, through}, {origin, origin}}), at(0.5));
  EXPECT_FALSE(time_of_impact(EdgeEdge{{beside, beside}, {origin, origin}}));
  // A face that is a segment for one moment, and all in one plane.
  const std::array<MovingPoint, 3> folding{resting({0, 0, 0}), resting({1, 0, 0}), MovingPoint{{3, 1, 0}, {3, -1, 0}}};
  EXPECT_EQ(time_of_impact(VertexFace{resting({2, 0, 0}), folding}), at(0.5));
}

TEST(TimeOfImpact, TheLargestAndTheLeastDoublesAreAnswered) {
  const double large = std::numeric_limits<double>::max(), least = 0x1p-1074;
  for (const double unit : {large, least}) {
    const VertexFace pair{{{0, 0, unit}, {0, 0, -unit}},
                          {resting({-unit, -unit, 0}), resting({unit, -unit, 0}), resting({0, unit, 0})}};
    EXPECT_EQ(time_of_impact(pair), at(0.5));
    VertexFace missed = pair;
    missed.face[0] = missed.face[1];
    EXPECT_FALSE(time_of_impact(missed));
  }
}

/// The middle coefficients of the cubic overflow, those of its ends and the bound on the error do not.
TEST(TimeOfImpact, AnInfiniteCoefficientHidesNoContact) {
  const VertexFace rising{resting({0, 0, 0}),
                          {{{{-4.3473071777183154e+102, 2.080292238339505e+102, -2.8695157770406946e+100},
                             {4.391777073985085e+102, 2.1844144644134688e+102, 0}},
                            {{-5.2242189843492377e+102, 3.1300960984696254e+102, 1.5915343962780003e+102},
                             {-5.3588694006778668e+102, -3.1250395791137579e+102, 1.5524741996806518e+102}},
                            {{2.5784653411218101e+102, 4.4719144409536011e+101, 2.9747134465206842e+102},
                             {2.2934599091942281e+102, 5.0762079975686307e+101, -2.3934984478450461e+102}}}}};
  const VertexFace turning{
      resting({0, 0, 0}),
      {{{{-2.1525866968297626e+102, -1.93893007417792e+102, 2.8191762286458571e+102},
         {-1.4762873516785247e+102, -1.9164818276946961e+102, -2.7509467863408358e+102}},
        {{0, -2.9396819720892956e+102, 3.7715874455428897e+102}, {0, 2.8413379802310164e+102, 3.6226944848541158e+102}},
        {{-5.0220181529803496e+102, 1.2193146891177559e+102, 0},
         {5.0407392301870973e+102, 1.2086947478263329e+102, 0}}}}};
  for (const VertexFace& pair : {rising, turning}) {
    EXPECT_TRUE(time_of_impact(pair));
    EXPECT_EQ(time_of_impact(pair), time_of_impact_by_integers(differences(pair)));
    EXPECT_FALSE(wrong_answer(pair, time_of_impact(pair)));
  }
}

TEST(TimeOfImpact, ACoordinateThatIsNotFiniteIsAnError) {
  VertexFace pair = falling_on(0, 0);
  pair.face[2].end.y = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)time_of_impact(pair), Error);
  EdgeEdge edges = falling_across(0);
  edges.b[1].start.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)time_of_impact(edges), Error);
  const std::array pairs{falling_across(0), edges};
  try {
    (void)time_of_impact_each(std::span<const EdgeEdge>(pairs));
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("of pair 1"), std::string::npos) << error.what();
  }
}

/// t (1 − 4t)(3 − 4t)(1 − t): the first and the last are at the ends, the others where cells begin.
TEST(IntegerPolynomialRoots, ARootWhereCellsBeginIsFoundOnce) {
  const auto line = [](int start, int end) { return IntegerPolynomial(WideInteger(start), WideInteger(end)); };
  IntegerPolynomial product = line(0, 1) * line(1, -3) * line(3, -1) * line(1, 0);
  EXPECT_EQ(roots_in_unit_interval(product).size(), 4U);
}

TEST(TimeOfImpact, ManyAreAnsweredAsOneByOneOnAnyNumberOfThreads) {
  std::vector<VertexFace> pairs;
  std::vector<EdgeEdge> edges;
  Random random(7);
  for (const MotionFamily& family : feature_families()) {
    for (int i = 0; i < 20; ++i) {
      const MovingPoints points = family.draw(random);
      pairs.push_back(vertex_face(points));
      edges.push_back(edge_edge(points));
    }
  }
  const auto alone = time_of_impact_each(pairs, own_thread);
  for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_EQ(alone[i], time_of_impact(pairs[i]));
  EXPECT_EQ(time_of_impact_each(pairs, 3), alone);
  EXPECT_EQ(time_of_impact_each(edges, 3), time_of_impact_each(edges, own_thread));
}

/// Every question of the public data has its known answer, and the oracle's time.
template <class Pair>
void expect_right(const std::vector<MotionQuery<Pair>>& queries, std::size_t hits) {
  std::size_t found = 0;
  for (const MotionQuery<Pair>& query : queries) {
    const std::optional<TimeOfImpact> contact = time_of_impact(query.pair);
    found += contact.has_value();
    EXPECT_EQ(contact.has_value(), query.is_hit) << query.name;
    const auto wrong = wrong_answer(query.pair, contact);
    EXPECT_FALSE(wrong) << query.name << ": " << *wrong;
    EXPECT_EQ(time_of_impact_by_integers(differences(query.pair)), contact) << query.name;
  }
  EXPECT_EQ(found, hits);
}

TEST(TimeOfImpact, OfThePublicQuestionsNoneIsMissedAndNoneIsAFalseAlarm) {
  const auto data = data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA to the folder with ccd";
  expect_right(vertex_face_queries(*data), 82);
  expect_right(edge_edge_queries(*data), 68);
}

}  // namespace
}  // namespace toccata::test
