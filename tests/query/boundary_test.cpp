// Nearest points and signed distances of shapes that are no meshes: seen from without and from within.
#include "query/boundary_checks.hpp"

#include <gtest/gtest.h>

#include "support/mesh_soups.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/nearest.hpp"

namespace toccata {
namespace {

TEST(Boundaries, OfEveryConvexKindAgreeWithTheOracle) {
  std::uint64_t seed = 0;
  for (const std::string& kind : test::convex_kinds())
    for (const std::string& regime : test::convex_regimes())
      for (int i = 0; i < 2; ++i) {
        Random random(Random(++seed).bits());
        const test::BoundaryCase c = test::boundary_case(kind, regime, random);
        ASSERT_EQ(test::boundary_fault(c), "") << kind << ", " << regime << ", seed " << seed;
      }
}

TEST(Boundaries, OfABoxFromWithin) {
  const Model box(Box({1, 2, 3}));
  const std::optional<SurfacePoint> found = nearest_point({0.25, 0, 0}, box);
  EXPECT_NEAR(found->upper, 0.75, 1e-12);
  EXPECT_EQ(found->point, (Vec3{1, 0, 0}));
  EXPECT_EQ(found->element, 0U);
  EXPECT_EQ(found->face, 0U);
  const SignedDistance d = signed_distance({0.25, 0, 0}, box, Pose::translation(0, 0, 1));
  EXPECT_EQ(d.side, Side::inside);
  EXPECT_NEAR(d.lower, -0.75, 1e-12);
  EXPECT_EQ(signed_distance({1, 0.5, 0}, box).side, Side::boundary);
  EXPECT_EQ(signed_distance({1, 2.5, 0}, box).side, Side::outside);
}

/// Where all directions are as good, one is taken: the distance is the radius, to the last place.
TEST(Boundaries, FromTheMiddleOfWhatIsRound) {
  const auto from_middle = [](const Model& model, const Vec3& point) {
    const SignedDistance d = signed_distance(point, model, {});
    EXPECT_EQ(d.side, Side::inside);
    EXPECT_EQ(d.lower, -0.7);
    const Vec3 way = d.nearest - point;
    EXPECT_NEAR(std::hypot(way.x, way.y, way.z), 0.7, 1e-15);
    EXPECT_NEAR(signed_distance(d.nearest, model).upper, 0, 1e-15);
  };
  from_middle(Model(Sphere(0.7)), {0, 0, 0});
  from_middle(Model(Capsule({0, 0, -1}, {0, 0, 1}, 0.7)), {0, 0, 0.5});
  from_middle(Model(Capsule({0, 0, -1}, {0, 0, 1}, 0.7)), {0, 0, 1});
  from_middle(Model(Rounded(Triangle{{Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{0, 2, 1}}}, 0.7)), {1, 0.5, 0.25});
  from_middle(Model(Rounded(Segment({1, 1, 1}, {-1, -1, -1}), 0.7)), {0, 0, 0});
}

TEST(Boundaries, OfARoundedBoxGoThroughItsCore) {
  const Model box(Rounded(Box({1, 1, 1}), 0.5));
  EXPECT_NEAR(signed_distance({0.75, 0, 0}, box).lower, -0.75, 1e-12);
  EXPECT_NEAR(nearest_point({0.75, 0, 0}, box)->point.x, 1.5, 1e-15);
  EXPECT_NEAR(signed_distance({1, 0, 0}, box).lower, -0.5, 1e-12);
  EXPECT_NEAR(nearest_point({1, 0, 0}, box)->point.x, 1.5, 1e-15);
  EXPECT_NEAR(signed_distance({1.25, 0, 0}, box).lower, -0.25, 1e-12);
  EXPECT_EQ(signed_distance({1.5, 0, 0}, box).side, Side::boundary);
  EXPECT_EQ(signed_distance({1.5, 1.5, 0}, box).side, Side::outside);
}

TEST(Boundaries, OfAHalfSpace) {
  const Model floor(HalfSpace({0, 0, 0.5}, {0, 0, 1}));
  EXPECT_NEAR(signed_distance({7, 8, -2}, floor).upper, -2.5, 1e-11);
  EXPECT_EQ(nearest_point({7, 8, -2}, floor)->point, (Vec3{7, 8, 0.5}));
  EXPECT_NEAR(signed_distance({7, 8, 2}, floor).upper, 1.5, 1e-11);
  EXPECT_EQ(signed_distance({7, 8, 0.5}, floor).side, Side::boundary);
}

TEST(Boundaries, OfSurfacesHoldNothing) {
  const Model triangle(Triangle{{Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{0, 2, 0}}});
  EXPECT_EQ(signed_distance({0.5, 0.5, 0}, triangle).side, Side::boundary);
  EXPECT_EQ(signed_distance({0.5, 0.5, 1e-9}, triangle).side, Side::outside);
  EXPECT_EQ(signed_distance({3, 4, 0}, Model(Point{})).side, Side::outside);
}

/// The surface of a compound is that of all its parts; a point is inside when it is inside some part.
TEST(Boundaries, OfACompoundAreThoseOfItsParts) {
  const TriangleMesh shell = test::box_between({-4, -4, -4}, {4, 4, 4});
  std::vector<std::array<Index, 3>> lidless(shell.triangles().begin() + 2, shell.triangles().end());
  const std::vector<CompoundPart> parts{
      {std::make_shared<const TriangleMesh>(test::box_between({0, 0, 0}, {2, 2, 2})), {}},
      {Sphere(1), Pose::translation(2, 1, 1)},
      {Box({1, 1, 1}), Pose::translation(20, 0, 0)}};
  const Model model((Compound(parts)));
  const SignedDistance in_both = signed_distance({1.75, 1, 1}, model);
  EXPECT_EQ(in_both.side, Side::inside);
  EXPECT_EQ(in_both.sign_by, SignBy::winding_number);
  EXPECT_NEAR(in_both.lower, -0.25, 1e-12);  // the face of the box at x = 2, which lies within the ball
  const SignedDistance in_ball = signed_distance({2.5, 1, 1}, model);
  EXPECT_EQ(in_ball.side, Side::inside);
  EXPECT_NEAR(in_ball.lower, -0.5, 1e-12);
  EXPECT_EQ(signed_distance({19.5, 0, 0}, model).element, 13U);
  EXPECT_EQ(signed_distance({10, 0, 0}, model).side, Side::outside);
  // One part is open: where no other holds the point, the answer says how it was told.
  std::vector<CompoundPart> with_open = parts;
  with_open.push_back(
      {std::make_shared<const TriangleMesh>(TriangleMesh({shell.vertices().begin(), shell.vertices().end()}, lidless)),
       Pose::translation(-20, 0, 0)});
  const Model mixed((Compound(with_open)));
  EXPECT_EQ(signed_distance({0.5, 1, 1}, mixed).sign_by, SignBy::winding_number);
  const SignedDistance guessed = signed_distance({-20, 0, 0}, mixed);
  EXPECT_EQ(guessed.sign_by, SignBy::generalized_winding_number);
  EXPECT_EQ(guessed.side, Side::inside);
  EXPECT_EQ(signed_distance({10, 0, 0}, mixed).sign_by, SignBy::generalized_winding_number);
  EXPECT_THROW(static_cast<void>(signed_distance({1, 1, 1}, mixed, {}, SignBy::winding_number)), Error);
}

TEST(Boundaries, ManyAtOnceAreTheSameAsOneByOne) {
  const std::vector<CompoundPart> parts{{Box({1, 2, 3}), Pose::translation(1, 0, 0)},
                                        {Rounded(Box({1, 1, 1}), 0.5), Pose::translation(-2, 0, 0)},
                                        {Capsule({0, 0, -1}, {0, 0, 1}, 0.5), Pose::translation(0, 3, 0)}};
  const Model model((Compound(parts)));
  Random random(3);
  std::vector<Vec3> points;
  for (int i = 0; i < 300; ++i) points.push_back({random.between(-4, 4), random.between(-4, 4), random.between(-4, 4)});
  const auto one_thread = signed_distance_each(points, model, {}, SignBy::automatic, {.threads = 1});
  EXPECT_EQ(signed_distance_each(points, model, {}, SignBy::automatic, {.threads = 3}), one_thread);
  Workspace workspace;
  for (std::size_t i = 0; i < points.size(); ++i)
    ASSERT_EQ(signed_distance(points[i], model, {}, SignBy::automatic, workspace), one_thread[i]) << i;
}

/// Poses that deform, for shapes that may be.
TEST(Boundaries, OfDeformedAndRoundedPolytopes) {
  Random random(9);
  for (int i = 0; i < 60; ++i) {
    const std::string family = test::pose_families()[random.below(test::pose_families().size())];
    if (family == "singular") continue;
    test::BoundaryCase c{
        {test::random_convex(i % 2 == 0 ? "box" : "hull", random), test::random_poses(family, random).pose_a}, {}};
    if (is_singular(c.placed.pose.linear)) continue;
    c.point = test::point_about(test::posed(c.placed), random);
    ASSERT_EQ(test::boundary_fault(c), "") << family << ", " << i;
  }
}

/// Near the ends of the doubles, where squares and cubes over- and underflow.
TEST(Boundaries, OfTheTiniestAndTheHugestShapes) {
  Random random(21);
  for (const double size : {1e-320, 1e-310, 1e-300, 1e-160, 1e-30, 1e30, 1e150, 1e300, 1e307}) {
    const auto about = [&] { return size * random.between(-1, 1); };
    const auto vector = [&] {
      const double x = about(), y = about();
      return Vec3{x, y, about()};
    };
    const std::vector<test::ConvexShape> shapes{
        Box({size, 0.5 * size, 0.25 * size}),
        Sphere(size, vector()),
        Capsule(vector(), vector(), 0.5 * size),
        Rounded(Box({0.25 * size, 0.25 * size, 0.5 * size}), 0.125 * size),
        Rounded(Triangle{{vector(), vector(), vector()}}, 0.25 * size),
        ConvexHull(std::vector<Vec3>{vector(), vector(), vector(), vector(), vector()})};
    for (const test::ConvexShape& shape : shapes)
      for (int i = 0; i < 6; ++i) {
        test::BoundaryCase c{{shape, {}}, i == 0 ? Vec3{} : i % 3 == 0 ? 0.25 * vector() : vector()};
        if (i % 4 == 1) c.point = test::point_about(test::posed(c.placed), random);
        ASSERT_EQ(test::boundary_fault(c), "") << size << ", shape " << shape.index() << ", point " << i;
      }
  }
}

}  // namespace
}  // namespace toccata
