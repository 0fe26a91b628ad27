// The questions of the lectures about bounding volumes, each shown (docs/methods/bounding-volumes.md names these
// tests).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/mesh_soups.hpp"
#include "toccata/bounds/obb.hpp"
#include "toccata/core/random.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/methods.hpp"
#include "toccata/methods/cost.hpp"
#include "toccata/toccata.hpp"

namespace toccata {
namespace {

Pose turned(double degrees) { return {rotation_about({0, 0, 1}, degrees), {}}; }

std::vector<Vec3> box_corners(const Vec3& half) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(Box(half).corner(i));
  return corners;
}

std::vector<Vec3> random_points(Random& random, std::size_t count) {
  std::vector<Vec3> points;
  while (points.size() < count) points.push_back({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
  return points;
}

TEST(VolumeQuestion, ABoxStretchesAsTheObjectRotates) {
  const std::vector<Vec3> cube = box_corners({1, 1, 1});
  // Fitted anew, it stretches to √2 at 45° and is itself again at 90°.
  EXPECT_NEAR(fit<Aabb>(transform(turned(45), cube)).upper.x, std::numbers::sqrt2, 1e-15);
  EXPECT_EQ(fit<Aabb>(transform(turned(90), cube)).upper.x, 1);
  // The box around the rotated box never shrinks again: eight turns of 45° make it 16 times as wide.
  Aabb box = fit<Aabb>(cube);
  for (int turn = 0; turn < 8; ++turn) box = posed(box, turned(45));
  EXPECT_NEAR(box.upper.x, 16, 1e-11);
  // An oriented box turns with the object, and a ball does not even notice.
  Obb oriented = fit<Obb>(cube);
  Ball ball = fit<Ball>(cube);
  for (int turn = 0; turn < 8; ++turn) {
    oriented = posed(oriented, turned(45));
    ball = posed(ball, turned(45));
  }
  EXPECT_NEAR(measure(oriented), 8, 1e-10);
  EXPECT_NEAR(ball.radius, std::sqrt(3), 1e-11);
}

TEST(VolumeQuestion, TheBoxAroundTheRotatedBoxHoldsTheOneThatIsFittedAnew) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const std::vector<Vec3> points = random_points(random, 12);
    const Pose pose{test::random_rotation(random), {random.between(-9, 9), 0, 0}};
    EXPECT_TRUE(contains(posed(fit<Aabb>(points), pose), fit<Aabb>(transform(pose, points))));
  }
}

/// The radius of the circle through three points if its centre is within the triangle, else 0.
double acute_radius(const Vec3& p, const Vec3& q, const Vec3& r) {
  const bool acute = dot(q - p, r - p) > 0 && dot(p - q, r - q) > 0 && dot(p - r, q - r) > 0;
  return acute ? length(q - p) * length(r - q) * length(p - r) / (2 * length(cross(q - p, r - p))) : 0;
}

/// The same of the sphere through four points.
double inner_radius(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  const Vec3 a = q - p, b = r - p, c = s - p;
  const double volume = dot(a, cross(b, c));
  const Vec3 centre = (0.5 / volume) * ((dot(a, a) * cross(b, c) + dot(b, b) * cross(c, a)) + dot(c, c) * cross(a, b));
  const double x = dot(centre, cross(b, c)) / volume, y = dot(a, cross(centre, c)) / volume;
  const double z = dot(a, cross(b, centre)) / volume;
  return x > 0 && y > 0 && z > 0 && x + y + z < 1 ? length(centre) : 0;
}

/// That of the smallest ball, which is as large as the largest of the smallest balls around four of the points.
double smallest_radius(const std::vector<Vec3>& points) {
  double radius = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      radius = std::max(radius, length(points[i] - points[j]) / 2);
      for (std::size_t k = 0; k < j; ++k) {
        radius = std::max(radius, acute_radius(points[i], points[j], points[k]));
        for (std::size_t l = 0; l < k; ++l)
          radius = std::max(radius, inner_radius(points[i], points[j], points[k], points[l]));
      }
    }
  return radius;
}

