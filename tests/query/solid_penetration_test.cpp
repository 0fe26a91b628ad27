#include "toccata/query/penetration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "support/simd_levels.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/contacts.hpp"

// The depth of two solid meshes: the bracket holds, it is narrow for the listed pairs, and it does not depend on how it
// was asked for.
namespace toccata {
namespace {

Model prism_over(std::vector<Vec2> outline, double height) { return Model(extruded_mesh(outline, height)); }

Model corner_piece() { return prism_over({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 1); }

Model channel() { return prism_over({{-2, -1}, {2, -1}, {2, 2}, {1, 2}, {1, 0}, {-1, 0}, {-1, 2}, {-2, 2}}, 4); }

/// With a square hole of edge 1, and a slit to it.
Model plate() {
  const std::vector<Vec2> outline = {{-2, -2},    {2, -2},    {2, 2},      {-2, 2},      {-2, 0.0001}, {-0.5, 0.0001},
                                     {-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}, {-0.5, -0.5}, {-0.5, 0},    {-2, 0}};
  return prism_over(outline, 0.5);
}

struct DepthCase {
  std::string name;
  Model a;
  Model b;
  PairQuery query;
  double most_ratio = 1.5;
};

Pose turned(const Vec3& axis, double degrees, const Vec3& offset) { return {rotation_about(axis, degrees), offset}; }

/// The list of docs/methods/penetration.md.
std::vector<DepthCase> listed_cases() {
  const Model box(box_mesh({1, 1, 1})), ball(icosphere_mesh(1, 2)), torus(torus_mesh({})), gear(gear_mesh({}));
  const Model bumpy(noise_sphere_mesh({.subdivisions = 2}));
  const Pose slanted = turned({1, 2, 3}, 40, {1.75, 0.5, 0.25});
  return {
      {"boxes", box, box, {.pose_b = Pose::translation(1.75, 0.5, 0.25)}, 1 + 1e-9},
      {"slanted boxes", box, box, {.pose_b = slanted}, 1 + 1e-9},
      {"balls", ball, ball, {.pose_b = Pose::translation(1.5, 0.5, 0.25)}, 1 + 1e-9},
      {"slanted balls", ball, ball, {.pose_a = turned({3, 2, 1}, 17, {}), .pose_b = slanted}, 1 + 1e-9},
      {"box in a ball", ball, Model(box_mesh({0.2, 0.2, 0.2})), {.pose_b = Pose::translation(0.1, 0.2, 0.3)}},
      {"corner pieces", corner_piece(), corner_piece(), {.pose_b = Pose::translation(2.5, 0.25, 0.125)}},
      {"box in a channel", channel(), Model(box_mesh({0.9, 0.9, 0.9})), {.pose_b = Pose::translation(0, 0.8, 2)}},
      {"box too wide for a channel", channel(), Model(box_mesh({1.2, 1, 1})), {.pose_b = Pose::translation(0, 1.2, 2)}},
      {"peg too wide for its hole",
       plate(),
       Model(box_mesh({0.52, 0.52, 1})),
       {.pose_b = Pose::translation(0, 0, 0.3)}},
      {"tori", torus, torus, {.pose_b = Pose::translation(1.9, 0.5, 0.1)}},
      {"gears", gear, gear, {.pose_b = Pose::translation(1.95, 0, 0.02)}},
      {"bumpy balls", bumpy, bumpy, {.pose_b = turned({1, 2, 3}, 40, {1.7, 0.3, 0.2})}},
      {"torus and sphere", torus, Sphere(0.3), {.pose_b = Pose::translation(1.1, 0, 0.3)}},
      {"gear and rod", gear, Box({0.05, 0.05, 3}), {.pose_b = turned({1, 2, 3}, 6, {0.5, 0.1, 0.1})}},
      {"gear and ground", gear, HalfSpace({0, 0, 0.1}, {0, 0, 1}), {}, 1 + 1e-9}};
}

PairQuery moved(PairQuery query, const Vec3& by) {
  query.pose_b.offset = query.pose_b.offset + by;
  return query;
}

Vec3 random_direction(Random& random) {
  for (;;) {
    const Vec3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (const double length = std::sqrt(dot(v, v)); length > 0.1 && length < 1) return (1 / length) * v;
  }
}

void PrintTo(const DepthCase& listed, std::ostream* out) { *out << listed.name; }

class SolidPenetration : public testing::TestWithParam<DepthCase> {};

TEST_P(SolidPenetration, IsABracketThatIsNarrow) {
  const DepthCase& c = GetParam();
  const Penetration p = penetration(c.a, c.b, c.query);
  EXPECT_GT(p.lower, 0);
  EXPECT_LE(p.upper, c.most_ratio * p.lower) << "lower " << p.lower << ", upper " << p.upper;
  RecordProperty("ratio", std::to_string(p.upper / p.lower));
  EXPECT_NE(relation(c.a, c.b, moved(c.query, p.upper * p.direction)).kind, RelationKind::overlapping);
  constexpr std::uint64_t seed = 20261121;
  Random random(seed);
  for (int i = 0; i < 12; ++i) {
    const Vec3 way = (i % 2 == 0 ? 0.999 : random.between(0, 1)) * p.lower * random_direction(random);
    EXPECT_EQ(relation(c.a, c.b, moved(c.query, way)).kind, RelationKind::overlapping) << "seed " << seed << ", " << i;
  }
}

TEST_P(SolidPenetration, IsTheSameTheOtherWayRound) {
  const DepthCase& c = GetParam();
  const Penetration p = penetration(c.a, c.b, c.query);
  EXPECT_EQ(flipped(p), penetration(c.b, c.a, {.pose_a = c.query.pose_b, .pose_b = c.query.pose_a}));
}

INSTANTIATE_TEST_SUITE_P(Listed, SolidPenetration, testing::ValuesIn(listed_cases()), [](const auto& listed) {
  std::string name = listed.param.name;
  std::erase(name, ' ');
  return name;
});

TEST(SolidPenetrations, OfMeshesAreKnownDepths) {
  const Model big(box_mesh({2, 2, 2})), small(box_mesh({0.5, 0.5, 0.5}));
  const Penetration nested = penetration(big, small, {.pose_b = Pose::translation(0.25, 0, 0)});
  EXPECT_LE(nested.lower, 2.25);
  EXPECT_NEAR(nested.upper, 2.25, 1e-9) << "the small one leaves through the nearest side";
  const Penetration in_channel =
      penetration(channel(), Model(box_mesh({0.9, 0.9, 0.9})), {.pose_b = Pose::translation(0, 0.8, 2)});
  EXPECT_NEAR(in_channel.upper, 0.1, 1e-9);
  EXPECT_NEAR(in_channel.lower, 0.1, 1e-9);
  EXPECT_NEAR(in_channel.direction.y, 1, 1e-9);
  const Vec3 apart = in_channel.on_a - in_channel.on_b;
  EXPECT_NEAR(std::sqrt(dot(apart, apart)), 0.1, 1e-9) << "the points are the depth apart";
}

TEST(SolidPenetrations, OfSolidsThatDoNotOverlapAreZero) {
  const Model box(box_mesh({1, 1, 1})), gear(gear_mesh({}));
  for (const auto& [a, b, x] : {std::tuple(box, box, 2.0), {box, box, 3.0}, {gear, gear, 4.0}}) {
    const Penetration p = penetration(a, b, {.pose_b = Pose::translation(x, 0, 0)});
    EXPECT_EQ(p.lower, 0);
    EXPECT_EQ(p.upper, 0);
    EXPECT_NEAR(dot(p.direction, p.direction), 1, 1e-12);
  }
}

TEST(SolidPenetrations, OfSolidsApartHaveTheWayBetweenThemAtAnySize) {
  for (const double size : {1e-170, 1e-100, 1.0, 1e100, 1e160}) {
    const Model box(box_mesh({size, size, size}));
    const Penetration p = penetration(box, box, {.pose_b = Pose::translation(4 * size, 0, 0)});
    EXPECT_NEAR(std::abs(p.direction.x), 1, 1e-12) << size;
  }
}

TEST(SolidPenetrations, OfManyPosesAndThreadsAreTheSame) {
  const Model gear(gear_mesh({})), box(box_mesh({0.25, 0.25, 0.25}));
  std::vector<PairQuery> queries;
  for (const double x : {1.0625, 1.125, 5.0}) queries.push_back({.pose_b = Pose::translation(x, 0.125, 0.25)});
  std::vector<Penetration> single;
  for (const PairQuery& query : queries) single.push_back(penetration(gear, box, query));
  EXPECT_EQ(penetration_each({gear, box, queries}, {.threads = 1}), single);
  EXPECT_EQ(penetration_each({gear, box, queries}, {.threads = 3}), single);
  test::at_every_simd_level([&](SimdLevel) { EXPECT_EQ(penetration(gear, box, queries[1]), single[1]); });
}

TEST(SolidPenetrations, OfCompoundsHaveABracket) {
  const std::vector<CompoundPart> parts = {{Box({2, 0.5, 0.5}), {}}, {Box({0.5, 2, 0.5}), {}}};
  const Model cross(Compound{parts}), ball(Sphere(0.5));
  const Penetration p = penetration(cross, ball, {.pose_b = Pose::translation(1.5, 0.75, 0)});
  EXPECT_LE(p.lower, 0.25);
  EXPECT_GE(p.upper, 0.25 - 1e-12);
  EXPECT_LE(p.upper, 1.5 * p.lower);
  const std::vector<CompoundPart> endless = {{HalfSpace({}, {0, 0, 1}), {}}, {Box({0.5, 2, 0.5}), {}}};
  EXPECT_THROW(static_cast<void>(penetration(Model(Compound{endless}), ball)), Error);
}

}  // namespace
}  // namespace toccata
