// What check_all tells of a clash beside its relation: kind, volume, a point of both, and how it stands to a tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "query/slow_solids.hpp"
#include "support/error_message.hpp"
#include "support/mesh_soups.hpp"
#include "support/relation_cases.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata::test {
namespace {

PairAnswer only_pair(const Model& a, const Model& b, const Pose& pose_b, const CheckOptions& options) {
  const std::vector<SceneInstance> models{{.model = a, .name = "a"}, {.model = b, .pose = pose_b, .name = "b"}};
  const CheckAnswer answer = check_all(models, options);
  EXPECT_EQ(answer.pairs.size(), 1U);
  return answer.pairs.empty() ? PairAnswer{} : answer.pairs[0];
}

PairAnswer only_pair(const TriangleMesh& a, const TriangleMesh& b, const Pose& pose_b, const CheckOptions& options) {
  return only_pair(Model(a), Model(b), pose_b, options);
}

using ClashKind = PairAnswer::Kind;
using ToleranceVerdict = PairAnswer::Tolerance;

const CheckOptions with_volume{.volume = true}, with_both{.penetration = true, .volume = true};

TriangleMesh box_at(const Vec3& half, const Vec3& middle) { return placed(box_mesh(half), 1, middle); }

TEST(CheckClashes, ARodThroughAPlatePiercesAndItsEndInItProtrudes) {
  const TriangleMesh plate = box_mesh({1, 1, 0.1}), rod = box_mesh({0.1, 0.2, 1});
  const PairAnswer through = only_pair(plate, rod, {}, with_volume);
  EXPECT_EQ(through.kind, ClashKind::pierce);
  ASSERT_TRUE(through.volume);
  EXPECT_NEAR(through.volume->upper, 0.2 * 0.4 * 0.2, 1e-12);
  EXPECT_EQ(only_pair(plate, rod, Pose::translation(0.3, 0.1, 1), with_volume).kind, ClashKind::protrude);
  EXPECT_EQ(only_pair(plate, rod, Pose::translation(0.3, 0.1, 1), with_both).kind, ClashKind::protrude);
  EXPECT_EQ(only_pair(plate, rod, {}, with_both).kind, ClashKind::pierce);
  EXPECT_EQ(only_pair(plate, rod, {}, {.penetration = true}).kind, ClashKind::overlap);
  EXPECT_EQ(only_pair(plate, rod, {}, {}).kind, ClashKind::overlap);
}

TEST(CheckClashes, WhatPiercesIsToldInEitherOrder) {
  using Piercing = PairAnswer::Piercing;
  const auto piercing = [](const Model& a, const Model& b) { return only_pair(a, b, {}, with_volume).piercing; };
  const Model plate(box_mesh({1, 1, 0.1})), rod(placed(prism_mesh(0.2, 4, 12), 1, {0, 0, -2})),
      bar(box_mesh({0.3, 3, 0.3}));
  EXPECT_EQ(piercing(plate, rod), Piercing::b_through_a);
  EXPECT_EQ(piercing(rod, plate), Piercing::a_through_b);
  EXPECT_EQ(piercing(rod, bar), Piercing::a_through_b);
  EXPECT_EQ(piercing(Model(Box({1, 1, 0.1})), Model(Cylinder(0.2, 1))), Piercing::b_through_a);
  EXPECT_EQ(piercing(Model(Cylinder(0.2, 1)), Model(Box({1, 1, 0.1}))), Piercing::a_through_b);
  const PairAnswer of_one_width = only_pair(box_mesh({0.3, 0.3, 2}), box_mesh({2, 0.3, 0.3}), {}, with_volume);
  EXPECT_EQ(of_one_width.piercing,
            of_one_width.kind == ClashKind::pierce ? Piercing::unknown : PairAnswer::Piercing::none);
  EXPECT_EQ(only_pair(plate, rod, Pose::translation(0, 0, 2), with_volume).piercing, Piercing::none);
  const Model drill(joined({box_at({0.1, 0.1, 2}, {0.5, 0, 0}), box_at({0.5, 0.5, 0.05}, {-2, 0, 0})})),
      target(joined({box_at({0.4, 0.4, 0.1}, {0.5, 0, 0}), box_at({0.1, 0.1, 2}, {-2, 0, 0})}));
  EXPECT_EQ(piercing(drill, target), Piercing::unknown);
}

TEST(CheckClashes, OfOverlappingShellsItIsNotToldThatOnePierces) {
  const TriangleMesh block = box_mesh({1, 1, 1}),
                     shells = joined({box_at({0.2, 0.2, 0.5}, {0, 0, 1.4}), box_at({0.2, 0.2, 0.5}, {0.1, 0.1, 1.3})}),
                     ends = joined({box_at({0.2, 0.2, 0.9}, {0, 0, 0.7}), box_at({0.1, 0.1, 0.9}, {0, 0, -0.7})});
  for (const CheckOptions& options : {with_volume, with_both}) {
    EXPECT_EQ(only_pair(block, shells, {}, options).kind, ClashKind::overlap);
    EXPECT_EQ(only_pair(block, ends, {}, options).kind, ClashKind::overlap);  // together they do
  }
}

TEST(CheckClashes, AForkInAPlateProtrudesAtTwoPlaces) {
  const std::vector<Vec2> fork = {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  const TriangleMesh plate = box_mesh({9, 1, 9}), prongs = extruded_mesh(fork, 0.5);
  const Pose upside_down{{{Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}}}, {0, 3.5, 0}};
  EXPECT_EQ(only_pair(plate, prongs, upside_down, with_volume).kind, ClashKind::protrude);
}

/// At even distances, so that points between two feet may lie in others.
TEST(CheckClashes, FeetInARowProtrude) {
  for (const int count : {2, 5, 8}) {
    std::vector<TriangleMesh> feet;
    for (int i = 0; i < count; ++i) feet.push_back(box_at({0.3, 0.3, 0.3}, {1.0 * i, 0, 0.75}));
    const PairAnswer pair =
        only_pair(box_at({0.5 * count, 0.5, 0.5}, {0.5 * count - 0.5, 0, 0}), joined(feet), {}, with_both);
    EXPECT_EQ(pair.kind, ClashKind::protrude) << count;
    EXPECT_EQ(pair.regions.size(), static_cast<std::size_t>(count));
  }
}

TEST(CheckClashes, OfWhatEndsInAFaceTheKindIsTheSameInEitherOrder) {
  const TriangleMesh plate = box_mesh({1, 1, 0.1});
  for (const double far : {-0.1, 0.1})
    for (const Vec3& half : {Vec3{0.1, 0.2, 0.5}, Vec3{0.2, 0.1, 0.5}}) {
      const TriangleMesh rod = box_at(half, {0.3, 0.1, far + (far < 0 ? 0.5 : -0.5)});
      const PairAnswer one = only_pair(plate, rod, {}, with_volume), other = only_pair(rod, plate, {}, with_volume);
      EXPECT_EQ(one.kind, other.kind) << far;
      EXPECT_EQ(one.piercing == PairAnswer::Piercing::b_through_a, other.piercing == PairAnswer::Piercing::a_through_b);
    }
}

TEST(CheckClashes, ShapesAreToldTheSameWay) {
  EXPECT_EQ(only_pair(Model(Box({1, 1, 0.1})), Model(Cylinder(0.2, 1)), {}, with_volume).kind, ClashKind::pierce);
  EXPECT_EQ(only_pair(Model(Sphere(1)), Model(Sphere(1)), Pose::translation(1.5, 0, 0), with_volume).kind,
            ClashKind::protrude);
}

TEST(CheckClashes, OtherKindsFollowTheRelation) {
  const TriangleMesh box = box_mesh({1, 1, 1}), small = box_mesh({0.5, 0.5, 0.5});
  EXPECT_EQ(only_pair(box, small, {}, with_volume).kind, ClashKind::contains);
  EXPECT_EQ(only_pair(box, box, {}, with_volume).kind, ClashKind::equal);
  EXPECT_EQ(only_pair(box, box, Pose::translation(2, 0, 0), with_volume).kind, ClashKind::touching);
  EXPECT_EQ(only_pair(box, box, Pose::translation(2.5, 0, 0), {.clearance = 1}).kind, ClashKind::clearance);
  EXPECT_EQ(only_pair(box, height_field_mesh({}), {}, with_volume).kind, ClashKind::crossing);
  EXPECT_FALSE(only_pair(box, height_field_mesh({}), {}, with_volume).volume);
}

TEST(CheckClashes, ThePointIsOfBoth) {
  const Model gear(gear_mesh({.teeth = 9})), torus(torus_mesh({.tube_radius = 0.3, .around = 24, .sides = 12}));
  for (const double apart : {0.1, 0.7, 1.2}) {
    const Pose pose = Pose::translation(apart, 0.2, 0.1);
    const PairAnswer pair = only_pair(gear, torus, pose, with_volume);
    ASSERT_TRUE(pair.common_point) << apart;
    EXPECT_EQ(signed_distance(*pair.common_point, gear).side, Side::inside) << apart;
    EXPECT_EQ(signed_distance(*pair.common_point, torus, pose).side, Side::inside) << apart;
  }
}

TEST(CheckClashes, ThePointIsOffBothSurfacesWithDepthsToo) {
  const Model block(box_mesh({1, 1, 1})), ball(icosphere_mesh(1, 2)), wedge(prism_mesh(0.5, 1, 3));
  const double c = std::sqrt(0.5);
  const Pose on_edge{{{Vec3{1, 0, 0}, Vec3{0, c, -c}, Vec3{0, c, c}}}, {0.25, 0.125, 2.25}};
  for (const auto& [a, b, pose] :
       {std::tuple(&block, &block, Pose::translation(1.75, 0.5, 0.25)), std::tuple(&block, &block, on_edge),
        std::tuple(&block, &ball, Pose::translation(0, 0, 1.75)),
        std::tuple(&block, &wedge, Pose::translation(0.25, 0.5, 0.9375))}) {
    const PairAnswer pair = only_pair(*a, *b, pose, with_both);
    ASSERT_TRUE(pair.common_point);
    for (const auto& [model, place] : {std::pair(a, Pose{}), std::pair(b, pose)}) {
      const SignedDistance from = signed_distance(*pair.common_point, *model, place);
      EXPECT_EQ(from.side, Side::inside);
      EXPECT_LT(from.upper, 0);
    }
  }
}

/// A slab between the wall of a hollow and what is too wide for it, whose deepest points lie on edges.
TEST(CheckClashes, ThePointOfASlabIsTold) {
  TriangleMesh cavity = box_mesh({1, 1, 1});
  std::vector<std::array<Index, 3>> turned(cavity.triangles().begin(), cavity.triangles().end());
  for (std::array<Index, 3>& triangle : turned) std::swap(triangle[1], triangle[2]);
  const std::vector<Vec3> corners(cavity.vertices().begin(), cavity.vertices().end());
  const Model hollow(joined({box_mesh({1.5, 1.5, 1.5}), TriangleMesh(corners, turned)})),
      inner(box_mesh({0.5, 0.5, 0.5}));
  for (const double y : {0.0, 0.5}) {
    const Pose pose = Pose::translation(0.55, y, 0);
    const PairAnswer pair = only_pair(hollow, inner, pose, with_volume);
    ASSERT_TRUE(pair.common_point) << y;
    EXPECT_EQ(signed_distance(*pair.common_point, hollow).side, Side::inside);
    EXPECT_LT(signed_distance(*pair.common_point, inner, pose).upper, 0);
  }
}

/// The middle of what the boxes have in common lies in neither of its parts, and their surfaces do not meet.
TEST(CheckClashes, ThePointOfAPartThatLiesWithinIsTold) {
  const Model block(box_mesh({1, 1, 1})),
      parts(joined({box_at({0.1, 0.1, 0.1}, {-0.5, -0.5, 0}), box_at({0.1, 0.1, 0.1}, {2, 2, 0})}));
  const PairAnswer pair = only_pair(block, parts, {}, with_volume);
  EXPECT_EQ(pair.kind, ClashKind::overlap);
  ASSERT_TRUE(pair.common_point);
  EXPECT_EQ(signed_distance(*pair.common_point, block).side, Side::inside);
  EXPECT_LT(signed_distance(*pair.common_point, parts).upper, 0);
}

TEST(CheckClashes, AnOverlapIsHeldAgainstTheTolerance) {
  const TriangleMesh box = box_mesh({1, 1, 1});
  const auto verdict = [&](double by, double tolerance) {
    return only_pair(box, box, Pose::translation(by, 0.25, 0.125), {.tolerance = tolerance}).tolerance;
  };
  EXPECT_EQ(verdict(1.75, 0.5), ToleranceVerdict::within);
  EXPECT_EQ(verdict(1.75, 0.125), ToleranceVerdict::beyond);
  EXPECT_EQ(verdict(2, 0.125), ToleranceVerdict::none);
  EXPECT_EQ(only_pair(box, box, Pose::translation(1.75, 0, 0), {}).tolerance, ToleranceVerdict::none);
}

/// How it stands to the tolerance, and that the depth which decided it says so.
PairAnswer held_against(double tolerance, const Model& a, const Model& b, const Pose& pose_b = {},
                        bool penetration = false) {
  PairAnswer pair = only_pair(a, b, pose_b, {.penetration = penetration, .tolerance = tolerance});
  if (!pair.local_depth) return pair;
  EXPECT_TRUE(pair.tolerance == ToleranceVerdict::within || pair.tolerance == ToleranceVerdict::beyond);
  const bool is_within = pair.tolerance == ToleranceVerdict::within;
  EXPECT_EQ(pair.local_depth->upper <= tolerance, is_within);
  EXPECT_EQ(pair.local_depth->lower > tolerance, !is_within);
  return pair;
}

TEST(CheckTolerance, OfMeshesThatHoldEachOtherIsOfTheirDeepestPlace) {
  const std::vector<Vec2> outline = {{-2, -1}, {2, -1}, {2, 2}, {1, 2}, {1, 0}, {-1, 0}, {-1, 2}, {-2, 2}};
  const Model channel(extruded_mesh(outline, 4)), crate(box_mesh({1.05, 0.9, 0.9}));  // 0.05 too wide on each side
  const Pose in_it = Pose::translation(0, 1.2, 2);
  EXPECT_GT(only_pair(channel, crate, in_it, {.penetration = true}).penetration->lower, 0.09);  // to one side: into it
  const TriangleMesh pin = prism_mesh(0.5, 2, 48);
  const Model hole(negative_image(pin, 1)), thick(pin);  // a pin too thick for its hole by 0.05
  const Pose pressed{{{Vec3{1.1, 0, 0}, Vec3{0, 1.1, 0}, Vec3{0, 0, 0.5}}}, {0, 0, 0.5}};
  for (const bool penetration : {false, true}) {
    for (const auto& [a, b, pose] : {std::tuple(&channel, &crate, in_it), std::tuple(&hole, &thick, pressed)}) {
      const PairAnswer within = held_against(0.06, *a, *b, pose, penetration);
      EXPECT_EQ(within.tolerance, ToleranceVerdict::within);
      EXPECT_TRUE(within.local_depth);
      const PairAnswer beyond = held_against(0.04, *a, *b, pose, penetration);
      EXPECT_EQ(beyond.tolerance, ToleranceVerdict::beyond);
      EXPECT_TRUE(beyond.local_depth);
    }
  }
}

TEST(CheckTolerance, OfFoilsThatCrossIsHalfOfWhatBothAreThick) {
  const Model lying(box_mesh({5, 5, 0.02})), standing(box_mesh({0.015, 5, 5}));
  EXPECT_GT(only_pair(lying, standing, {}, {.penetration = true}).penetration->lower, 4);
  EXPECT_EQ(held_against(0.036, lying, standing).tolerance, ToleranceVerdict::within);
  EXPECT_EQ(held_against(0.034, lying, standing).tolerance, ToleranceVerdict::beyond);
}

TEST(CheckTolerance, OneDeepPlaceIsBeyondIt) {
  const std::vector<Vec2> outline = {{0, 0}, {1, 0}, {1, 2}, {3, 2}, {3, 0.5}, {4, 0.5}, {4, 3}, {0, 3}};
  const Model floor(box_mesh({9, 1, 9})), bench(extruded_mesh(outline, 0.5));
  const Pose pose = Pose::translation(0, 0.25, 0);  // 0.75 and 0.25 deep
  EXPECT_EQ(held_against(0.3, floor, bench, pose).tolerance, ToleranceVerdict::beyond);
  EXPECT_EQ(held_against(0.7, floor, bench, pose).tolerance, ToleranceVerdict::beyond);
  EXPECT_EQ(held_against(0.8, floor, bench, pose).tolerance, ToleranceVerdict::within);
}

/// Cubes side by side as one mesh, of which the faces between two lie within the whole.
TriangleMesh bricks(const Vec3& from) {
  std::vector<TriangleMesh> cubes;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z)
        cubes.push_back(box_at({0.125, 0.125, 0.125}, from + 0.25 * Vec3{1.0 * x, 1.0 * y, 1.0 * z}));
  return joined(cubes);
}

