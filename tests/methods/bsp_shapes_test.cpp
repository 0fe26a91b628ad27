#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "methods/bsp_checks.hpp"
#include "oracle/test_meshes.hpp"
#include "support/error_message.hpp"
#include "toccata/methods/bsp_tree.hpp"
#include "toccata/query/casts.hpp"

namespace toccata {
namespace {

using namespace test;

/// A shape that stands somewhere and may move.
struct Question {
  PlacedPolytope placed;
  Vec3 motion;
};

/// About the mesh, as many in general places as on its points, lines and planes.
std::vector<Question> questions_about(const BspSubject& subject, std::size_t count, std::uint64_t seed) {
  const std::vector<Vec3> points = telling_points(subject.model, 64, seed);
  Random random(seed);
  const auto point = [&] { return points[random.below(points.size())]; };
  const double size = subject.size();
  std::vector<Question> questions;
  while (questions.size() < count) {
    questions.push_back({telling_placed(points, size, random), point() - point()});
    if (subject.name == "denormal") continue;
    questions.push_back(
        {random_placed(point() + random_vector(random, 0.3 * size), size, random), random_vector(random, size)});
  }
  return questions;
}

std::size_t count_for(const BspSubject& subject, std::size_t count) { return is_slow(subject.name) ? 4 : count; }

std::optional<ShapeHit> true_cast(const BspSubject& subject, const Question& question) {
  return cast_shape(model_of_placed(question.placed), question.motion, subject.model, {.pose_a = question.placed.pose});
}

TEST(BspShapes, MeetTheSolidWhereTheyMeetTheModel) {
  for (const BspSubject& subject : bsp_subjects()) {
    SCOPED_TRACE(subject.name);
    for (const Question& question : questions_about(subject, count_for(subject, 100), 1))
      ASSERT_EQ(shape_fault(subject, question.placed), "");
  }
}

TEST(BspShapes, AreCastAsAtTheModel) {
  for (const BspSubject& subject : bsp_subjects()) {
    SCOPED_TRACE(subject.name);
    for (const Question& question : questions_about(subject, count_for(subject, 40), 2))
      ASSERT_EQ(cast_fault(subject, question.placed, question.motion, true_cast(subject, question)), "");
  }
}

TEST(BspTrace, ThatIsFreeMeetsNothing) {
  std::size_t free = 0, met = 0;
  for (const BspSubject& subject : bsp_subjects()) {
    SCOPED_TRACE(subject.name);
    for (const Question& question : questions_about(subject, count_for(subject, 40), 3)) {
      const std::optional<ShapeHit> truth = true_cast(subject, question);
      ASSERT_EQ(trace_fault(subject, question.placed, question.motion, truth), "");
      (truth.has_value() ? met : free) += 1;
    }
  }
  EXPECT_GT(free, 200U);
  EXPECT_GT(met, 200U);
}

/// The tree of a box, by its six planes alone.
BspTree tree_of_box() { return BspTree(Model(box_between({-1, -1, -1}, {1, 1, 1})), {.axis_planes = false}); }

std::optional<BspTrace> trace_of_ball_through(const BspTree& tree, const Vec3& point, const Vec3& way,
                                              BspBevels bevels) {
  return tree.trace(PosedPolytope(Sphere(0.5), Pose::translation(point - 3.0 * way)), 6.0 * way, bevels);
}

TEST(BspTrace, IsExactInFrontOfAFace) {
  const BspTree tree = tree_of_box();
  const PosedPolytope ball(Sphere(0.5), Pose::translation(0.25, 0.5, 4));
  const std::optional<BspTrace> trace = tree.trace(ball, {0, 0, -5});
  ASSERT_TRUE(trace);
  EXPECT_NEAR(trace->time, 0.5, 1e-6);
  EXPECT_LE(trace->time, 0.5);
  EXPECT_EQ(trace->normal, (Vec3{0, 0, 1}));
  EXPECT_FALSE(tree.trace(ball, {0, 0, -2.4}));
}

TEST(BspTrace, HitsBesideACornerAndBevelsAndCastsDoNot) {
  const BspTree tree = tree_of_box();
  // Past the corner at a distance of √3 · 0.4 = 0.69, where the ball reaches 0.5 and three planes at once 0.87.
  const Vec3 point{1.4, 1.4, 1.4}, way{1, -1, 0};
  EXPECT_TRUE(trace_of_ball_through(tree, point, way, BspBevels::none));
  EXPECT_FALSE(trace_of_ball_through(tree, point, way, BspBevels::edges_and_corners));
  const PosedPolytope ball(Sphere(0.5), Pose::translation(point - 3.0 * way));
  EXPECT_FALSE(tree.cast_shape(ball, 6.0 * way));
}

TEST(BspTrace, HitsBesideACornerBetweenBevelsAndCastsDoNot) {
  const BspTree tree = tree_of_box();
  // The distance is 0.525, and no bevel is across that direction.
  const Vec3 point = Vec3{1, 1, 1} + (0.525 / std::hypot(0.9, 0.31, 0.31)) * Vec3{0.9, 0.31, 0.31}, way{0, 1, -1};
  EXPECT_TRUE(trace_of_ball_through(tree, point, way, BspBevels::none));
  EXPECT_TRUE(trace_of_ball_through(tree, point, way, BspBevels::edges_and_corners));
  const PosedPolytope ball(Sphere(0.5), Pose::translation(point - 3.0 * way));
  EXPECT_FALSE(tree.cast_shape(ball, 6.0 * way));
}

/// How many are hits.
struct TraceCounts {
  std::size_t plain = 0;
  std::size_t bevelled = 0;
  std::size_t exact = 0;
};

TraceCounts counted(const BspTree& tree, Random& random, std::size_t count, bool boxes) {
  TraceCounts counts;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 size = random_vector(random, 0.3);
    const Pose pose = Pose::translation(random_vector(random, 2));
    const PosedPolytope shape =
        boxes ? PosedPolytope(Box({0.01 + std::fabs(size.x), 0.01 + std::fabs(size.y), 0.01 + std::fabs(size.z)}), pose)
              : PosedPolytope(Sphere(0.01 + std::fabs(size.x)), pose);
    const Vec3 motion = random_vector(random, 2);
    counts.plain += tree.trace(shape, motion).has_value();
    counts.bevelled += tree.trace(shape, motion, BspBevels::edges_and_corners).has_value();
    counts.exact += tree.cast_shape(shape, motion).has_value();
  }
  return counts;
}

// All planes of the Minkowski sum of such a cell and a box are among its planes, moved out, and the bevels.
TEST(BspTrace, OfBoxesAlongTheAxesIsRightWithBevels) {
  Random random(4);
  for (const char* name : {"gen:tetrahedron", "gen:prism?sides=3", "gen:prism?sides=5"}) {
    SCOPED_TRACE(name);
    // Without the box far away the box around the mesh would do much of what bevels do.
    const TriangleMesh mesh = oracle::joined(generated(name), box_between({8, 8, 8}, {9, 9, 9}));
    const TraceCounts counts = counted(BspTree(Model(mesh), {.axis_planes = false}), random, 400, true);
    EXPECT_GT(counts.plain, counts.bevelled);
    EXPECT_EQ(counts.bevelled, counts.exact);
    EXPECT_GT(counts.exact, 30U);
  }
}

TEST(BspTrace, TellsOfHitsThatAreNoneAndBevelsOfFewer) {
  Random random(5);
  std::size_t plain = 0, bevelled = 0;
  for (const char* name : {"gen:torus-knot?around=120&sides=6", "gen:gear", "gen:noise-sphere?roughness=0.8"}) {
    SCOPED_TRACE(name);
    const TraceCounts counts = counted(BspTree(Model(generated(name))), random, 100, false);
    EXPECT_GE(counts.bevelled, counts.exact);
    EXPECT_GE(counts.plain, counts.bevelled);
    plain += counts.plain - counts.exact;
    bevelled += counts.bevelled - counts.exact;
  }
  EXPECT_GT(bevelled, 0U);
  EXPECT_LT(2 * bevelled, plain);
}

TEST(BspShapes, InsideAreMetAtOnce) {
  const BspTree tree = tree_of_box();
  const PosedPolytope ball(Sphere(0.25));
  EXPECT_TRUE(tree.overlap(ball));
  const std::optional<ShapeHit> hit = tree.cast_shape(ball, {5, 0, 0});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->upper, 0);
  EXPECT_EQ(hit, cast_shape(Sphere(0.25), {5, 0, 0}, Model(box_between({-1, -1, -1}, {1, 1, 1}))));
  EXPECT_EQ(tree.trace(ball, {5, 0, 0})->time, 0);
}

TEST(BspShapes, OfWhichNoNumberMayBeInfinite) {
  const BspTree tree = tree_of_box();
  const PosedPolytope ball(Sphere(0.25));
  const Vec3 endless{0, std::numeric_limits<double>::infinity(), 0};
  EXPECT_EQ(message_of([&] { static_cast<void>(tree.trace(ball, endless)); }),
            "the motion has a coordinate that is not finite");
  EXPECT_THROW(static_cast<void>(tree.cast_shape(ball, endless)), Error);
}

}  // namespace
}  // namespace toccata
