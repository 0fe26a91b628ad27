#include "narrow/primitives/closed_forms.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "narrow/primitives/pair_distances.hpp"
#include "narrow/typed_forms.hpp"
#include "oracle/convex.hpp"
#include "support/convex_cases.hpp"
#include "support/fewer_cases.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/simd.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/methods/sphere_ways.hpp"
#include "toccata/narrow/primitives.hpp"

namespace toccata {
namespace {

using test::ConvexCase;

const std::vector<std::string> simple_kinds = {"point", "segment", "triangle", "sphere", "box", "capsule"};

TEST(ClosedForms, AreRightOrSilentInEveryRegime) {
  std::uint64_t number = 0, silent = 0, asked = 0, far_silent = 0, far_asked = 0;
  for (const std::string& kind_a : simple_kinds)
    for (const std::string& kind_b : simple_kinds)
      for (const std::string& regime : test::convex_regimes())
        for (int round = 0; round < test::fewer_under_tsan(10); ++round) {
          Random random(++number);
          const ConvexCase pair = test::convex_case(kind_a, kind_b, regime, random);
          SCOPED_TRACE(fmt::format("{} and {}, {}, seed {}", kind_a, kind_b, regime, number));
          const bool meet = oracle::overlap(test::set_of(pair.a), test::set_of(pair.b));
          const Nearness found = nearness_by_formula(test::posed(pair.a), test::posed(pair.b));
          if (found != Nearness::unknown) {
            ASSERT_EQ(found == Nearness::meet, meet) << to_text(pair);
          }
          const auto typed = test::typed_answers(pair);
          const Distance generic = distance(test::posed(pair.a), test::posed(pair.b));
          const bool by_formula = is_known(distance_of_primitives(test::posed(pair.a), test::posed(pair.b)));
          if (typed) {
            ASSERT_EQ(typed->overlap, meet) << to_text(pair);
            ASSERT_TRUE(test::same_answer(typed->distance, generic, by_formula)) << to_text(pair);
          }
          const bool common = regime == "far" || regime == "near" || regime == "deep";
          if (common && typed && kind_a == "sphere") {
            far_asked += 1, far_silent += by_formula ? 0 : 1;
          }
          if (common && typed && kind_a == "sphere") asked += 1, silent += found == Nearness::unknown ? 1 : 0;
        }
  EXPECT_LT(silent * 50, asked) << silent << " of " << asked;
  EXPECT_LT(far_silent * 8, far_asked) << far_silent << " of " << far_asked;
}

// --- sphere and triangle, each of the lecture's ways

using SphereTriangleTest = bool (*)(const PosedSphere&, const Triangle&);
constexpr std::array<SphereTriangleTest, 4> ways = {overlap_by_plane_projection, overlap_by_features,
                                                    overlap_by_minimisation, overlap_by_voronoi_regions};

struct SphereTriangleCase {
  PosedSphere sphere;
  Triangle triangle;
};

Vec3 random_vector(Random& random, bool coarse) {
  const auto coordinate = [&] { return coarse ? static_cast<double>(random.below(7)) - 3 : random.between(-1, 1); };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  return {x, y, z};
}

/// Coarse ones touch often; of the fine ones many nearly touch, and some are needles, huge, tiny or far away.
SphereTriangleCase random_sphere_triangle(Random& random) {
  const bool coarse = random.below(3) == 0;
  SphereTriangleCase result;
  for (Vec3& v : result.triangle.vertex) v = random_vector(random, coarse);
  if (random.below(8) == 0) result.triangle[2] = result.triangle[random.below(2) == 0 ? 0 : 1];
  if (random.below(8) == 0) result.triangle[2] = result.triangle[0] + 1e-9 * result.triangle[2];
  const Vec3 centre = (coarse ? 1.0 : 2.0) * random_vector(random, coarse);
  double radius = coarse ? static_cast<double>(1 + random.below(4)) : random.between(0.1, 2);
  if (!coarse && random.below(2) == 0) {
    const PosedSphere point(centre, 1e-300);
    radius = distance(point, result.triangle).upper;
    if (!(radius > 0)) radius = 1;
    if (random.below(2) == 0) radius = std::nextafter(radius, 0);
  }
  const double scale = random.below(4) == 0 ? std::ldexp(1.0, static_cast<int>(random.below(1200)) - 600) : 1;
  const Vec3 offset = random.below(4) == 0 ? 1e6 * random_vector(random, coarse) : Vec3{};
  for (Vec3& v : result.triangle.vertex) v = scale * (v + offset);
  result.sphere = PosedSphere(scale * (centre + offset), scale * radius);
  return result;
}

TEST(SphereTriangle, EveryWayAgreesWithTheOracle) {
  for (std::uint64_t seed = 0; seed < test::fewer_under_tsan(3000U); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto [sphere, triangle] = random_sphere_triangle(random);
    const bool meet = oracle::overlap(oracle::sphere_set(sphere.centre, sphere.radius),
                                      oracle::triangle_set(triangle[0], triangle[1], triangle[2]));
    ASSERT_EQ(overlap(sphere, triangle), meet);
    for (const SphereTriangleTest way : ways) ASSERT_EQ(way(sphere, triangle), meet) << (&way - ways.data());
    ASSERT_FALSE(meet && plane_rejects(sphere, triangle));
  }
}

const Triangle in_the_floor{{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}}};

TEST(SphereTriangle, ThePlaneEliminatesSpheresThatDoNotReachItAndNoOthers) {
  EXPECT_TRUE(plane_rejects({{1, 1, 2.5}, 2}, in_the_floor));
  EXPECT_FALSE(plane_rejects({{1, 1, 2}, 2}, in_the_floor));  // touches it
  const PosedSphere beside({9, 9, 0}, 2);                     // reaches the plane and not the triangle
  EXPECT_FALSE(plane_rejects(beside, in_the_floor));
  EXPECT_FALSE(overlap(beside, in_the_floor));
}

TEST(SphereTriangle, TestingTheEdgesIsNotEnough) {
  // Above the middle of the face, nearer than any edge: the face has to be tested.
  const PosedSphere above({1, 1, 0.5}, 0.6);
  for (const SphereTriangleTest way : ways) EXPECT_TRUE(way(above, in_the_floor));
  for (int i = 0; i < 3; ++i) {
    const Segment edge(in_the_floor[i], in_the_floor[(i + 1) % 3]);
    EXPECT_FALSE(overlap(PosedPolytope(Sphere(above.radius, above.centre)), PosedPolytope(edge)));
  }
  // Before a vertex, beside the lines of both edges: the feet on these are outside the edges, so the vertex counts.
  const PosedSphere at_vertex({-1, -1, 0}, 1.5);
  for (const SphereTriangleTest way : ways) EXPECT_TRUE(way(at_vertex, in_the_floor));
}

// --- sphere and box

TEST(SphereBox, BothWaysAgreeWithTheOracle) {
  std::array<int, 64> seen{};
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const bool coarse = seed % 2 == 0;
    const double scale = random.below(4) == 0 ? std::ldexp(1.0, static_cast<int>(random.below(1200)) - 600) : 1;
    const Vec3 size = random_vector(random, coarse), centre = scale * random_vector(random, coarse);
    const Vec3 upper = 0.5 * scale * Vec3{std::fabs(size.x), std::fabs(size.y), std::fabs(size.z)}, lower = -upper;
    const double radius = scale * (coarse ? static_cast<double>(1 + random.below(5)) / 2 : random.between(0.1, 1.5));
    const PosedSphere sphere(centre, radius);
    std::vector<Vec3> corners;
    for (unsigned i = 0; i < 8; ++i)
      corners.push_back({i & 1U ? upper.x : lower.x, i & 2U ? upper.y : lower.y, i & 4U ? upper.z : lower.z});
    const bool meet = oracle::overlap(oracle::sphere_set(centre, radius), oracle::box_set(corners));
    ASSERT_EQ(overlap_by_regions(sphere, lower, upper), meet);
    ASSERT_EQ(overlap_by_clamping(sphere, lower, upper), meet);
    ++seen[box_region(centre, lower, upper)];
  }
  EXPECT_EQ(std::ranges::count_if(seen, [](int count) { return count > 0; }), 27);
}

