#include "toccata/methods/minkowski.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "methods/minkowski/general_overlay.hpp"
#include "methods/minkowski_checks.hpp"
#include "support/convex_cases.hpp"
#include "toccata/core/error.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

using test::SumTruth;

std::string checked(const PosedPolytope& a, const PosedPolytope& b, bool negated = false) {
  const MinkowskiSum sum = negated ? minkowski_difference(a, b) : minkowski_sum(a, b);
  const SumTruth truth(a, b, negated);
  const std::string wrong = test::sum_fault(sum, truth);
  return wrong.empty() ? test::volume_fault(sum, truth) : wrong;
}

Index faces_of(const MinkowskiSum& sum, SumFaceKind kind) {
  Index count = 0;
  for (Index f = 0; f < sum.topology().face_count(); ++f) count += sum.face_kind(f) == kind;
  return count;
}

TEST(MinkowskiSum, OfTwoAlignedBoxesIsABox) {
  const PosedPolytope a(Box{{1, 2, 3}}), b(Box{{0.5, 0.25, 1}}, Pose::translation(10, 0, 0));
  const MinkowskiSum sum = minkowski_sum(a, b);
  EXPECT_EQ(checked(a, b), "");
  EXPECT_EQ(sum.vertex_count(), 8U);
  EXPECT_EQ(faces_of(sum, SumFaceKind::of_both), 6U);
  EXPECT_EQ(sum.topology().face_count(), 6U);
  EXPECT_EQ(sum.vertex(0), (Vec3{8.5, -2.25, -4}));
  EXPECT_EQ(sum.side_of({11.5, 0, 0}), Sign::zero);
  EXPECT_EQ(sum.side_of({11.25, 0, 0}), Sign::negative);
  EXPECT_EQ(sum.side_of({std::nextafter(11.5, 12), 0, 0}), Sign::positive);
}

TEST(MinkowskiSum, OfSegmentsIsAParallelepiped) {
  const PosedPolytope x(Segment({0, 0, 0}, {1, 0, 0})), y(Segment({0, 0, 0}, {0, 2, 0})),
      z(Segment({0, 0, 0}, {1, 1, 3}));
  const MinkowskiSum square = minkowski_sum(x, y);
  EXPECT_EQ(square.dimension(), 2);
  EXPECT_EQ(square.topology().face_count(), 2U);
  EXPECT_EQ(square.side_of({0.5, 1, 0}), Sign::zero);
  EXPECT_EQ(square.side_of({0.5, 1, 1e-300}), Sign::positive);
  EXPECT_EQ(square.side_of({1.5, 1, 0}), Sign::positive);
  const ConvexHull hull = square.as_hull();
  const PosedPolytope flat(hull);
  const MinkowskiSum body = minkowski_sum(flat, z);
  EXPECT_EQ(body.dimension(), 3);
  EXPECT_EQ(body.vertex_count(), 8U);
  EXPECT_EQ(body.topology().face_count(), 6U);
  EXPECT_EQ(faces_of(body, SumFaceKind::of_edges), 4U);
}

TEST(MinkowskiSum, OfParallelSegmentsAndOfPointsHasNoFaces) {
  const PosedPolytope s(Segment({1, 1, 1}, {0, 0, 0})), t(Segment({0, 0, 0}, {2, 2, 2})), p(Point({5, 0, 0}));
  for (const PosedPolytope* other : {&t, &p, &s}) EXPECT_EQ(checked(s, *other), "");
  const MinkowskiSum segment = minkowski_sum(s, t);
  EXPECT_EQ(segment.dimension(), 1);
  EXPECT_EQ(segment.vertex_count(), 2U);
  EXPECT_EQ(segment.side_of({3, 3, 3}), Sign::zero);
  EXPECT_EQ(segment.side_of({3.5, 3.5, 3.5}), Sign::positive);
  EXPECT_EQ(segment.side_of({1, 1, 1.5}), Sign::positive);
  const MinkowskiSum point = minkowski_sum(p, p);
  EXPECT_EQ(point.dimension(), 0);
  EXPECT_EQ(point.side_of({10, 0, 0}), Sign::zero);
  EXPECT_EQ(point.side_of({10, 0, 1}), Sign::positive);
  EXPECT_THROW(static_cast<void>(point.as_mesh()), Error);
}

