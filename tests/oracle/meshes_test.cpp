#include "oracle/meshes.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "oracle/test_meshes.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/core/random.hpp"

namespace toccata::oracle::of_meshes {
namespace {

using test::box_between;

const TriangleMesh unit_box = box_between({0, 0, 0}, {1, 1, 1});

MeshSet solid(const TriangleMesh& mesh, const Pose& pose = {}) { return solid_set(mesh, pose); }
MeshSet surface(const TriangleMesh& mesh, const Pose& pose = {}) { return surface_set(mesh, pose); }

Relation both_ways(const MeshSet& a, const MeshSet& b) {
  const Relation answer = relation(a, b);
  EXPECT_EQ(answer, flipped(relation(b, a)));
  EXPECT_EQ(overlap(a, b), answer.kind != RelationKind::apart);
  return answer;
}

Relation overlapping(Containment containment = Containment::none) { return {RelationKind::overlapping, containment}; }
Relation crossing(Containment containment = Containment::none) { return {RelationKind::crossing, containment}; }
const Relation apart{RelationKind::apart};
const Relation touching{RelationKind::touching};
const Relation surfaces_touching{RelationKind::touching, Containment::none, true};

TEST(OracleMeshes, ClosedIsBalancedEdges) {
  EXPECT_TRUE(is_closed(unit_box));
  EXPECT_TRUE(is_closed(inverted_box_mesh({0, 0, 0}, {1, 1, 1})));
  EXPECT_FALSE(is_closed(single_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})));
  const TriangleMesh doubled_sheet =
      joined(single_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), single_triangle({-0.0, 0, 0}, {0, 1, 0}, {1, 0, 0}));
  EXPECT_TRUE(is_closed(doubled_sheet));
}

TEST(OracleMeshes, WhatIsAnErrorThrows) {
  const TriangleMesh open = single_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_THROW(solid_set(open, {}), std::invalid_argument);
  Pose flat;
  flat.linear[2] = {0, 0, 0};
  EXPECT_THROW(solid_set(unit_box, flat), std::invalid_argument);
  EXPECT_NO_THROW(surface_set(unit_box, flat));
  Pose huge;
  huge.linear[0] = {1e308, 1e308, 1e308};
  EXPECT_THROW(surface_set(unit_box, huge), std::invalid_argument);
}

TEST(OracleMeshes, RelationsOfBoxes) {
  const MeshSet box = solid(unit_box);
  EXPECT_EQ(both_ways(box, solid(unit_box, Pose::translation(2, 0, 0))), apart);
  EXPECT_EQ(both_ways(box, solid(unit_box, Pose::translation(1, 0, 0))), touching);
  EXPECT_EQ(both_ways(box, solid(unit_box, Pose::translation(1, 1, 0))), touching);
  EXPECT_EQ(both_ways(box, solid(unit_box, Pose::translation(1, 1, 1))), touching);
  EXPECT_EQ(both_ways(box, solid(unit_box, Pose::translation(1, 0.5, 0.25))), touching);
  EXPECT_EQ(both_ways(box, solid(unit_box, Pose::translation(0.5, 0, 0))), overlapping());
  EXPECT_EQ(both_ways(box, solid(unit_box, Pose::translation(0.5, 0.5, 0.5))), overlapping());
  EXPECT_EQ(both_ways(box, solid(unit_box)), overlapping(Containment::equal));
  EXPECT_EQ(both_ways(box, solid(box_between({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5}))), overlapping(Containment::b_in_a));
  EXPECT_EQ(both_ways(box, solid(box_between({0, 0, 0}, {1, 1, 0.5}))), overlapping(Containment::b_in_a));
  EXPECT_EQ(both_ways(box, solid(box_between({0.25, 0, 0.25}, {0.5, 1, 0.5}))), overlapping(Containment::b_in_a));
}

TEST(OracleMeshes, AlignedHalvesOverlapWithoutCrossingFaces) {
  const MeshSet box = solid(unit_box);
  const MeshSet shifted = solid(unit_box, Pose::translation(0.5, 0, 0));
  EXPECT_FALSE(surfaces_cross(solid(box_between({0, 0, 0}, {1, 1, 1})), solid(box_between({0, 0, 0}, {1, 1, 0.5}))));
  EXPECT_EQ(both_ways(box, shifted).kind, RelationKind::overlapping);
}