TEST(SphereBox, OneBitOfTheSixImpliesAnother) {
  const Vec3 lower{-1, -1, -1}, upper{1, 1, 1};
  EXPECT_EQ(box_region({0, 0, 0}, lower, upper), 0U);
  EXPECT_EQ(box_region({-1, 1, 1}, lower, upper), 0U);  // on a face is inside
  EXPECT_EQ(box_region({-2, 0, 0}, lower, upper), 1U);
  EXPECT_EQ(box_region({2, -2, 0}, lower, upper), 2U | 4U);
  EXPECT_EQ(box_region({2, -2, 5}, lower, upper), 2U | 4U | 32U);
}

// --- spheres, planes, capsules

TEST(SphereSphere, SquaresDecideWhereRootsCannot) {
  // 3-4-5 and its neighbours: the root of the rounded square is 5 for one that is apart.
  const PosedSphere a({0, 0, 0}, 2), touching({3, 4, 0}, 3);
  const PosedSphere apart({std::nextafter(3, 4), 4, 0}, 3), deep({std::nextafter(3, 2), 4, 0}, 3);
  EXPECT_TRUE(overlap(a, touching));
  EXPECT_FALSE(overlap(a, apart));
  EXPECT_TRUE(overlap(a, deep));
  EXPECT_EQ(std::sqrt(apart.centre.x * apart.centre.x + 16), 5);
}