TEST(CheckTolerance, SurfacesWithinASolidDoNotMakeItShallow) {
  const Model wall(bricks({0, 0, 0})), other(bricks({0.3, 0.2, 0.1}));  // about 0.7 in each other
  const PairAnswer of_bricks = held_against(0.3, wall, other);
  EXPECT_EQ(of_bricks.tolerance, ToleranceVerdict::beyond);
  EXPECT_FALSE(of_bricks.local_depth);  // nowhere farther than 0.25 from both surfaces
  std::vector<TriangleMesh> shells;
  for (int i = 1; i <= 10; ++i) shells.push_back(box_mesh({0.1 * i, 0.1 * i, 0.1 * i}));
  const Model onion(joined(shells));
  const PairAnswer of_shells = held_against(0.25, onion, onion, Pose::translation(0.05, 0.05, 0.5));
  EXPECT_EQ(of_shells.tolerance, ToleranceVerdict::beyond);
  EXPECT_FALSE(of_shells.local_depth);
}

/// A rectangle from both sides, which has no inside.
TriangleMesh sheet(const Vec3& from, const Vec3& to) {
  const Vec3 p{to.x, from.y, from.z}, q{from.x, to.y, to.z};
  return {{from, p, to, q}, {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}}};
}

TEST(CheckTolerance, ASheetThatReachesIntoASolidDoesNotMakeItDeep) {
  const Model block(box_at({2, 2, 2}, {2.875, 0, 0})),  // 0.125 deep, and the sheet 1.0625 from all its faces
      with_sheet(joined({box_mesh({1, 1, 1}), sheet({1, -0.5, 0}, {3, 0.5, 0})}));
  const CheckOptions options{.depth = {.precision = 1}, .tolerance = 0.25};
  EXPECT_NE(only_pair(block, with_sheet, {}, options).tolerance, ToleranceVerdict::beyond);
  EXPECT_NE(only_pair(with_sheet, block, {}, options).tolerance, ToleranceVerdict::beyond);
  const std::vector<ContactRegion> regions = contact_regions(with_sheet, block);
  ASSERT_FALSE(regions.empty());
  for (const ContactRegion& region : regions) {
    ASSERT_TRUE(region.depth);
    EXPECT_LE(region.depth->lower, 0.125);
  }
}

