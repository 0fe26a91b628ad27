#include "toccata/narrow/plane.hpp"

#include <gtest/gtest.h>

#include <array>

#include "oracle/oracle.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

const Plane floor_plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});

TEST(Plane, CounterClockwisePointsSeenFromAboveHaveTheirNormalUp) {
  EXPECT_EQ(normal(floor_plane), (Vec3{0, 0, 1}));
  EXPECT_EQ(side(floor_plane, {5, 5, 1e-300}), Sign::positive);
  EXPECT_EQ(side(floor_plane, {5, 5, -1e-300}), Sign::negative);
  EXPECT_EQ(side(floor_plane, {1e300, -7, 0}), Sign::zero);
}

TEST(Plane, TheSlidesNormalPointsInward) {
  // A face of a solid below it, counter-clockwise from outside: V1, V2, V3. The slide takes (V3 − V1) × (V2 − V1).
  const Vec3 v1{0, 0, 0}, v2{1, 0, 0}, v3{0, 1, 0};
  const Vec3 inside{0.2, 0.2, -1};
  EXPECT_GT(dot(cross(v3 - v1, v2 - v1), inside - v1), 0);
  EXPECT_EQ(side(Plane(v1, v2, v3), inside), Sign::negative);
}

TEST(Plane, NeedsThreePointsThatSpanIt) {
  EXPECT_THROW(Plane({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), Error);
  EXPECT_THROW(Plane({0, 0, 0}, {0, 0, 0}, {2, 1, 2}), Error);
  EXPECT_THROW(Plane({0, 0, 0}, {1, 0, 0}, {0, HUGE_VAL, 0}), Error);
  EXPECT_NO_THROW(Plane({0, 0, 0}, {1, 1, 1}, {2, 2, 2 + 4e-16}));
}

TEST(Plane, SegmentIsCutInNothingAPointOrAllOfIt) {
  EXPECT_EQ(cut_segment(floor_plane, {0, 0, 1}, {9, 9, 2}).kind, PlaneCutKind::none);
  EXPECT_EQ(cut_segment(floor_plane, {1, 2, 0}, {3, 4, 0}).kind, PlaneCutKind::whole);
  const PlaneCut through = cut_segment(floor_plane, {0, 0, 1}, {3, 6, -2});
  EXPECT_EQ(through.kind, PlaneCutKind::point);
  EXPECT_EQ(through.point, (Vec3{1, 2, 0}));
  const PlaneCut end = cut_segment(floor_plane, {0.1, 0.7, 0}, {3, 6, -2});
  EXPECT_EQ(end.kind, PlaneCutKind::point);
  EXPECT_EQ(end.point, (Vec3{0.1, 0.7, 0}));
  EXPECT_EQ(cut_segment(floor_plane, {1, 2, 0}, {1, 2, 0}).kind, PlaneCutKind::point);
}

TEST(Plane, LineIsCutBeyondItsPointsToo) {
  EXPECT_EQ(cut_line(floor_plane, {0, 0, 1}, {1, 2, 2}).point, (Vec3{-1, -2, 0}));
  EXPECT_EQ(cut_line(floor_plane, {0, 0, 1}, {1, 2, 1}).kind, PlaneCutKind::none);
  EXPECT_EQ(cut_line(floor_plane, {0, 0, 0}, {1, 2, 0}).kind, PlaneCutKind::whole);
  EXPECT_THROW(static_cast<void>(cut_line(floor_plane, {1, 1, 1}, {1, 1, 1})), Error);
}

struct ExactVector {
  std::array<oracle::Rational, 3> at;
};

ExactVector minus(const Vec3& p, const Vec3& q) {
  ExactVector result;
  for (int i = 0; i < 3; ++i) result.at[static_cast<std::size_t>(i)] = oracle::Rational(p[i]) - oracle::Rational(q[i]);
  return result;
}

/// (u × v) · w
oracle::Rational volume(const ExactVector& u, const ExactVector& v, const ExactVector& w) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    return oracle::Rational(u.at[i] * v.at[j] - u.at[j] * v.at[i]);
  };
  return minor(1, 2) * w.at[0] + minor(2, 0) * w.at[1] + minor(0, 1) * w.at[2];
}

int sign(const oracle::Rational& r) { return r > 0 ? 1 : r < 0 ? -1 : 0; }

/// The rounded point is the double nearest to the exact one: no neighbouring double is nearer.
bool is_nearest(double rounded, const oracle::Rational& exact) {
  const auto distance = [&](double x) { return oracle::Rational(abs(oracle::Rational(x) - exact)); };
  return distance(rounded) <= distance(std::nextafter(rounded, HUGE_VAL)) &&
         distance(rounded) <= distance(std::nextafter(rounded, -HUGE_VAL));
}

void expect_like_rationals(const Plane& plane, const Vec3& p, const Vec3& q) {
  const ExactVector u = minus(plane.b(), plane.a()), v = minus(plane.c(), plane.a());
  const oracle::Rational from = volume(u, v, minus(p, plane.a())), to = volume(u, v, minus(q, plane.a()));
  EXPECT_EQ(static_cast<int>(side(plane, p)), sign(from));
  const PlaneCut cut = cut_segment(plane, p, q);
  const bool meets = sign(from) * sign(to) <= 0;
  const bool whole = sign(from) == 0 && sign(to) == 0 && !(p == q);
  EXPECT_EQ(cut.kind, whole ? PlaneCutKind::whole : meets ? PlaneCutKind::point : PlaneCutKind::none);
  if (sign(from) * sign(to) >= 0) return;
  for (int i = 0; i < 3; ++i) {
    const oracle::Rational exact =
        oracle::Rational(p[i]) + from / (from - to) * (oracle::Rational(q[i]) - oracle::Rational(p[i]));
    EXPECT_TRUE(is_nearest(cut.point[i], exact)) << cut.point[i];
  }
}

TEST(Plane, AgreesWithRationals) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    // Coarse coordinates often lie in the plane; fine ones test the rounding.
    const bool coarse = seed % 2 == 0;
    const auto coordinate = [&] { return coarse ? static_cast<double>(random.below(5)) : random.between(-1, 1); };
    const auto point = [&] { return Vec3{coordinate(), coordinate(), coordinate()}; };
    const Vec3 a = point(), b = point(), c = point(), p = point(), q = point();
    try {
      expect_like_rationals(Plane(a, b, c), p, q);
    } catch (const Error&) {
      const ExactVector u = minus(b, a), v = minus(c, a);
      for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        EXPECT_EQ(volume(u, v, minus(axis, {})), 0);
    }
  }
}

}  // namespace
}  // namespace toccata