TEST(MinkowskiSum, MergesParallelFacesOfPrisms) {
  // Two prisms over triangles: top and bottom are parallel, and two of the edges.
  const std::vector<Vec3> first{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 2}, {4, 0, 2}, {0, 4, 2}};
  const std::vector<Vec3> second{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 5}, {1, 0, 5}, {1, 1, 5}};
  const ConvexHull a(first), b(second);
  const MinkowskiSum sum = minkowski_sum(PosedPolytope(a), PosedPolytope(b));
  EXPECT_EQ(checked(PosedPolytope(a), PosedPolytope(b)), "");
  EXPECT_EQ(faces_of(sum, SumFaceKind::of_both), 3U);  // and the side over the parallel edges
  EXPECT_EQ(faces_of(sum, SumFaceKind::of_edges), 0U);
  EXPECT_EQ(sum.topology().face_count(), 7U);
  EXPECT_EQ(sum.vertex_count(), 10U);
}

TEST(MinkowskiSum, IsThatOfTheOracleForAllKindsAndRegimes) {
  for (const std::string& kind : test::convex_kinds())
    for (std::uint64_t number = 0; number < 42; ++number) {
      Random random(number);
      const test::ConvexCase pair = test::numbered_case(kind, number, random);
      const PosedPolytope a = test::posed(pair.a), b = test::posed(pair.b);
      if (a.vertex_count() * b.vertex_count() > 100) continue;
      ASSERT_EQ(checked(a, b), "") << kind << " " << number << ": " << test::to_text(pair);
      ASSERT_EQ(checked(b, a, true), "") << kind << " " << number << ": " << test::to_text(pair);
    }
}

bool same_facets(const SumFacets& p, const SumFacets& q) {
  const auto same_vector = [](const PlaneVector& u, const PlaneVector& v) {
    return u.of_b == v.of_b && u.head == v.head && u.tail == v.tail;
  };
  const auto same_plane = [&](const auto& m, const auto& n) {
    return same_vector(m[0], n[0]) && same_vector(m[1], n[1]);
  };
  return p.corners == q.corners && p.first == q.first && p.kinds == q.kinds &&
         std::ranges::equal(p.planes, q.planes, same_plane);
}

TEST(MinkowskiSum, InGeneralPositionHasTheFacetsOfTheExactOverlay) {
  int general = 0, in_doubt = 0;
  for (const std::string kind : {"box", "hull", "needle-hull"})
    for (std::uint64_t number = 0; number < 420; ++number) {
      Random random(number);
      const test::ConvexCase pair = test::numbered_case(kind, number, random);
      const SumOperand a(test::posed(pair.a), false), b(test::posed(pair.b), number % 2 == 1);
      const std::optional<SumFacets> found = general_overlay(a, b);
      ++(found ? general : in_doubt);
      if (!found) continue;
      ASSERT_TRUE(same_facets(*found, overlay(a, b))) << kind << " " << number << ": " << test::to_text(pair);
    }
  EXPECT_GT(general, 100);
  EXPECT_GT(in_doubt, 100);
}

/// Where the rounded vertices lie and between them, each also moved by a last place, and what is far or anywhere.
std::vector<Vec3> questions_to(const MinkowskiSum& sum, Random& random) {
  std::vector<Vec3> points{{0, 0, 0}, {1e30, -3, 2}};
  const auto vertex = [&] { return sum.vertex(static_cast<Index>(random.below(sum.vertex_count()))); };
  for (int i = 0; i < 3; ++i) {
    const Vec3 p = vertex(), q = vertex(), r = vertex();
    points.insert(points.end(),
                  {p, 0.5 * (p + q), p + random.between(-0.1, 1.1) * (q - p), 0.25 * ((p + q) + (q + r))});
    Vec3 moved = 0.5 * (q + r);
    moved.x = std::nextafter(moved.x, i == 0 ? HUGE_VAL : -HUGE_VAL);
    points.push_back(moved);
    const double radius = sum.radius();
    points.insert(points.end(), {p + Vec3{radius, 0, 0}, q - Vec3{0, radius, 0}, 0.5 * (p + r) + Vec3{0, 0, radius}});
  }
  return points;
}

