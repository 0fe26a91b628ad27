// The least depth of quadrics by one place: how often it is found, and what it must not be taken for.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "narrow/quadric_cases.hpp"
#include "narrow/quadrics/depth/lowest_place.hpp"
#include "narrow/quadrics/depth/quadric_expansion.hpp"
#include "oracle/quadric_contact.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/math/pose.hpp"

namespace toccata::test {
namespace {

template <class B>
std::optional<LowestPlace> place_of(const PosedQuadric& a, const B& b) {
  const PairFrame frame = pair_frame(a, b);
  return lowest_place(QuadricBody(a, frame), QuadricBody(b, frame));
}

/// B is brought along a direction until the shapes are as deep as that.
template <class A, class B>
B brought_to(const A& a, const auto& shape, const Mat3& turned, const Vec3& direction, double depth) {
  double near = 0, far = 8;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (near + far);
    const Penetration found = penetration(a, B(shape, {turned, middle * direction}));
    (found.upper > depth ? near : far) = middle;
  }
  return B(shape, {turned, near * direction});
}

struct Found {
  int places = 0;
  int of = 0;
};

template <class B>
void look(Found& found, const auto& shape_a, const auto& shape_b, double depth, Random& random) {
  const PosedQuadric a(shape_a, {random_rotation(random), {}});
  const B b = brought_to<PosedQuadric, B>(a, shape_b, random_rotation(random), quadric_direction(random), depth);
  const Penetration deep = penetration(a, b);
  const std::optional<LowestPlace> place = place_of(a, b);
  ++found.of;
  if (!place) return;
  ++found.places;
  EXPECT_GE(deep.lower, deep.upper * (1 - 1e-12) - 1e-15);
  // The points lie across from each other, each on its shape.
  const Vec3 between = deep.on_a - deep.on_b;
  EXPECT_LE(length(between - deep.upper * deep.direction), 1e-12);
  EXPECT_LE(distance(PosedPolytope(Point{}, Pose::translation(deep.on_a)), a).upper, 1e-12);
  EXPECT_LE(distance(PosedPolytope(Point{}, Pose::translation(deep.on_b)), b).upper, 1e-12);
}

TEST(LowestPlace, IsFoundOfNearlyAllThatHardlyMeets) {
  Random random(5);
  for (const double depth : {1e-1, 1e-2, 1e-4, 1e-7}) {
    Found found;
    for (int i = 0; i < 12; ++i) {
      look<PosedQuadric>(found, Ellipsoid({1, 0.75, 1.25}), Ellipsoid({0.75, 1, 1}), depth, random);
      look<PosedQuadric>(found, Cylinder(1, 1), Cylinder(0.75, 1), depth, random);
      look<PosedQuadric>(found, Cone(1, 1), Ellipsoid({0.75, 1, 1}), depth, random);
      look<PosedPolytope>(found, Cylinder(1, 1), Box({1, 0.75, 1.25}), depth, random);
      look<PosedPolytope>(found, Cone(1, 1), Box({1, 0.75, 1.25}), depth, random);
      look<PosedPolytope>(found, Ellipsoid({1, 0.75, 1.25}), Capsule({0, 0, -1}, {0, 0, 1}, 0.5), depth, random);
    }
    EXPECT_GE(found.places, 0.8 * found.of) << depth;
  }
}

/// The depth is that one. Where another place is taken for the lowest, `lower` is more.
template <class B>
void expect_depth(const PosedQuadric& a, const B& b, double depth) {
  const Penetration found = penetration(a, b);
  EXPECT_LE(found.lower, depth * (1 + 1e-14));
  EXPECT_GE(found.upper, depth * (1 - 1e-14));
  EXPECT_GE(found.lower, depth * (1 - 1e-9));
}

// A blade and a plate overlap by a quarter along themselves, as far as the directions next to that tell, and across it
// by what they are thick.
TEST(LowestPlace, IsNotTakenWhereOneAsideIsLower) {
  for (const double thick : {0.01, 0.05, 0.1}) {
    const Penetration found =
        penetration(PosedQuadric(Ellipsoid({1, 1, thick}), Pose::translation(-0.875, 0.1, 0.2 * thick)),
                    PosedPolytope(Box({1, 4, thick}), Pose::translation(0.875, 0, 0)));
    EXPECT_LE(found.upper, 2 * thick * (1 + 1e-12));
    EXPECT_LE(found.lower, found.upper);
    EXPECT_GE(found.lower, found.upper * (1 - 1e-9));
  }
}

/// A plate, whose first corner and whose last lie on its upper side: what counts as its middle does, too.
ConvexHull plate(double wide) {
  std::vector<Vec3> corners{{-wide, -4, 0.05}};
  for (const double z : {-0.05, 0.05})
    for (const double x : {-wide, wide})
      for (const double y : {-4.0, 4.0})
        if (z < 0 || x * y < 0) corners.push_back({x, y, z});
  corners.push_back({wide, 4, 0.05});
  return ConvexHull(corners);
}

// A ball in a plate, nearer to the lower side. Whatever lies aside is far away, or a little farther.
TEST(LowestPlace, IsNotTakenWhereTheOneBehindIsLower) {
  for (const double wide : {4.0, 0.12}) {
    const ConvexHull around = plate(wide);
    expect_depth(PosedQuadric(Ellipsoid({0.03, 0.03, 0.03}), Pose::translation(0.01, 0.003, 0.01)),
                 PosedPolytope(around), 0.07);
  }
}

// A grain in a spike that stands on its tip: its upper end is no farther than its flanks, across, but farther than they
// are along their normals.
TEST(LowestPlace, IsNotTakenWhereOneAsideAndBehindIsLower) {
  const double half = 1.1, height = 10, aside = 0.02;
  const double flank = (half * (height - 1) - height * aside) / std::sqrt(half * half + height * height);
  const ConvexHull spike(
      std::vector<Vec3>{{half, half, 1}, {-half, half, 1}, {-half, -half, 1}, {half, -half, 1}, {0, 0, 1 - height}});
  const double grain = 0x1p-10;
  expect_depth(PosedQuadric(Ellipsoid({grain, grain, grain}), Pose::translation(0.01, aside, 0)), PosedPolytope(spike),
               flank + grain);
}

// A rod stands upright in a can next to its side: it leaves over the rim by less than its end lies under the lid.
TEST(LowestPlace, IsNoFlatEndWhoseRimIsNearer) {
  const Penetration found = penetration(PosedQuadric(Cylinder(1, 1)),
                                        PosedQuadric(Ellipsoid({0.05, 0.05, 20}), Pose::translation(0.9, 0, 20.8)));
  EXPECT_LT(found.upper, 0.11);
  EXPECT_LE(found.lower, found.upper);
  EXPECT_GE(found.lower, found.upper * (1 - 1e-9));
}

// Of a wedge that lies within a flat can, its tip below the middle and its back above.
TEST(LowestPlace, IsNoFlatEndWhereTheOtherOneIsNearer) {
  const ConvexHull wedge(std::vector<Vec3>{{0.05, 0, 0.03}, {0, 0, -0.05}, {-0.05, 0.05, 0.03}, {-0.05, -0.05, 0.03}});
  expect_depth(PosedQuadric(Cylinder(4, 0.1)), PosedPolytope(wedge), 0.13);
}

// A plate that stands half out of a crate is deeper along itself than across it, and lowest there as far as one place
// tells.
TEST(LowestPlace, IsNotTakenWhereAnotherOneIsLower) {
  const PosedPolytope crate(Box({1, 1, 1}));
  for (const double thick : {0.01, 0.05, 0.25}) {
    const PosedQuadric disc(Cylinder(1, thick), {rotation_about({1, 0, 0}, 90), {1.875, 0, 0.5}});
    const PosedPolytope wall(Box({1, 4, thick}), Pose::translation(0.875, 0, 0));
    const Penetration across = penetration(PosedQuadric(Cylinder(1, thick), Pose::translation(-0.875, 0, 0)), wall);
    const double depth = std::fmin(2 * thick, 0.25);
    EXPECT_LE(across.lower, depth);
    EXPECT_GE(across.upper, depth);
    EXPECT_GE(across.lower, depth * (1 - 1e-12));
    const Penetration aside = penetration(disc, crate);
    EXPECT_LE(aside.lower, 0.125);
    EXPECT_GE(aside.upper, 0.125);
    EXPECT_GE(aside.lower, 0.125 * (1 - 1e-12));
  }
}

// One end of a bar lies deeper than the other is thick: the way back is the shorter one.
TEST(LowestPlace, IsNotTakenWhereTheWayBackIsShorter) {
  for (const double through : {0.125, 0.0625, 0x1p-10}) {
    const PosedQuadric cone(Cone(1, 2));
    const PosedPolytope plate(Box({4, 4, 0.5}), Pose::translation(0, 0, -2 - 0.5 + through));
    const Penetration found = penetration(cone, plate);
    EXPECT_LE(found.lower, through);
    EXPECT_GE(found.upper, through);
    EXPECT_GE(found.lower, through * (1 - 1e-12));
    EXPECT_EQ(found.direction, (Vec3{0, 0, -1}));
  }
}

// The end of a can lies flat on a face of a box, but for the rounding of both: along a direction between theirs they
// are less deep than along the normal as it is told, whose length and the way round the rim must not be taken for more.
TEST(LowestPlace, OfAnEndOnAFaceIsNoMoreThanAlongADirectionBetween) {
  const Mat3 turned{{Vec3{-0x1.0e44279b4541cp-1, 0x1.65038564e63b1p-1, -0x1.f08db22d9567fp-2},
                     Vec3{0x1.a2655ff8673d1p-1, 0x1.252757aea6866p-1, -0x1.0f424b4b6e48dp-4},
                     Vec3{0x1.da0bb10f60656p-3, -0x1.b99203ddb6149p-2, -0x1.be7d5528b290ap-1}}};
  const PlacedQuadric can{Cylinder(0x1.e5d8d6dcea394p-6, 0x1.1c201aa6660f2p-1), {turned, {}}};
  const PlacedPolytope box{Box({0x1.1f5de5befcd4cp-1, 0x1.ff8561c104f58p-1, 0x1.19ca5d51dfbbdp-1}),
                           {turned, {-0x1.72a0d31957ebep-1, -0x1.de117f508c6bbp-2, -0x1.a8b3fe5a41138p-1}}};
  const Penetration found = penetration(posed(can), posed(box));
  using oracle::Fine;
  const oracle::FinePoint between{Fine(-0x1.f08db22d95681p-2) - Fine(0x1.185884ed309d6p-56),
                                  Fine(-0x1.0f424b4b6e48bp-4) + Fine(0x1.7fafbb3e0e795p-63),
                                  Fine(-0x1.be7d5528b290bp-1) + Fine(0x1.183d29d502493p-56)};
  const Fine height = oracle::depth_along(fine_set(can), fine_set(box), between);
  EXPECT_LE(Fine(found.lower), height);
  EXPECT_GE(found.lower, found.upper * (1 - 1e-8));
}

// A corner of the search's surface that was raised too far comes down, where the surface still has it above.
TEST(QuadricExpansion, ACornerThatCameDownIsNotTakenForARaisedOne) {
  const Mat3 turned{{Vec3{-0x1.b93ac92b25d56p-1, -0x1.4f872ae4d9fa6p-2, -0x1.8c9041878666bp-2},
                     Vec3{0x1.9ef4c9a85058fp-2, 0x1.de5fb1e33dc8p-7, -0x1.d404a40881ce8p-1},
                     Vec3{0x1.387eaaf14a31bp-2, -0x1.e3ad4b2e6006dp-1, 0x1.ec5561502cedp-4}}};
  const Mat3 other_turned{{Vec3{-0x1.866481fb3940ep-1, -0x1.2138e275a46cdp-1, 0x1.430950cd66a97p-2},
                           Vec3{0x1.aadaab916a305p-3, 0x1.fa222fc2d9c18p-3, 0x1.e481648944e9ep-1},
                           Vec3{-0x1.399b96865fd1fp-1, 0x1.9317c2c8bceecp-1, -0x1.219715fb8661p-4}}};
  const PosedQuadric splinter(Ellipsoid({0x1.499ae87fba719p-6, 0x1.3bacb85b032aap-10, 0x1.f024fea1d5fbp-3}),
                              {turned, {}});
  const PosedQuadric grain(Ellipsoid({0x1.e2eafb1a852ep-20, 0x1.4b2e5bf015d59p-20, 0x1.8c47ea4bc96cdp-20}),
                           {other_turned, {0x1.80484fc309769p-4, 0x1.c586c58b7726p-3, -0x1.dd19315a649cep-6}});
  const PairFrame frame = pair_frame(splinter, grain);
  const QuadricBody a(splinter, frame), b(grain, frame);
  QuadricExpansion expansion(a, b);
  (void)expansion.run(0x1p-43, QuadricExpansion::Precision::plain);
  EXPECT_LE(expansion.proved_depth(), frame.factor * penetration(splinter, grain).upper);
}

// Of a needle that lies in a slab, flush with both of its sides but for a little.
TEST(LowestPlace, IsTheNearerOfTwoSides) {
  for (const double more : {1e-3, 1e-6, 1e-9}) {
    const PosedQuadric needle(Ellipsoid({2, 0.25, 0.25}), Pose::translation(0, 0, more));
    const PosedPolytope slab(Box({4, 4, 0.25}));
    const Penetration found = penetration(needle, slab);
    EXPECT_LE(found.lower, 0.5 - more);
    EXPECT_GE(found.upper, 0.5 - more);
    EXPECT_GE(found.lower, (0.5 - more) * (1 - 1e-12));
    EXPECT_GT(dot(found.direction, {0, 0, -1}), 1 - 1e-9);
  }
}

}  // namespace
}  // namespace toccata::test