TEST(CheckTolerance, AShellInsideCountsBesideAShallowPlace) {
  const Model block(box_mesh({2, 2, 2})),
      two(joined({box_at({0.5, 0.5, 0.5}, {0, 0, 0}), box_at({0.5, 0.5, 0.5}, {0, 0, 2.45})}));
  EXPECT_TRUE(only_pair(block, two, {}, {.penetration = true}).regions.size() == 1);
  EXPECT_EQ(held_against(0.1, block, two).tolerance, ToleranceVerdict::beyond);
}

TEST(CheckTolerance, OfOneInsideTheOtherIsByWhatPartsThem) {
  const Model block(box_mesh({2, 2, 2})), small(box_mesh({0.5, 0.5, 0.5}));
  const PairAnswer held = held_against(3, block, small, Pose::translation(0, 0, 1));
  EXPECT_EQ(held.tolerance, ToleranceVerdict::within);
  EXPECT_FALSE(held.local_depth);
  EXPECT_TRUE(held.penetration);
}

TEST(CheckTolerance, OfMovesThatAreWithinItIsWithin) {
  Random random(20261130);
  const std::vector<TriangleMesh> meshes = some_solids();
  int within = 0;
  for (int i = 0; i < 60; ++i) {
    const Model a(meshes[random.below(meshes.size())]), b(meshes[random.below(meshes.size())]);
    const Pose pose{random_rotation(random), random_vector(random, 1)};
    const std::vector<SceneInstance> both{{.model = a}, {.model = b, .pose = pose}};
    const CheckAnswer deep = check_all(both, {.penetration = true});
    if (deep.pairs.empty() || !deep.pairs[0].penetration || deep.pairs[0].penetration->upper == 0) continue;
    const Penetration& parts = *deep.pairs[0].penetration;
    const CheckAnswer held = check_all(both, {.tolerance = parts.upper * (1 + 1e-9)});
    EXPECT_EQ(held.pairs[0].tolerance, ToleranceVerdict::within) << i;
    ++within;
    const std::vector<SceneInstance> exchanged{both[1], both[0]};
    for (const double share : {0.3, 0.6, 0.9}) {
      const double tolerance = share * parts.upper;
      const PairAnswer one = check_all(both, {.tolerance = tolerance}).pairs[0],
                       other = check_all(exchanged, {.tolerance = tolerance}).pairs[0];
      EXPECT_EQ(one.tolerance, other.tolerance) << i << ", " << share;
      EXPECT_EQ(one.local_depth, other.local_depth) << i << ", " << share;
      if (!one.local_depth) continue;
      EXPECT_LE(one.local_depth->lower, parts.upper * (1 + 1e-9)) << i;
      const double deepest = deep.pairs[0].regions.empty() ? 0 : deep.pairs[0].regions[0].depth->lower;
      EXPECT_LE(deepest, one.local_depth->upper) << i << ", " << share;
    }
  }
  EXPECT_GT(within, 20);
}

