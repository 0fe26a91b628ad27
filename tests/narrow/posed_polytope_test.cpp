#include "toccata/narrow/posed_polytope.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "narrow/pose_checks.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

constexpr double most = std::numeric_limits<double>::max();

void expect_refused(const std::string& words, const std::function<void()>& make) {
  try {
    make();
    ADD_FAILURE() << "nothing was refused with \"" << words << "\"";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

Pose of_diagonal(double x, double y, double z) { return {{{Vec3{x, 0, 0}, {0, y, 0}, {0, 0, z}}}, {}}; }

/// Checks what HullTopology promises of every shape with edges.
void expect_consistent(const HullTopology& t) {
  for (Index f = 0; f < t.face_count(); ++f)
    for (Index h = t.face_start[f]; h < t.face_start[f + 1]; ++h) EXPECT_EQ(t.face[h], f);
  for (Index h = 0; h < t.origin.size(); ++h) {
    EXPECT_EQ(t.twin[t.twin[h]], h);
    EXPECT_NE(t.twin[h], h);
    EXPECT_EQ(t.target(h), t.origin[t.next(h)]);
    EXPECT_EQ(t.target(t.twin[h]), t.origin[h]);
    EXPECT_EQ(t.origin[t.leaving[t.origin[h]]], t.origin[h]);
  }
}

TEST(Deformation, ALimitIsDecidedExactly) {
  // RᵀR − I of a stretch x along one axis is x² − 1, of which fma tells the sign exactly.
  for (const double limit : {1 + 0x1p-10, 1 - 0x1p-10}) {
    const double near = std::sqrt(limit);
    for (const double x : {std::nextafter(near, 0), near, std::nextafter(near, 2)})
      EXPECT_EQ(deforms(of_diagonal(1, x, 1).linear), std::fma(x, x, -limit) * (limit - 1) > 0) << x;
  }
}

TEST(Deformation, RowSumsCountAllThreeEntries) {
  // A shear s: the entries off the diagonal are s, one on it s².
  EXPECT_FALSE(deforms(Mat3{{Vec3{1, 0x1p-11, 0}, {0, 1, 0}, {0, 0, 1}}}));
  // Two shears in one column: a sum of 2^-10 in another row and the squares on the diagonal.
  EXPECT_FALSE(deforms(Mat3{{Vec3{1, 0x1p-11, 0x1p-11}, {0, 1, 0}, {0, 0, 1}}}));
  EXPECT_TRUE(deforms(Mat3{{Vec3{1, 0x1p-11, 0x1.0000000000001p-11}, {0, 1, 0}, {0, 0, 1}}}));
}

TEST(Deformation, RotationsAndMirrorsAreNone) {
  for (int degrees = 0; degrees < 360; ++degrees)
    EXPECT_FALSE(deforms(rotation_about({1, 2.5, -3}, degrees))) << degrees;
  EXPECT_FALSE(deforms(of_diagonal(-1, 1, -1).linear));
  EXPECT_TRUE(deforms(of_diagonal(1, 2, 1).linear));
  EXPECT_TRUE(deforms(of_diagonal(0, 1, 1).linear));
  EXPECT_TRUE(deforms(of_diagonal(most, most, most).linear));
}

TEST(PosedPolytope, VerticesAreThoseOfTheTruthPage) {
  const Pose pose{rotation_about({1, 2, 3}, 40), {0.1, 0.2, 0.3}};
  const Box box({0.3, 0.7, 1.1}, {5, 6, 7});
  const PosedPolytope posed(box, pose);
  ASSERT_EQ(posed.vertex_count(), 8U);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(posed.vertex(static_cast<Index>(i)), transform(pose, box.corner(i)));
  EXPECT_TRUE(posed.solid());
  EXPECT_EQ(posed.radius(), 0);
  EXPECT_TRUE(posed.in_world());
  EXPECT_EQ(posed.padded_count(), 8U);
}

TEST(PosedPolytope, CoordinatesArePaddedByTheLastVertex) {
  const PosedPolytope posed(Triangle{{Vec3{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}, Pose::translation(1, 0, 0));
  EXPECT_EQ(posed.padded_count(), 8U);
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(posed.along(0)[i], i == 0 ? 2 : i == 1 ? 5 : 8);
    EXPECT_EQ(posed.along(2)[i], i == 0 ? 3 : i == 1 ? 6 : 9);
  }
  EXPECT_FALSE(posed.solid());
}

TEST(PosedPolytope, ACopyHasItsOwnVertices) {
  auto first = std::make_unique<PosedPolytope>(Capsule({1, 2, 3}, {4, 5, 6}, 2));
  PosedPolytope second{Point{}};
  second = *first;
  const PosedPolytope third(*first);
  first.reset();
  EXPECT_EQ(second.vertex(1), (Vec3{4, 5, 6}));
  EXPECT_EQ(third.vertex(0), (Vec3{1, 2, 3}));
  EXPECT_EQ(third.radius(), 2);
  EXPECT_TRUE(third.solid());
}

TEST(PosedPolytope, ABoxHasSixOutwardFaces) {
  const PosedPolytope box(Box{{1, 1, 1}});
  const HullTopology t = box.topology();
  expect_consistent(t);
  ASSERT_EQ(t.face_count(), 6U);
  EXPECT_EQ(t.leaving.size(), 8U);
  for (Index f = 0; f < 6; ++f) {
    const Index h = t.face_start[f];
    const Vec3 a = box.vertex(t.origin[h]), b = box.vertex(t.origin[h + 1]), c = box.vertex(t.origin[h + 2]);
    const Vec3 normal = 0.25 * cross(b - a, c - b);
    Vec3 expected;
    expected[static_cast<int>(f) / 2] = f % 2 == 0 ? -1 : 1;
    EXPECT_EQ(normal, expected) << f;
  }
}

TEST(PosedPolytope, ATriangleHasAFrontAndABack) {
  const HullTopology t = PosedPolytope(Triangle{{Vec3{}, {1, 0, 0}, {0, 1, 0}}}).topology();
  expect_consistent(t);
  ASSERT_EQ(t.face_count(), 2U);
  EXPECT_EQ(std::vector<Index>(t.origin.begin(), t.origin.begin() + 3), (std::vector<Index>{0, 1, 2}));
}

TEST(PosedPolytope, ATriangleWithoutAreaIsASegmentOrAPoint) {
  const Vec3 low{0, 0, 0}, middle{1, 1, 1}, high{3, 3, 3};
  const std::array<std::pair<Triangle, std::set<Index>>, 5> cases = {{{Triangle{{low, middle, high}}, {0, 2}},
                                                                      {Triangle{{high, low, middle}}, {0, 1}},
                                                                      {Triangle{{middle, high, low}}, {1, 2}},
                                                                      {Triangle{{low, low, high}}, {0, 2}},
                                                                      {Triangle{{high, low, high}}, {0, 1}}}};
  for (const auto& [triangle, ends] : cases) {
    const PosedPolytope posed(triangle);
    const HullTopology t = posed.topology();
    expect_consistent(t);
    EXPECT_EQ(posed.vertex_count(), 3U);
    EXPECT_EQ(t.face_count(), 1U);
    EXPECT_EQ(t.leaving.size(), 3U);
    EXPECT_EQ(std::set<Index>(t.origin.begin(), t.origin.end()), ends);
  }
  EXPECT_EQ(PosedPolytope(Triangle{{high, high, high}}).topology().face_count(), 0U);
  // A pose that flattens counts: it is the world vertices that have no area.
  const Triangle upright{{Vec3{}, {1, 0, 0}, {0, 0, 1}}};
  EXPECT_EQ(PosedPolytope(upright, of_diagonal(1, 1, 0)).topology().face_count(), 1U);
}

TEST(PosedPolytope, RoundShapesHaveTheTopologyOfTheirCore) {
  EXPECT_EQ(PosedPolytope(Sphere{2}).topology().face_count(), 0U);
  EXPECT_EQ(PosedPolytope(Capsule{{}, {1, 0, 0}, 2}).topology().face_count(), 1U);
  EXPECT_EQ(PosedPolytope(Capsule{{1, 1, 1}, {1, 1, 1}, 2}).topology().face_count(), 0U);
  EXPECT_EQ(PosedPolytope(Segment{{1, 1, 1}, {1, 1, 1}}).topology().face_count(), 0U);
}

TEST(PosedPolytope, PosesMustBeFinite) {
  Pose bad;
  bad.linear[1][2] = HUGE_VAL;
  expect_refused("the point: the pose", [&] { static_cast<void>(PosedPolytope(Point{}, bad)); });
  expect_refused("the sphere: the pose", [&] { static_cast<void>(PosedPolytope(Sphere{1}, bad)); });
  expect_refused("not finite", [&] { static_cast<void>(PosedPolytope(Box{{1, 1, 1}}, bad)); });
}

TEST(PosedPolytope, WorldVerticesMustBeFinite) {
  const Pose far = Pose::translation(most, 0, 0);
  expect_refused("vertex 0", [&] { static_cast<void>(PosedPolytope(Point{{most, 0, 0}}, far)); });
  expect_refused("vertex 1", [&] { static_cast<void>(PosedPolytope(Capsule{{}, {most, 0, 0}, 1}, far)); });
  expect_refused("vertex 2", [&] { static_cast<void>(PosedPolytope(Triangle{{Vec3{}, {}, {most, 0, 0}}}, far)); });
  expect_refused("vertex 1", [&] { static_cast<void>(PosedPolytope(Box{{most, 1, 1}}, far)); });
}

TEST(PosedPolytope, ABallMustStayABall) {
  const Pose stretched = of_diagonal(1, 2, 1);
  expect_refused("ellipsoid", [&] { static_cast<void>(PosedPolytope(Sphere{1}, stretched)); });
  expect_refused("ellipsoid", [&] { static_cast<void>(PosedPolytope(Capsule{{}, {}, 1}, stretched)); });
  EXPECT_EQ(PosedPolytope(Box{{1, 1, 1}}, stretched).vertex(7), (Vec3{1, 2, 1}));
}

TEST(PosedPolytope, ASolidMustNotBeFlattened) {
  const Pose flattened = of_diagonal(1, 0, 1);
  expect_refused("singular", [&] { static_cast<void>(PosedPolytope(Box{{1, 1, 1}}, flattened)); });
  EXPECT_EQ(PosedPolytope(Segment{{}, {1, 1, 1}}, flattened).vertex(1), (Vec3{1, 0, 1}));
}

}  // namespace
}  // namespace toccata