TEST(SphereSphere, TheNearestPointsLieOnTheLineOfTheCentres) {
  const Distance d = distance(PosedSphere({0, 0, 0}, 1), PosedSphere({6, 8, 0}, 4));
  EXPECT_LE(d.lower, 5);
  EXPECT_GE(d.upper, 5);
  EXPECT_LE(d.upper - d.lower, 5e-12);
  const auto is_near = [](const Vec3& p, const Vec3& q) { return dot(p - q, p - q) <= 1e-24; };
  EXPECT_TRUE(is_near(d.on_a, {0.6, 0.8, 0}));
  EXPECT_TRUE(is_near(d.on_b, {3.6, 4.8, 0}));
}

TEST(SpherePlane, TouchesExactlyAndFromBothSides) {
  const Plane plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  for (const double side : {1.0, -1.0}) {
    EXPECT_TRUE(overlap(PosedSphere({5, 5, side * 3}, 3), plane));
    EXPECT_FALSE(overlap(PosedSphere({5, 5, side * std::nextafter(3, 4)}, 3), plane));
  }
  // A plane whose normal's length is no double: x + y + z = 0, and a sphere at distance √3 of radius √3, rounded.
  const Plane slanted({1, -1, 0}, {0, 1, -1}, {-1, 0, 1});
  const double root = std::sqrt(3);  // is less than √3
  EXPECT_FALSE(overlap(PosedSphere({1, 1, 1}, root), slanted));
  EXPECT_TRUE(overlap(PosedSphere({1, 1, 1}, std::nextafter(root, 2)), slanted));
}

TEST(SpherePlane, NearestPointsLieOnTheWayStraightDown) {
  const Plane plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  for (const double side : {1.0, -1.0}) {
    const Distance found = distance(PosedSphere({5, 7, side * 3}, 2), plane);
    EXPECT_EQ(found.lower, 1);
    EXPECT_EQ(found.upper, 1);
    EXPECT_EQ(found.on_a, (Vec3{5, 7, side}));
    EXPECT_EQ(found.on_b, (Vec3{5, 7, 0}));
  }
  EXPECT_EQ(distance(PosedSphere({5, 7, 1}, 2), plane).on_a, (Vec3{5, 7, 0}));  // reaches through
  // √3 is no double: the two around it.
  const Plane slanted({1, -1, 0}, {0, 1, -1}, {-1, 0, 1});
  const Distance root = distance(PosedSphere({1, 1, 1}, 0), slanted);
  EXPECT_EQ(root.lower, std::sqrt(3));
  EXPECT_EQ(root.upper, std::nextafter(std::sqrt(3), 2));
  EXPECT_EQ(root.on_b, Vec3{});
}