TEST(CheckTolerance, WhereTheBracketHoldsItItIsAskedMorePrecisely) {
  const Model ball(Sphere(1)), gear(gear_mesh({.teeth = 9}));
  const Pose pose = Pose::translation(1.3, 0.2, 0.1);
  const PairAnswer wide = only_pair(ball, gear, pose, {.penetration = true, .depth = {.precision = 0.5}});
  ASSERT_TRUE(wide.penetration);
  ASSERT_LT(wide.penetration->lower, wide.penetration->upper);
  const double between = 0.5 * (wide.penetration->lower + wide.penetration->upper);
  const PairAnswer asked = only_pair(ball, gear, pose, {.depth = {.precision = 0.5}, .tolerance = between});
  ASSERT_TRUE(asked.penetration);
  EXPECT_LE(asked.penetration->upper - asked.penetration->lower, wide.penetration->upper - wide.penetration->lower);
  const bool is_within = asked.penetration->upper <= between, is_beyond = asked.penetration->lower > between;
  EXPECT_EQ(asked.tolerance, is_within   ? ToleranceVerdict::within
                             : is_beyond ? ToleranceVerdict::beyond
                                         : ToleranceVerdict::undecided);
}

TEST(CheckClashes, WhatHasNoDepthIsUndecided) {
  const PairAnswer pair = only_pair(box_mesh({1, 1, 1}), height_field_mesh({}), {}, {.tolerance = 100});
  EXPECT_EQ(pair.tolerance, ToleranceVerdict::undecided);
  EXPECT_FALSE(pair.penetration);
}

TEST(CheckClashes, AToleranceThatIsNoLengthIsRefused) {
  const std::vector<SceneInstance> none;
  EXPECT_NE(message_of([&] { static_cast<void>(check_all(none, {.tolerance = -1})); }).find("the tolerance is -1"),
            std::string::npos);
}

}  // namespace
}  // namespace toccata::test