TEST(MinkowskiSum, TellsTheSideOfAPointAsTheOracleDoes) {
  std::array<int, 3> seen{};
  for (const std::string& kind : test::convex_kinds())
    for (std::uint64_t number = 0; number < 42; ++number) {
      Random random(number);
      const test::ConvexCase pair = test::numbered_case(kind, number, random);
      const PosedPolytope a = test::posed(pair.a), b = test::posed(pair.b);
      if (a.vertex_count() * b.vertex_count() > 64) continue;
      const MinkowskiSum sum = minkowski_sum(a, b);
      const SumTruth truth(a, b, false);
      for (const Vec3& p : questions_to(sum, random)) {
        ASSERT_EQ(test::side_fault(sum, {truth.all(), truth.radius}, p), "")
            << kind << " " << number << ": " << test::to_text(pair);
        ++seen[static_cast<std::size_t>(sum.side_of(p)) + 1];
      }
    }
  for (const int count : seen) EXPECT_GT(count, 400);
}

TEST(SumLocator, AnswersAsTheSumDoes) {
  std::array<int, 3> seen{};
  for (const std::string& kind : test::convex_kinds())
    for (std::uint64_t number = 0; number < 84; ++number) {
      Random random(number);
      const test::ConvexCase pair = test::numbered_case(kind, number, random);
      const PosedPolytope a = test::posed(pair.a), b = test::posed(pair.b);
      const MinkowskiSum sum = minkowski_sum(a, b);
      const SumLocator locator(sum);
      for (int round = 0; round < 4; ++round)
        for (const Vec3& p : questions_to(sum, random)) {
          ASSERT_EQ(locator.side_of(p), sum.side_of(p)) << kind << " " << number << ": " << test::to_text(pair);
          ++seen[static_cast<std::size_t>(sum.side_of(p)) + 1];
        }
    }
  for (const int count : seen) EXPECT_GT(count, 400);
  const MinkowskiSum sum = minkowski_sum(PosedPolytope(Box{{1, 1, 1}}), PosedPolytope(Box{{1, 1, 1}}));
  EXPECT_THROW(static_cast<void>(SumLocator(sum).side_of({0, HUGE_VAL, 0})), Error);
}

TEST(MinkowskiDifference, HoldsTheOriginExactlyWhenTheShapesMeet) {
  for (const std::string& kind : test::convex_kinds())
    for (std::uint64_t number = 0; number < 84; ++number) {
      Random random(number);
      const test::ConvexCase pair = test::numbered_case(kind, number, random);
      const PosedPolytope a = test::posed(pair.a), b = test::posed(pair.b);
      const bool met = overlap(a, b);
      ASSERT_EQ(minkowski_difference(a, b).contains({}), met) << kind << " " << number << ": " << test::to_text(pair);
      ASSERT_EQ(minkowski_difference(b, a).contains({}), met) << kind << " " << number << ": " << test::to_text(pair);
    }
}

TEST(MinkowskiSum, RefusesWhatIsNotFinite) {
  const PosedPolytope a(Box{{1e308, 1, 1}});
  EXPECT_THROW(static_cast<void>(minkowski_sum(a, a)), Error);
  const MinkowskiSum sum = minkowski_sum(PosedPolytope(Point({0, 0, 0})), a);
  EXPECT_THROW(static_cast<void>(sum.side_of({0, std::numeric_limits<double>::quiet_NaN(), 0})), Error);
}

}  // namespace
}  // namespace toccata
