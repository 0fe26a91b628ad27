// The two slow ways to tell how deep solids are in each other where they are deepest, against closed forms.
#include "oracle/local_depth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "toccata/core/random.hpp"

namespace toccata::oracle {
namespace {

std::vector<FacetPlane> planes_of(const AxisBox& box) {
  std::vector<FacetPlane> planes;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 normal;
    normal[axis] = 1;
    planes.push_back({normal, box.upper[axis]});
    planes.push_back({-normal, -box.lower[axis]});
  }
  return planes;
}

CellSolid solid_of(const AxisBox& box) {
  CellSolid solid{{box}, {}};
  for (int axis = 0; axis < 3; ++axis) {
    AxisBox lower = box, upper = box;
    lower.upper[axis] = box.lower[axis];
    upper.lower[axis] = box.upper[axis];
    solid.surface.push_back(lower);
    solid.surface.push_back(upper);
  }
  return solid;
}

void expect_depths(const AxisBox& a, const AxisBox& b, double depth) {
  const LocalDepth of_planes = local_depth_of_convex(planes_of(a), planes_of(b));
  EXPECT_NEAR(of_planes.lower, depth, 1e-12);
  EXPECT_NEAR(of_planes.upper, depth, 1e-12);
  const LocalDepth of_cells = local_depth_of_cells(solid_of(a), solid_of(b), 1e-3);
  EXPECT_LE(of_cells.lower, depth + 1e-12);
  EXPECT_GE(of_cells.upper, depth - 1e-12);
  EXPECT_LE(of_cells.upper, 1.001 * of_cells.lower + 1e-12);
}

/// As deep as two faces are apart, and as half of what both are thick.
TEST(OracleLocalDepth, OfBoxesIsThatOfTheClosedForm) {
  Random random(28);
  int meeting = 0;
  for (int round = 0; round < 60; ++round) {
    AxisBox a, b;
    double depth = 10, thin_a = 10, thin_b = 10;
    for (int i = 0; i < 3; ++i) {
      a.lower[i] = random.between(-1, 0);
      a.upper[i] = random.between(0.1, 1);
      b.lower[i] = random.between(-1, 0.3);
      b.upper[i] = b.lower[i] + random.between(0.05, 2);
      depth = std::min(depth, std::min(a.upper[i] - b.lower[i], b.upper[i] - a.lower[i]));
      thin_a = std::min(thin_a, a.upper[i] - a.lower[i]);
      thin_b = std::min(thin_b, b.upper[i] - b.lower[i]);
    }
    if (depth <= 0) continue;
    expect_depths(a, b, std::min(depth, 0.5 * (thin_a + thin_b)));
    ++meeting;
  }
  EXPECT_GT(meeting, 20);
}

TEST(OracleLocalDepth, OfARodThroughAPlateIsHalfOfWhatBothAreThick) {
  expect_depths({{-2, -2, -0.125}, {2, 2, 0.125}}, {{-0.25, -0.5, -2}, {0.25, 0.5, 2}}, 0.375);
}

/// Two edges that cross at right angles, the roofs of whose prisms have right angles, too.
TEST(OracleLocalDepth, OfEdgesThatCrossIsAlongTheirNormals) {
  const double slope = std::sqrt(0.5);
  const std::vector<FacetPlane> below{{{slope, 0, slope}, 0.1 * slope},
                                      {{-slope, 0, slope}, 0.1 * slope},
                                      {{0, 0, -1}, 5},
                                      {{0, 1, 0}, 5},
                                      {{0, -1, 0}, 5}},
      above{{{0, slope, -slope}, 0.1 * slope},
            {{0, -slope, -slope}, 0.1 * slope},
            {{0, 0, 1}, 5},
            {{1, 0, 0}, 5},
            {{-1, 0, 0}, 5}};
  const LocalDepth depth = local_depth_of_convex(below, above);  // at the height z: (0.1 − z + 0.1 + z) · slope
  EXPECT_NEAR(depth.lower, 0.2 * slope, 1e-12);
  EXPECT_NEAR(depth.upper, 0.2 * slope, 1e-12);
}

TEST(OracleLocalDepth, OfCellsApartIsNone) {
  const CellSolid a = solid_of({{0, 0, 0}, {1, 1, 1}}), b = solid_of({{1, 0, 0}, {2, 1, 1}});
  EXPECT_EQ(local_depth_of_cells(a, b, 1e-3).upper, 0);
}

}  // namespace
}  // namespace toccata::oracle
