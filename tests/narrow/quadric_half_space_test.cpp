#include <fmt/format.h>
#include <gtest/gtest.h>

#include "narrow/quadric_cases.hpp"
#include "support/fewer_cases.hpp"
#include "toccata/core/random.hpp"

// Quadrics that meet a half-space in any pose, and the point of both that is told.
namespace toccata::test {
namespace {

/// A coordinate of the shape is no greater than this.
double greatest_coordinate(const oracle::FineSet& set, const Vec3& at) {
  using boost::multiprecision::abs;
  oracle::Fine size = 0;
  for (const oracle::FinePoint& axis : set.axis) size += abs(axis.x) + abs(axis.y) + abs(axis.z);
  return size.convert_to<double>() + std::max({std::fabs(at.x), std::fabs(at.y), std::fabs(at.z)});
}

oracle::Fine height_above(const PosedHalfSpace& below, const Vec3& point) {
  using oracle::Fine;
  const Vec3 &n = below.normal, &q = below.point;
  const Fine along = Fine(n.x) * (Fine(point.x) - Fine(q.x)) + Fine(n.y) * (Fine(point.y) - Fine(q.y)) +
                     Fine(n.z) * (Fine(point.z) - Fine(q.z));
  const Fine squared = Fine(n.x) * Fine(n.x) + Fine(n.y) * Fine(n.y) + Fine(n.z) * Fine(n.z);
  return along / sqrt(squared);
}

/// A half-space that the quadric reaches into by a share of its size: nothing, a little, half of it, more than all.
HalfSpace reached_into(const PlacedQuadric& quadric, Random& random) {
  const oracle::FineSet set = fine_set(quadric);
  Vec3 normal = quadric_direction(random);
  if (random.below(3) == 0) normal = normalized(quadric.pose.linear.column(static_cast<int>(random.below(3))));
  const auto lowest =
      oracle::farthest(set, {oracle::Fine(-normal.x), oracle::Fine(-normal.y), oracle::Fine(-normal.z)});
  const Vec3 at{lowest.x.convert_to<double>(), lowest.y.convert_to<double>(), lowest.z.convert_to<double>()};
  const Vec3 aside = cross(normal, quadric_direction(random));
  const double size = greatest_coordinate(set, {});
  const double deep = std::array{0.0, 1e-14, 1e-6, 0.01, 0.5, 3.0}[random.below(6)];
  return {at + (deep * size) * normal + (2 * size) * aside, normal};
}

TEST(QuadricHalfSpace, WhereTheyMeetThePointIsOneOfBoth) {
  Random random(20);
  int met = 0;
  for (const std::string& kind : quadric_kinds())
    for (const std::string& regime : quadric_regimes())
      for (int i = 0; i < fewer_under_tsan(30); ++i) {
        PlacedQuadric quadric{quadric_shape(kind, quadric_half_axes(regime, random)),
                              {quadric_linear(regime, random), {}}};
        quadric.pose.offset = random.between(0, 10) * quadric_direction(random);
        const PosedHalfSpace below(reached_into(quadric, random));
        const Distance found = distance(posed(quadric), below), exchanged = distance(below, posed(quadric));
        ASSERT_EQ(exchanged.on_b, found.on_a);
        if (found.upper > 0) continue;
        ++met;
        const std::string name = fmt::format("{}, {} {}", kind, regime, i);
        ASSERT_EQ(found.on_a, found.on_b) << name;
        const oracle::FineSet set = fine_set(quadric);
        const double off = 1e-12 * greatest_coordinate(set, quadric.pose.offset);
        EXPECT_LE(height_above(below, found.on_a), off) << name;
        const auto from_shape = oracle::fine_nearness(set, oracle::hull_set_of({found.on_a}, 0), 0.5, 200);
        EXPECT_TRUE(from_shape.meet || from_shape.upper <= off) << name << " " << from_shape.upper;
      }
  EXPECT_GT(met, fewer_under_tsan(600));
}

}  // namespace
}  // namespace toccata::test
