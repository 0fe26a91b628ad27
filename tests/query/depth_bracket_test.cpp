#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/error_message.hpp"
#include "support/simd_levels.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/relation.hpp"

// Depths as narrow as asked, and no narrower: the bracket holds whatever was asked, and says why it ended.
namespace toccata {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

PairQuery pushed(PairQuery query, const Vec3& by) {
  query.pose_b.offset = query.pose_b.offset + by;
  return query;
}

Vec3 any_direction(Random& random) {
  for (;;) {
    const Vec3 v{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (const double length = std::sqrt(dot(v, v)); length > 0.1 && length < 1) return (1 / length) * v;
  }
}

bool overlaps_after(const Model& a, const Model& b, const PairQuery& query, const Vec3& move) {
  return relation(a, b, pushed(query, move)).kind == RelationKind::overlapping;
}

/// The way out parts them, and shorter ways do not.
void expect_holds(const Model& a, const Model& b, const PairQuery& query, const Penetration& p) {
  EXPECT_LE(p.lower, p.upper);
  EXPECT_FALSE(overlaps_after(a, b, query, p.upper * p.direction));
  Random random(20261128);
  for (int i = 0; i < 12; ++i) {
    const Vec3 way = i == 0 ? p.direction : any_direction(random);
    EXPECT_TRUE(overlaps_after(a, b, query, 0.9999 * p.lower * way)) << i;
  }
}

struct Deep {
  std::string name;
  Model a;
  Model b;
  PairQuery query;
};

/// B turned, and as far along x as leaves them so deep.
PairQuery touching_but_for(const Model& a, const Model& b, double depth, const Mat3& turn) {
  double meeting = 0, apart = 16;
  for (int i = 0; i < 50; ++i) {
    const double middle = (meeting + apart) / 2;
    (relation(a, b, {.pose_b = {turn, {middle, 0.1, 0.05}}}).kind == RelationKind::apart ? apart : meeting) = middle;
  }
  return {.pose_b = {turn, {meeting - depth, 0.1, 0.05}}};
}

std::vector<Deep> solids_that_meet_in_one_place() {
  const Model bumpy(noise_sphere_mesh({.subdivisions = 3})), ring(torus_mesh({.around = 48, .sides = 24}));
  const Model ball(icosphere_mesh(1, 3)), marble(Sphere(0.3)), pill(Capsule({0, -0.2, 0}, {0, 0.2, 0}, 0.2));
  const Mat3 turn = rotation_about({1, 2, 3}, 40);
  std::vector<Deep> cases;
  for (const double depth : {0.01, 0.05})
    for (const auto& [name, a, b] : {std::tuple{"bumpy balls", bumpy, bumpy},
                                     {"bumpy ball and ring", bumpy, ring},
                                     {"balls", ball, ball},
                                     {"bumpy ball and marble", bumpy, marble},
                                     {"ring and pill", ring, pill},
                                     {"bumpy ball and pill", bumpy, pill}})
      cases.push_back({name, a, b, touching_but_for(a, b, depth, turn)});
  return cases;
}

TEST(DepthBracket, OfSolidsThatMeetInOnePlaceIsAsNarrowAsAskedAndHolds) {
  for (const Deep& deep : solids_that_meet_in_one_place()) {
    SCOPED_TRACE(deep.name);
    const DepthBracket found = depth_bracket(deep.a, deep.b, deep.query, {.precision = 0.1});
    EXPECT_EQ(found.end, DepthEnd::precise);
    EXPECT_LE(found.penetration.upper, 1.1 * found.penetration.lower);
    expect_holds(deep.a, deep.b, deep.query, found.penetration);
    const DepthBracket other =
        depth_bracket(deep.b, deep.a, {.pose_a = deep.query.pose_b, .pose_b = deep.query.pose_a}, {.precision = 0.1});
    EXPECT_EQ(flipped(other.penetration), found.penetration);
  }
}

TEST(DepthBracket, OfConvexMeshesHoldsTheDepthOfTheirHulls) {
  Random random(7);
  const TriangleMesh ball = icosphere_mesh(1, 3), can = prism_mesh(0.7, 2, 300);
  for (int i = 0; i < 6; ++i) {
    const TriangleMesh& mesh = i % 2 == 0 ? ball : can;
    const PairQuery query{.pose_b = {rotation_about(any_direction(random), random.between(0, 360)),
                                     random.between(0.6, 1.4) * any_direction(random)}};
    const ConvexHull hull_a{transform(query.pose_a, ball.vertices())}, hull_b{transform(query.pose_b, mesh.vertices())};
    const Penetration truth = penetration(PosedPolytope(hull_a), PosedPolytope(hull_b));
    const DepthBracket found = depth_bracket(Model(ball), Model(mesh), query, {.precision = 0.1});
    EXPECT_EQ(found.end, DepthEnd::precise);
    EXPECT_LE(found.penetration.lower, truth.upper);
    EXPECT_GE(found.penetration.upper, truth.lower);
    EXPECT_LE(found.penetration.upper, 1.1 * found.penetration.lower);
  }
}

TEST(DepthBracket, OfBoxesIsTheirDepthAtAnyPrecision) {
  const Model box(box_mesh({1, 1, 1}));
  for (const double precision : {1e-6, 0.1, 3.0, 1e300}) {
    const DepthBracket found = depth_bracket(box, box, {.pose_b = Pose::translation(1.75, 0.5, 0.25)}, {precision});
    EXPECT_NEAR(found.penetration.lower, 0.25, 1e-9);
    EXPECT_NEAR(found.penetration.upper, 0.25, 1e-9);
    EXPECT_EQ(found.end, DepthEnd::precise);
  }
}

// The middle of the ball lies outside of the mesh, whose shape has to be known around the contact alone.
TEST(DepthBracket, OfABallThatDipsIntoABumpyMeshIsThatOfItsDip) {
  const Model bumpy(noise_sphere_mesh({.subdivisions = 3}));
  Random random(5);
  for (int i = 0; i < 4; ++i) {
    const Mat3 turn = rotation_about(any_direction(random), random.between(0, 360));
    const Model ball(Sphere(0.3));
    const PairQuery query = touching_but_for(bumpy, ball, 0.03, turn);
    for (const double precision : {0.02, 0.1}) {
      const DepthBracket found = depth_bracket(bumpy, ball, query, {precision});
      EXPECT_EQ(found.end, DepthEnd::precise) << precision;
      EXPECT_LE(found.penetration.upper, 0.0301) << "the way that it came is out";
      EXPECT_LE(found.penetration.upper, (1 + precision) * found.penetration.lower);
      expect_holds(bumpy, ball, query, found.penetration);
    }
  }
}

TEST(DepthBracket, HoldsWhereItIsNotMetAndSaysSo) {
  const std::vector<Vec2> outline = {{-2, -1}, {2, -1}, {2, 2}, {1, 2}, {1, 0}, {-1, 0}, {-1, 2}, {-2, 2}};
  const Model channel(extruded_mesh(outline, 4)), crate(box_mesh({1.2, 1, 1}));  // too wide for it
  const PairQuery query{.pose_b = Pose::translation(0, 1.2, 2)};
  const DepthBracket narrow = depth_bracket(channel, crate, query, {.precision = 1e-9});
  EXPECT_EQ(narrow.end, DepthEnd::exhausted);
  expect_holds(channel, crate, query, narrow.penetration);
  const DepthBracket hurried = depth_bracket(channel, crate, query, {.precision = 1e-9, .time_limit = 1e-9});
  EXPECT_EQ(hurried.end, DepthEnd::out_of_time);
  expect_holds(channel, crate, query, hurried.penetration);
  EXPECT_LE(hurried.penetration.lower, narrow.penetration.upper);
  EXPECT_GE(hurried.penetration.upper, narrow.penetration.lower);
}

TEST(DepthBracket, OfWhatDoesNotOverlapIsZero) {
  const Model ball(icosphere_mesh(1, 3));
  const DepthBracket found = depth_bracket(ball, ball, {.pose_b = Pose::translation(3, 0, 0)}, {.precision = 0.1});
  EXPECT_EQ(found.penetration.upper, 0);
  EXPECT_EQ(found.end, DepthEnd::precise);
}

TEST(DepthBracket, IsTheSameAtEverySimdLevelAndForAnyThreads) {
  const Model bumpy(noise_sphere_mesh({.subdivisions = 3}));
  std::vector<PairQuery> queries;
  for (int i = 0; i < 4; ++i) queries.push_back({.pose_b = Pose::translation(1.7 + 0.02 * i, 0.3, 0.2)});
  const DepthOptions options{.precision = 0.1};
  const auto expected = depth_bracket_each({bumpy, bumpy, queries}, options, {.threads = 1});
  test::at_every_simd_level([&](SimdLevel level) {
    EXPECT_EQ(depth_bracket_each({bumpy, bumpy, queries}, options, {.threads = 2}), expected) << name_of(level);
    EXPECT_EQ(depth_bracket(bumpy, bumpy, queries[1], options), expected[1]) << name_of(level);
  });
}

TEST(DepthBracket, RefusesAPrecisionOrATimeLimitThatIsNone) {
  const Model box(box_mesh({1, 1, 1}));
  for (const double bad : {0.0, -0.1, nan, std::numeric_limits<double>::infinity()}) {
    const std::string message =
        test::message_of([&] { static_cast<void>(depth_bracket(box, box, {}, {.precision = bad})); });
    EXPECT_NE(message.find("precision"), std::string::npos) << message;
  }
  for (const double bad : {0.0, -1.0, nan}) {
    const std::string message =
        test::message_of([&] { static_cast<void>(depth_bracket(box, box, {}, {.time_limit = bad})); });
    EXPECT_NE(message.find("time limit"), std::string::npos) << message;
  }
}

TEST(DepthBracket, OfAllPairsIsThatOfThePairAsAsked) {
  const Model bumpy(noise_sphere_mesh({.subdivisions = 3}));
  const std::vector<SceneInstance> models{{bumpy, {}}, {bumpy, Pose::translation(1.75, 0.3, 0.2)}};
  for (const double precision : {0.1, 0.02}) {
    CheckOptions options{.penetration = true};
    options.depth.precision = precision;
    const CheckAnswer answer = check_all(models, options);
    ASSERT_EQ(answer.pairs.size(), 1U);
    const DepthBracket alone = depth_bracket(bumpy, bumpy, {.pose_b = models[1].pose}, options.depth);
    EXPECT_EQ(answer.pairs[0].penetration, alone.penetration);
    EXPECT_EQ(answer.pairs[0].depth_end, alone.end);
  }
  EXPECT_EQ(CheckOptions{}.depth.precision, 0.1);
}

}  // namespace
}  // namespace toccata