/// Against the least height of a vertex, exactly; planes and shapes coarse and fine.
TEST(ConvexPlane, DistanceIsTheLeastHeightOverTheNormalsLength) {
  int apart = 0, together = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto number = [&] {
      return seed % 2 == 0 ? static_cast<double>(random.below(9)) - 4 : random.between(-4, 4);
    };
    const auto point = [&] {
      const double x = number(), y = number(), z = number();
      return Vec3{x, y, z};
    };
    const Vec3 a = point(), b = point(), c = point();
    const std::vector<Vec3> vertices{point(), point(), point(), point(), point()};
    if (cross(b - a, c - a) == Vec3{}) continue;
    const ConvexHull hull(vertices);
    const PosedPolytope shape(hull);
    const Distance found = distance(shape, Plane(a, b, c));
    const oracle::RationalPoint at = oracle::exact(a);
    const oracle::RationalPoint n = oracle::cross(oracle::exact(b) - at, oracle::exact(c) - at);
    std::vector<oracle::Rational> heights;
    for (const Vec3& v : vertices) heights.push_back(oracle::dot(n, oracle::exact(v) - at));
    const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
    const bool meets = *least <= 0 && *most >= 0;
    ASSERT_EQ(found.upper == 0, meets);
    ++(meets ? together : apart);
    const double height_of_b = oracle::dot(n, oracle::exact(found.on_b) - at).to_double();
    EXPECT_NEAR(height_of_b / std::sqrt(oracle::dot(n, n).to_double()), 0, 1e-13);
    if (meets) continue;
    const oracle::Rational height = *least > 0 ? *least : *most, squared = oracle::dot(n, n);
    const oracle::Rational lower = oracle::exact(found.lower), upper = oracle::exact(found.upper);
    EXPECT_LE(lower * lower * squared, height * height);
    EXPECT_GE(upper * upper * squared, height * height);
    EXPECT_LE(found.upper, std::nextafter(found.lower, HUGE_VAL));
    EXPECT_EQ(oracle::dot(n, oracle::exact(found.on_a) - at), height);
  }
  EXPECT_GT(apart, 20);
  EXPECT_GT(together, 20);
}

TEST(TrianglePlane, IsCutWhenItsVerticesLieOnBothSides) {
  const Plane plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_TRUE(overlap(PosedPolytope(Triangle{{Vec3{0, 0, 1}, Vec3{1, 0, -1e-300}, Vec3{0, 1, 1}}}), plane));
  EXPECT_FALSE(overlap(PosedPolytope(Triangle{{Vec3{0, 0, 1}, Vec3{1, 0, 1e-300}, Vec3{0, 1, 1}}}), plane));
  EXPECT_TRUE(overlap(PosedPolytope(Triangle{{Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 1}}}), plane));
}

TEST(CapsuleCapsule, ParallelCrossedAndPointLike) {
  const PosedCapsule along_x({-1, 0, 0}, {1, 0, 0}, 0.5);
  EXPECT_TRUE(overlap(along_x, PosedCapsule({-3, 1, 0}, {3, 1, 0}, 0.5)));
  EXPECT_FALSE(overlap(along_x, PosedCapsule({-3, std::nextafter(1, 2), 0}, {3, std::nextafter(1, 2), 0}, 0.5)));
  EXPECT_TRUE(overlap(along_x, PosedCapsule({0, -1, 1}, {0, 1, 1}, 0.5)));
  EXPECT_TRUE(overlap(along_x, PosedCapsule({2, 0, 0}, {2, 0, 0}, 0.5)));
  EXPECT_FALSE(overlap(along_x, PosedCapsule({2, 1e-7, 0}, {2, 1e-7, 0}, 0.5)));
  EXPECT_TRUE(overlap(PosedCapsule({5, 5, 5}, {5, 5, 5}, 1), PosedCapsule({5, 5, 7}, {5, 5, 7}, 1)));
}