TEST(VolumeQuestion, ABallThatIsTightIsHardToMake) {
  double worst = 1;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(Random(seed).bits());
    const std::vector<Vec3> points = random_points(random, 2 + random.below(7));
    const double tight = fit<Ball>(points).radius, fast = fit_ball_fast(points).radius;
    EXPECT_NEAR(tight / smallest_radius(points), 1, 1e-9);
    EXPECT_GE(fast, tight * (1 - 1e-9));
    worst = std::max(worst, fast / tight);
  }
  // Ritter's is up to a fifth larger.
  EXPECT_GT(worst, 1.05);
  EXPECT_LT(worst, 1.25);
}

TEST(VolumeQuestion, CornersOnASphereHaveItAsTheirBall) {
  // Many more points than needed on the boundary, and all the same distance away: what makes careless searches cycle.
  Random random(2);
  std::vector<Vec3> points = box_corners({1, 2, 2});
  for (int i = 0; i < 200; ++i) points.push_back(0.9 * test::random_rotation(random)[0]);
  EXPECT_NEAR(fit<Ball>(points).radius, 3, 1e-12);
}

TEST(VolumeQuestion, AnAlignedBoxIsASpecialKDop) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const std::vector<Vec3> a = random_points(random, 6);
    std::vector<Vec3> b = random_points(random, 6);
    for (Vec3& p : b) p = p + Vec3{random.between(-3, 3), 0, 0};
    const Aabb box_a = fit<Aabb>(a), box_b = fit<Aabb>(b);
    const Kdop<6> slabs_a = fit<Kdop<6>>(a), slabs_b = fit<Kdop<6>>(b);
    EXPECT_EQ(box_around(slabs_a), box_a);
    EXPECT_EQ(overlap(slabs_a, slabs_b), overlap(box_a, box_b));
    EXPECT_EQ(overlap(fit<Kdop<26>>(a), fit<Kdop<26>>(b)) && !overlap(box_a, box_b), false);
  }
}

TEST(VolumeQuestion, TheSlabsOfATurnedKDopHoldThoseFittedAnew) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const std::vector<Vec3> points = random_points(random, 12);
    const Pose pose{test::random_rotation(random), {1, 2, 3}};
    const Kdop<26> refitted = fit<Kdop<26>>(transform(pose, points)), bound = posed(fit<Kdop<26>>(points), pose);
    EXPECT_TRUE(contains(bound, refitted));
    // What more slabs are good for: there is less to turn.
    const double loose = measure(posed(fit<Kdop<6>>(points), pose));
    EXPECT_LT(measure(bound), loose);
  }
}

TEST(VolumeQuestion, AnOrientedBoxMatchesTheGeometryBetter) {
  const std::vector<Vec3> plate = transform(turned(30), box_corners({3, 1, 0.1}));
  const ConvexHull held(plate);
  EXPECT_NEAR(tightness(fit<Obb>(plate), held).fill, 1, 1e-11);
  EXPECT_LT(tightness(fit<Aabb>(plate), held).fill, 0.45);
}

TEST(VolumeQuestion, AFixedBoxAroundAnOrientedOneSettlesMostPairs) {
  // Two plates side by side, as far apart as the boxes of the world around them tell.
  const Obb plate = fit_obb(transform(turned(45), box_corners({2, 2, 0.1})), rotation_about({0, 0, 1}, -45));
  const auto moved = [&](const Vec3& way) { return posed(plate, Pose{{}, way}); };
  EXPECT_FALSE(overlap(box_around(plate), box_around(moved({5.7, 0, 0}))));
  EXPECT_FALSE(overlap(plate, moved({5.7, 0, 0})));
  // "Possibly overlap, further check needed", and the check says no, then yes.
  EXPECT_TRUE(overlap(box_around(plate), box_around(moved({3, 3, 0}))));
  EXPECT_FALSE(overlap(plate, moved({3, 3, 0})));
  EXPECT_TRUE(overlap(box_around(plate), box_around(moved({2, 2, 0}))));
  EXPECT_TRUE(overlap(plate, moved({2, 2, 0})));
}

TEST(VolumeQuestion, SixDirectionsAreNotEnoughForOrientedBoxes) {
  // Two sticks that cross at right angles, turned so that no face of either parts them: the pair of edges does.
  const Mat3 one = rotation_about({1, 0, 0}, 45), other = rotation_about({0, 1, 0}, 45);
  const auto stick = [&](const Mat3& turn, const Vec3& half, double height) {
    return fit_obb(transform(Pose{turn, {0, 0, height}}, box_corners(half)),
                   {{turn.column(0), turn.column(1), turn.column(2)}});
  };
  const Obb low = stick(one, {5, 0.5, 0.5}, 0), high = stick(other, {0.5, 5, 0.5}, 1.42);
  EXPECT_FALSE(overlap(low, high));
  EXPECT_NEAR(gap(low, high), 1.42 - std::numbers::sqrt2, 1e-9);
  EXPECT_TRUE(overlap(low, stick(other, {0.5, 5, 0.5}, 1.41)));
}