TEST(OracleMeshes, InsideOutAndMirroredSolidsAreSolids) {
  const MeshSet box = solid(unit_box);
  const MeshSet inverted = solid(inverted_box_mesh({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(both_ways(box, inverted), overlapping(Containment::equal));
  EXPECT_EQ(locate({Rational(1, 2), Rational(1, 2), Rational(1, 2)}, inverted), (Location{false, -1}));
  Pose mirror;
  mirror.linear[0] = {-1, 0, 0};
  EXPECT_EQ(both_ways(box, solid(unit_box, mirror)), touching);
}

TEST(OracleMeshes, WindingNumbers) {
  const MeshSet shells = solid(joined(unit_box, box_between({0.25, 0.25, 0.25}, {2, 2, 2})));
  EXPECT_EQ(locate(exact(Vec3{0.125, 0.125, 0.125}), shells), (Location{false, 1}));
  EXPECT_EQ(locate(exact(Vec3{0.5, 0.5, 0.5}), shells), (Location{false, 2}));
  EXPECT_EQ(locate(exact(Vec3{1.5, 1.5, 1.5}), shells), (Location{false, 1}));
  EXPECT_EQ(locate(exact(Vec3{2.5, 1.5, 1.5}), shells), (Location{false, 0}));
  EXPECT_EQ(locate(exact(Vec3{1, 0.5, 0.5}), shells), (Location{true, 0}));
  EXPECT_EQ(locate(exact(Vec3{0, 0, 0}), shells), (Location{true, 0}));
  // On the line of an edge, and in the plane of a face, but off the mesh.
  EXPECT_EQ(locate(exact(Vec3{-1, 0, 0}), shells), (Location{false, 0}));
  EXPECT_EQ(locate(exact(Vec3{-1, -1, 0}), shells), (Location{false, 0}));
}

TEST(OracleMeshes, AHollowSolidHoldsWhatIsInItsWallOnly) {
  const MeshSet hollow = solid(joined(box_between({0, 0, 0}, {4, 4, 4}), inverted_box_mesh({1, 1, 1}, {3, 3, 3})));
  EXPECT_EQ(both_ways(hollow, solid(box_between({1.5, 1.5, 1.5}, {2, 2, 2}))), apart);
  EXPECT_EQ(both_ways(hollow, solid(box_between({1, 1, 1}, {3, 3, 3}))), touching);
  EXPECT_EQ(both_ways(hollow, solid(box_between({0.5, 0.5, 0.5}, {3.5, 3.5, 3.5}))), overlapping());
  EXPECT_EQ(both_ways(hollow, solid(box_between({0, 0, 0}, {1, 1, 1}))), overlapping(Containment::b_in_a));
  EXPECT_EQ(both_ways(hollow, solid(box_between({0, 0, 0}, {4, 4, 4}))), overlapping(Containment::a_in_b));
}

TEST(OracleMeshes, FacesInsideASolidDoNotSplitWhatItHolds) {
  // Two boxes that share a slab, as one solid; its union is a box.
  const MeshSet shells = solid(joined(box_between({0, 0, 0}, {2, 1, 1}), box_between({1, 0, 0}, {3, 1, 1})));
  EXPECT_EQ(both_ways(shells, solid(box_between({0, 0, 0}, {3, 1, 1}))), overlapping(Containment::equal));
  EXPECT_EQ(both_ways(shells, solid(box_between({0.5, 0.25, 0.25}, {2.5, 0.5, 0.5}))),
            overlapping(Containment::b_in_a));
  // A sheet in a plane where a face lies inside the solid is on its boundary there.
  const MeshSet sheet = surface(single_triangle({1, 0.25, 0.25}, {1, 0.5, 0.25}, {1, 0.25, 0.5}));
  EXPECT_EQ(both_ways(sheet, shells), touching);
}

TEST(OracleMeshes, ADoubledSheetHasNoInterior) {
  const MeshSet sheet = solid(joined(single_triangle({0.25, 0.25, 0.5}, {0.75, 0.25, 0.5}, {0.25, 0.75, 0.5}),
                                     single_triangle({0.25, 0.25, 0.5}, {0.25, 0.75, 0.5}, {0.75, 0.25, 0.5})));
  EXPECT_EQ(both_ways(sheet, solid(unit_box)), touching);
  EXPECT_EQ(both_ways(sheet, sheet), touching);
}

TEST(OracleMeshes, SurfacesAndSolids) {
  const MeshSet box = solid(unit_box);
  EXPECT_EQ(both_ways(surface(single_triangle({0.25, 0.25, 0.5}, {0.5, 0.25, 0.5}, {0.25, 0.5, 0.5})), box),
            crossing(Containment::a_in_b));
  EXPECT_EQ(both_ways(surface(single_triangle({0.25, 0.25, 1}, {0.5, 0.25, 0.5}, {0.25, 0.5, 0.5})), box), crossing());
  EXPECT_EQ(both_ways(surface(single_triangle({0.25, 0.25, 1}, {0.5, 0.25, 1}, {0.25, 0.5, 1})), box), touching);
  EXPECT_EQ(both_ways(surface(single_triangle({0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5})), box), crossing());
  EXPECT_EQ(both_ways(surface(single_triangle({-1, 0.5, 0.5}, {2, 0.5, 0.5}, {2, 0.5, 0.5})), box), crossing());
  EXPECT_EQ(both_ways(surface(single_triangle({2, 0.5, 0.5}, {3, 0.5, 0.5}, {3, 3, 0.5})), box), apart);
  EXPECT_EQ(both_ways(surface(unit_box), box), touching);
  EXPECT_EQ(both_ways(surface(box_between({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5})), box), crossing(Containment::a_in_b));
}

TEST(OracleMeshes, Surfaces) {
  const MeshSet box = surface(unit_box);
  EXPECT_EQ(both_ways(box, surface(box_between({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5}))), apart);
  EXPECT_EQ(both_ways(box, surface(unit_box)), surfaces_touching);
  EXPECT_EQ(both_ways(box, surface(unit_box, Pose::translation(0.5, 0.25, 0.125))), crossing());
  // An edge through a quad exactly along its diagonal only touches: the faces are the triangles.
  const MeshSet blade = surface(single_triangle({0.25, 0.25, 0.5}, {0.75, 0.75, 0.5}, {0.5, 0.5, 2}));
  EXPECT_FALSE(surfaces_cross(blade, surface(joined(single_triangle({0, 0, 1}, {1, 0, 1}, {1, 1, 1}),
                                                    single_triangle({0, 0, 1}, {1, 1, 1}, {0, 1, 1})))));
}

TEST(OracleMeshes, PairsAscendAndSwap) {
  const MeshSet a = solid(unit_box);
  const MeshSet b = solid(unit_box, Pose::translation(0.5, 0.25, 0.125));
  const std::vector<TrianglePair> forward = intersecting_pairs(a, b);
  EXPECT_TRUE(std::ranges::is_sorted(forward));
  std::vector<TrianglePair> backward;
  for (const TrianglePair& pair : intersecting_pairs(b, a)) backward.push_back({pair.b, pair.a});
  std::ranges::sort(backward);
  EXPECT_EQ(forward, backward);
  EXPECT_EQ(first_intersecting_pair(a, b), forward.front());
  EXPECT_EQ(first_intersecting_pair(a, solid(unit_box, Pose::translation(3, 0, 0))), std::nullopt);
}

TEST(OracleMeshes, Distances) {
  const MeshSet box = solid(unit_box);
  EXPECT_EQ(squared_distance(box, solid(unit_box, Pose::translation(4, 5, 0))), 25);
  EXPECT_EQ(squared_distance(box, solid(box_between({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5}))), 0);
  EXPECT_EQ(squared_distance(surface(unit_box), surface(box_between({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5}))),
            Rational(1, 16));
}

TEST(OracleMeshes, HeightFieldsSplitAlongTheirDiagonal) {
  const std::vector<Vec3> grid{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 0}};
  const MeshSet field = height_field_set(grid, 2, 2);
  ASSERT_EQ(field.triangles.size(), 2U);
  // Along the diagonal from (0, 0) to (1, 1) the field is at height 0; the other diagonal would be at 1.
  const RationalPoint middle{Rational(1, 2), Rational(1, 2), 0};
  EXPECT_TRUE(contains(field.triangles[0], middle));
  EXPECT_TRUE(contains(field.triangles[1], middle));
}

TEST(OracleMeshes, RandomBoxesAgreeWithTheirCoordinates) {
  const std::uint64_t seed = 9;
  Random random(seed);
  const auto corner = [&](Vec3 low) {
    return Vec3{low.x + 1 + static_cast<double>(random.below(2)), low.y + 1 + static_cast<double>(random.below(2)),
                low.z + 1 + static_cast<double>(random.below(2))};
  };
  for (int round = 0; round < 6; ++round) {
    const Vec3 low{static_cast<double>(random.below(3)), static_cast<double>(random.below(3)), 0};
    const Vec3 high = corner(low);
    const Vec3 other_high = corner({});
    int deep = 0;
    int shallow = 0;
    bool a_in_b = true;
    bool b_in_a = true;
    for (int axis = 0; axis < 3; ++axis) {
      const double depth = std::min(high[axis], other_high[axis]) - std::max(low[axis], 0.0);
      deep += depth > 0 ? 1 : 0;
      shallow += depth >= 0 ? 1 : 0;
      a_in_b = a_in_b && low[axis] >= 0 && high[axis] <= other_high[axis];
      b_in_a = b_in_a && low[axis] <= 0 && high[axis] >= other_high[axis];
    }
    Relation expected = deep == 3 ? overlapping() : shallow == 3 ? touching : apart;
    if (a_in_b || b_in_a)
      expected.containment = a_in_b && b_in_a ? Containment::equal : a_in_b ? Containment::a_in_b : Containment::b_in_a;
    EXPECT_EQ(both_ways(solid(box_between(low, high)), solid(box_between({}, other_high))), expected)
        << "seed " << seed << " round " << round;
  }
}

}  // namespace
}  // namespace toccata::oracle::of_meshes
