#include "methods/bsp/bsp_fragments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "oracle/rational.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"

// Fragments beside the slow way: the same planes cut the same triangles in rational arithmetic, with every corner as
// what it is.
namespace toccata {
namespace {

using oracle::exact;
using oracle::RationalPoint;
using RationalPolygon = std::vector<RationalPoint>;

/// How far a point is above a plane, times the length of its normal.
oracle::Rational height(const RationalPoint& p, const BspPlanes& planes, BspPlane plane) {
  if (planes.is_axis(plane)) {
    const auto& [axis, value] = planes.axis_plane(plane);
    return (axis == 0 ? p.x : axis == 1 ? p.y : p.z) - exact(value);
  }
  const Triangle t = planes.triangle(plane);
  return oracle::orientation(exact(t[0]), exact(t[1]), exact(t[2]), p);
}

/// What of a convex polygon is on that side, its border included.
RationalPolygon clipped(const RationalPolygon& polygon, const BspPlanes& planes, BspPlane plane, int side) {
  RationalPolygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const oracle::Rational here = height(p, planes, plane), next = height(q, planes, plane);
    if (side * here.sign() >= 0) result.push_back(p);
    if (here.sign() * next.sign() < 0) result.push_back(p + (here / (here - next)) * (q - p));
  }
  return result;
}

/// Every corner is where the polygon has it, to within its error and the rounding of a vertex.
void expect_same(const PooledFragment& fragment, const BspFragments& fragments, const BspFrame& frame,
                 const RationalPolygon& truth) {
  ASSERT_EQ(fragment.count, truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const BspCorner& corner = fragments.corner(fragment, i);
    const RationalPoint from_middle = truth[i] - exact(frame.middle());
    const oracle::Rational unit = exact(frame.way({1, 0, 0}).x), bound = exact(corner.error) + exact(0x1p-53);
    const RationalPoint off = unit * from_middle - exact(corner.place);
    for (const oracle::Rational& along : {off.x, off.y, off.z}) EXPECT_LE(abs(along), bound);
  }
}

struct Cut {
  PooledFragment fragment;
  RationalPolygon truth;
};

/// Cuts the triangle by random planes one after the other, going on with one of the two parts.
void cut_triangle(Index triangle, const BspFrame& frame, BspPlanes& planes, BspFragments& fragments, Random& random) {
  const Triangle t = planes.triangle(triangle);
  Cut cut{fragments.whole(triangle), {exact(t[0]), exact(t[1]), exact(t[2])}};
  for (int step = 0; step < 8; ++step) {
    auto plane = static_cast<BspPlane>(random.below(planes.triangle_count()));
    const auto axis = static_cast<int>(random.below(3));
    if (step % 3 == 2) plane = planes.add({axis, planes.triangle(plane)[0][axis]});
    if (!planes.is_axis(plane) && !has_area(planes.triangle(plane))) continue;
    const SplitFragment split = fragments.split(cut.fragment, plane, planes.rounded(plane));
    int least = 0, greatest = 0;
    for (const RationalPoint& p : cut.truth) {
      least = std::min(least, height(p, planes, plane).sign());
      greatest = std::max(greatest, height(p, planes, plane).sign());
    }
    ASSERT_EQ(split.front.count != 0, greatest > 0);
    ASSERT_EQ(split.back.count != 0, least < 0);
    if (least == 0 && greatest == 0) continue;
    const int side = least == 0 || (greatest > 0 && random.below(2) == 0) ? 1 : -1;
    if (least < 0 && greatest > 0) cut.truth = clipped(cut.truth, planes, plane, side);
    cut.fragment = side > 0 ? split.front : split.back;
    expect_same(cut.fragment, fragments, frame, cut.truth);
  }
}

void cut_mesh(const TriangleMesh& mesh, Random& random) {
  Aabb box{mesh.vertices()[0], mesh.vertices()[0]};
  for (const Vec3& v : mesh.vertices())
    for (int axis = 0; axis < 3; ++axis) {
      box.lower[axis] = std::min(box.lower[axis], v[axis]);
      box.upper[axis] = std::max(box.upper[axis], v[axis]);
    }
  const BspFrame frame(box);
  BspPlanes planes(mesh, frame);
  BspFragments fragments(planes, frame);
  for (Index t = 0; t < mesh.triangle_count(); ++t)
    if (has_area(planes.triangle(t))) cut_triangle(t, frame, planes, fragments, random);
}

TEST(BspFragments, OfLargeTrianglesInAllDirectionsAreThoseOfRationals) {
  Random random(1);
  for (int i = 0; i < 10; ++i) cut_mesh(test::random_soup(random, 40, 0.7, 0), random);
}

TEST(BspFragments, OfTrianglesOnAGridWherePlanesShareLinesAndPointsAreThoseOfRationals) {
  Random random(2);
  for (int i = 0; i < 20; ++i) cut_mesh(test::random_soup(random, 40, 0.7, 4), random);
}

TEST(BspFragments, OfTinyHugeAndFarTrianglesAreThoseOfRationals) {
  Random random(3);
  for (const double factor : {0x1p-1000, 0x1p-400, 0x1p-100, 0x1p100, 0x1p400, 0x1p1000})
    cut_mesh(scaled_mesh(test::random_soup(random, 30, 0.7, 0), factor), random);
  for (const double offset : {1e3, 1e8, 1e15}) {
    const TriangleMesh soup = test::random_soup(random, 30, 0.7, 0);
    std::vector<Vec3> moved(soup.vertices().begin(), soup.vertices().end());
    for (Vec3& v : moved) v += Vec3{offset, -offset, 0};
    cut_mesh(soup.with_vertices(moved), random);
  }
}

TEST(BspFragments, OfNeedlesAndNearlyParallelPlanesAreThoseOfRationals) {
  Random random(4);
  for (int i = 0; i < 10; ++i) {
    const TriangleMesh soup = test::random_soup(random, 30, 0.7, 0);
    std::vector<Vec3> flat(soup.vertices().begin(), soup.vertices().end());
    for (Vec3& v : flat) v.z = 0.25 * v.x + std::ldexp(v.z, -static_cast<int>(random.below(60)));
    cut_mesh(soup.with_vertices(flat), random);
  }
}

}  // namespace
}  // namespace toccata