/// The triangles of a unit square, one half of it cut into many.
std::vector<Triangle> unevenly_cut_square(int cuts) {
  std::vector<Triangle> triangles{{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}}}};
  for (int i = 0; i < cuts; ++i) {
    const double low = static_cast<double>(i) / cuts, high = static_cast<double>(i + 1) / cuts;
    triangles.push_back({{Vec3{0, 0, 0}, Vec3{high, 1, 0}, Vec3{low, 1, 0}}});
  }
  return triangles;
}

TEST(VolumeQuestion, TheCovarianceOfASurfaceDoesNotDependOnHowItIsCut) {
  for (const int cuts : {1, 2, 50}) {
    SCOPED_TRACE(cuts);
    const PrincipalAxes axes = principal_axes(unevenly_cut_square(cuts));
    EXPECT_NEAR(axes.mean.x, 0.5, 1e-15);
    EXPECT_NEAR(axes.mean.y, 0.5, 1e-15);
    // That of a square of edge 1 along every direction in it.
    EXPECT_NEAR(axes.spread.x, std::sqrt(1.0 / 12), 1e-15);
    EXPECT_NEAR(axes.spread.y, std::sqrt(1.0 / 12), 1e-15);
    EXPECT_EQ(axes.spread.z, 0);
    EXPECT_NEAR(std::fabs(axes.axes[2].z), 1, 1e-15);
  }
}

TEST(VolumeQuestion, TheCovarianceOfATriangleIsThatOfItsPoints) {
  // The integrals of the corner triangle are known: variances 1/18, covariance −1/36. The formula as first printed
  // gives other numbers.
  const PrincipalAxes axes = principal_axes(std::vector<Triangle>{{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}}});
  EXPECT_NEAR(axes.spread.x, std::sqrt(1.0 / 12), 1e-15);
  EXPECT_NEAR(axes.spread.y, std::sqrt(1.0 / 36), 1e-15);
  EXPECT_NEAR(axes.axes[0].x, -axes.axes[0].y, 1e-15);
}

TEST(VolumeQuestion, FineDetailDoesNotTurnTheBoxOfASurface) {
  // A long strip with a finely cut corner: counting vertices, the box would follow the corner.
  std::vector<Triangle> strip{{{Vec3{-9, -1, 0}, Vec3{9, -1, 0}, Vec3{9, 1, 0}}},
                              {{Vec3{-9, -1, 0}, Vec3{9, 1, 0}, Vec3{-9, 1, 0}}}};
  for (int i = 0; i < 300; ++i) {
    const double y = 3 * i / 300.0;
    strip.push_back({{Vec3{8.99, y, 0}, Vec3{9, y + 0.005, 0}, Vec3{8.99, y + 0.01, 0}}});
  }
  std::vector<Vec3> corners;
  for (const Triangle& t : strip) corners.insert(corners.end(), t.vertex.begin(), t.vertex.end());
  EXPECT_GT(std::fabs(principal_axes(strip).axes[0].x), 0.999);
  EXPECT_LT(std::fabs(principal_axes(corners).axes[0].x), 0.99);
}

TEST(VolumeQuestion, VolumesMayMeetWithoutWhatTheyHold) {
  // Nothing is lost by asking the volumes first; but a yes of theirs is no answer.
  const std::vector<Vec3> a{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, b{{2, 2, 0}, {2, 1.5, 0}, {1.5, 2, 0}};
  EXPECT_TRUE(overlap(fit<Aabb>(a), fit<Aabb>(b)));
  EXPECT_TRUE(overlap(fit<Ball>(a), fit<Ball>(b)));
  EXPECT_FALSE(overlap(fit<Kdop<18>>(a), fit<Kdop<18>>(b)));
  EXPECT_FALSE(overlap(fit<HullBound>(a), fit<HullBound>(b)));
}

}  // namespace
}  // namespace toccata