TEST(PosedShapes, BadOnesAreRefused) {
  const Pose stretching{Mat3{{Vec3{2, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, {}};
  EXPECT_THROW(PosedSphere(Sphere(1), stretching), Error);
  EXPECT_THROW(PosedCapsule(Capsule({0, 0, 0}, {1, 0, 0}, 1), stretching), Error);
  EXPECT_NO_THROW(PosedBox(Box({1, 1, 1}), stretching));
  EXPECT_THROW(PosedBox(Box({1, 1, 1}), Pose{Mat3{{Vec3{}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, {}}), Error);
  EXPECT_THROW(PosedBox(Box({1e308, 1, 1}), stretching), Error);
  EXPECT_THROW(PosedSphere(Sphere(1), Pose::translation(HUGE_VAL, 0, 0)), Error);
}

// --- shapes and poses given

const std::vector<std::pair<std::string, std::string>> pairs_of_given = {
    {"sphere", "sphere"}, {"sphere", "triangle"}, {"sphere", "box"}, {"sphere", "capsule"}, {"capsule", "capsule"}};

TEST(ShapesAndPoses, AnswerAsPosedOnesAtEveryLevel) {
  const SimdLevel before = simd_level();
  for (const SimdLevel level : simd_levels()) {
    use_simd_level(level);
    std::uint64_t seed = 0;
    for (const auto& [kind_a, kind_b] : pairs_of_given)
      for (const std::string& regime : test::convex_regimes())
        for (int round = 0; round < test::fewer_under_tsan(20); ++round) {
          Random random(++seed);
          const ConvexCase pair = test::convex_case(kind_a, kind_b, regime, random);
          SCOPED_TRACE(std::string(name_of(level)) + ", seed " + std::to_string(seed) + ", " + to_text(pair));
          const auto given = test::answers_of_given(pair), typed = test::typed_answers(pair);
          ASSERT_TRUE(given && typed);
          ASSERT_EQ(given->overlap, overlap(test::posed(pair.a), test::posed(pair.b)));
          const bool by_formula = is_known(distance_of_primitives(test::posed(pair.a), test::posed(pair.b)));
          ASSERT_TRUE(test::same_answer(given->distance, typed->distance, by_formula));
        }
  }
  use_simd_level(before);
}

template <class Question>
std::string message_of(const Question& question) {
  try {
    static_cast<void>(question());
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// What overlap says, if distance says the same.
template <class A, class B>
std::string refusal(const A& a, const Pose& pose_a, const B& b, const Pose& pose_b) {
  std::string message = message_of([&] { return overlap(a, pose_a, b, pose_b); });
  EXPECT_EQ(message_of([&] { return distance(a, pose_a, b, pose_b); }), message);
  return message;
}

TEST(ShapesAndPoses, BadOnesAreRefused) {
  const Pose stretching{Mat3{{Vec3{2, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, {}};
  const Pose lost = Pose::translation(std::nan(""), 0, 0), endless = Pose::translation(0, HUGE_VAL, 0);
  const Sphere ball(1);
  const Box box({1, 1, 1});
  const Capsule capsule({0, 0, -1}, {0, 0, 1}, 1);
  const Triangle triangle{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}};
  for (const Pose& bad : {stretching, lost, endless}) {
    const std::string of_ball = message_of([&] { return PosedSphere(ball, bad); });
    ASSERT_NE(of_ball, "");
    EXPECT_EQ(refusal(ball, bad, ball, {}), of_ball);
    EXPECT_EQ(refusal(ball, {}, ball, bad), of_ball);
    EXPECT_EQ(refusal(ball, bad, box, {}), of_ball);
    EXPECT_EQ(refusal(ball, bad, triangle, {}), of_ball);
    EXPECT_EQ(refusal(ball, bad, capsule, {}), of_ball);
    const std::string of_capsule = message_of([&] { return PosedCapsule(capsule, bad); });
    EXPECT_EQ(refusal(ball, {}, capsule, bad), of_capsule);
    EXPECT_EQ(refusal(capsule, bad, capsule, {}), of_capsule);
    EXPECT_EQ(refusal(capsule, {}, capsule, bad), of_capsule);
  }
  for (const Pose& bad : {lost, endless}) {
    EXPECT_EQ(refusal(ball, {}, box, bad), message_of([&] { return PosedBox(box, bad); }));
    EXPECT_EQ(refusal(ball, {}, triangle, bad), message_of([&] { return PosedPolytope(triangle, bad); }));
  }
  // A box may be stretched, but not flattened, and no corner may be beyond all numbers.
  EXPECT_TRUE(overlap(ball, Pose::translation(3, 0, 0), box, stretching));
  EXPECT_FALSE(overlap(ball, Pose::translation(std::nextafter(3, 4), 0, 0), box, stretching));
  EXPECT_NE(refusal(ball, {}, box, Pose{Mat3{{Vec3{}, Vec3{}, Vec3{}}}, {}}), "");
  EXPECT_NE(refusal(ball, {}, Box({1e308, 1, 1}), Pose::translation(1.7e308, 0, 0)), "");
}

}  // namespace
}  // namespace toccata
