// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include <array>
#include <span>
#include <vector>

#include "methods/voronoi/region_parts.hpp"
#include "oracle/convex.hpp"
#include "oracle/penetration.hpp"
#include "oracle/rational.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/methods/bsp_tree.hpp"
#include "toccata/methods/minkowski.hpp"
#include "toccata/methods/sphere_ways.hpp"
#include "toccata/methods/voronoi.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {
namespace {

using oracle::exact;

// The first product is 2^-53 more than a double, and less the second one, that double, 0; the third one is -2^-54.
TEST(ProofConstants, APointAlmostInAVertexEdgePlaneIsSeenOnTheRightSide) {
  const Vec3 end{1 + 0x1p-27, 1, 1}, point{1 + 0x1p-26, -(1 + 0x1p-26 + 0x1p-27), -0x1p-54};
  ASSERT_EQ(oracle::dot(exact(end), exact(point)), exact(0x1p-54));
  const VoronoiRegions regions(Segment{{0, 0, 0}, end});
  EXPECT_FALSE(regions.contains({ConvexFeature::Kind::vertex, 0}, point));
}

TEST(ProofConstants, APointAlmostInAnEdgeFacePlaneIsSeenOnTheRightSide) {
  const std::array<Vec3, 3> corners{Vec3{-0x1.8de9fab86f2f2p-2, -0x1.e5162ee8075f9p-1, 0x1.ebbd77bf8004p-3},
                                    Vec3{-0x1.aae80cd3232a8p-4, -0x1.c1b8e0e5eba42p-2, 0x1.ff9e8c86735ccp-2},
                                    Vec3{0x1.b2590aee8a22cp-2, 0x1.277ef5bc17178p-1, -0x1.6471b3d68e9dcp-3}};
  const Vec3 point{0x1.613210e12201cp-4, -0x1.db8bad0542e24p-1, 0x1.5853fc87efdbdp-2};
  const auto edge = exact(corners[1]) - exact(corners[0]), other = exact(corners[2]) - exact(corners[0]);
  const auto way = exact(point) - exact(corners[0]);
  const bool is_ahead =
      oracle::dot(edge, edge) * oracle::dot(other, way) > oracle::dot(edge, other) * oracle::dot(edge, way);
  // Ahead of the plane into the face the point is that of a face, behind it of the edge.
  const VoronoiRegions regions{Triangle{corners}};
  const auto holding = [&](ConvexFeature::Kind kind) {
    for (const ConvexFeature& feature : regions.features())
      if (feature.kind == kind && regions.contains(feature, point)) return true;
    return false;
  };
  EXPECT_EQ(holding(ConvexFeature::Kind::face), is_ahead);
  EXPECT_EQ(holding(ConvexFeature::Kind::edge), !is_ahead);
}

// The solid's corner is as far from the origin as the distance, and its bevel goes through the origin.
TEST(ProofConstants, ABevelLiesBeyondTheOffsetSolid) {
  const ConvexHull hull(std::vector<Vec3>{{0x1.ae9bfc468d8bep-1, 0x1.e46ab05b478f8p-3, 0x1.26335cd18b3d2p-1},
                                          {0x1.df6219e1ff82ep+0, 0x1.4034fca4bfc4ep+0, 0x1.19b5415ea8b7cp-1},
                                          {0x1.196ecccb9d7bap+0, 0x1.2f263ab0ea796p-1, 0x1.f40056374ef3ap+0},
                                          {0x1.0981871305d29p+1, -0x1.b1e056e2fd57fp-2, 0x1.e37e3f1bfccfdp-1}});
  const OffsetSolid offset(PosedPolytope(hull), 0x1.0bb22df42621bp+0);
  ASSERT_TRUE(offset.contains({0, 0, 0}));
  EXPECT_TRUE(offset.in_beveled_planes({0, 0, 0}));
}

/// Behind all planes of faces, each moved outwards.
bool is_in_moved_planes(const PosedPolytope& solid, double distance, const Vec3& point) {
  const HullTopology topology = solid.topology();
  for (Index face = 0; face < topology.face_count(); ++face) {
    const auto corner = [&](Index i) { return exact(solid.vertex(topology.origin[topology.face_start[face] + i])); };
    const auto normal = oracle::cross(corner(1) - corner(0), corner(2) - corner(0));
    const auto height = oracle::dot(normal, exact(point) - corner(0));
    if (height > 0 && height * height > exact(distance) * exact(distance) * oracle::dot(normal, normal)) return false;
  }
  return true;
}

TEST(ProofConstants, APointAlmostInAMovedPlaneIsDecidedExactly) {
  const ConvexHull hull(std::vector<Vec3>{{-0x1.680a87cfe9118p-4, 0x1.6efa4028bf0ccp-1, 0x1.74e273bfd6d8p-2},
                                          {0x1.7e89c9db85a76p-1, 0x1.2fe47efc60be4p-1, -0x1.3bf257b5efd11p-1},
                                          {-0x1.65900990240bbp-1, -0x1.1fb1528badccep-2, 0x1.4d564db96efap-3},
                                          {-0x1.87caa55f4776ap-2, 0x1.cb537131e8a3p-4, -0x1.c21294a02901p-3}});
  const double distance = 0x1.c6551095ece92p-3;
  const Vec3 point{-0x1.8bec2b0c81eb4p-4, -0x1.32b5dfcfd37cp-6, -0x1.8269397c270cdp-2};
  const PosedPolytope solid(hull);
  EXPECT_EQ(OffsetSolid(solid, distance).in_moved_planes(point), is_in_moved_planes(solid, distance, point));
}

/// B moved by the point meets A, or touches it, or is apart.
Sign side_by_oracle(const oracle::ConvexSet& a, const oracle::ConvexSet& b, const Vec3& point) {
  const oracle::ConvexSet there = oracle::moved(b, exact(point));
  if (oracle::interiors_meet(a, there)) return Sign::negative;
  return oracle::overlap(a, there) ? Sign::zero : Sign::positive;
}

void expect_side(const PosedPolytope& a, const PosedPolytope& b, const Vec3& point, Sign side) {
  const MinkowskiSum difference = minkowski_difference(a, b);
  EXPECT_EQ(difference.side_of(point), side);
  EXPECT_EQ(SumLocator(difference).side_of(point), side);
}

ConvexHull hull_of(std::span<const Vec3> points) { return ConvexHull(std::vector<Vec3>(points.begin(), points.end())); }

TEST(ProofConstants, APointAlmostInAFaceOfADifferenceIsDecidedExactly) {
  const std::array a{Vec3{-0x1.131d773c043ccp+9, 0x1.5f1fbfe9aa971p+8, -0x1.9972013a21ec7p+9},
                     Vec3{-0x1.12a3c78ff70fap+9, 0x1.5f6c7b2207e8ep+8, -0x1.9935666faf3b8p+9},
                     Vec3{-0x1.12c4bcdd5334bp+9, 0x1.60cc5635bc4e3p+8, -0x1.9949cb864a046p+9},
                     Vec3{-0x1.12b5898b42955p+9, 0x1.5f6590a93a2f6p+8, -0x1.99667509dd746p+9}};
  const std::array b{Vec3{-0x1.126adf32f6968p+9, 0x1.5f4db13650db6p+8, -0x1.9a14c5d215c7cp+9},
                     Vec3{-0x1.12edb28a99acap+9, 0x1.5f76e4109558dp+8, -0x1.99fc5bf29bcfcp+9},
                     Vec3{-0x1.12c994f3fb43ap+9, 0x1.60704479ef57bp+8, -0x1.9a0c07e9f7c68p+9},
                     Vec3{-0x1.13006804544a5p+9, 0x1.5fd8373a39d47p+8, -0x1.9a165b5e41b3ap+9}};
  const Vec3 point{0x1.dd593808adp-2, 0x1.e83df704f38p-1, 0x1.991fafef5e8p+0};
  const ConvexHull hull_a = hull_of(a), hull_b = hull_of(b);
  expect_side(PosedPolytope(hull_a), PosedPolytope(hull_b), point,
              side_by_oracle(oracle::hull_set(a), oracle::hull_set(b), point));
}

TEST(ProofConstants, APointAlmostAsFarFromADifferenceAsItsRadiusIsDecidedExactly) {
  const std::array a{Vec3{-0x1.0e87761312c4p-2, 0x1.2190140bdd858p-1, -0x1.3ab6ac52857fp-4},
                     Vec3{0x1.9e896dd9414p-4, -0x1.953acadb4ba17p-1, -0x1.bf667805fe46p-5},
                     Vec3{-0x1.12bcc5057db96p+0, -0x1.52357dd739616p-1, 0x1.f944c2b28a44p-4},
                     Vec3{0x1.4a18e1a27abp-6, -0x1.3da920f7331b2p-1, -0x1.1ee2c8637bb98p-1}};
  const std::array b{Vec3{0x1.9364949913594p-2, -0x1.9004a12fccb19p-1, -0x1.eb2b6bd09205p-2},
                     Vec3{-0x1.7c1a55927ffc6p-1, 0x1.f7dfa4e0f23c6p-1, -0x1.eba5f3df75dfp-4},
                     Vec3{0x1.34ac9c471f3a2p-1, 0x1.64c5ccd9af7cp-1, 0x1.34f0bac1933ap-3},
                     Vec3{0x1.a8a2828ad47a4p-2, 0x1.1597b085157d3p+0, -0x1.7d31119a8685ap+0}};
  const double radius = 0x1.22babe7d35c8ap-3;
  const Vec3 point{0x1.a59a21e845deep-1, -0x1.e8df1aff798bfp+0, 0x1.7ddba3184f002p-6};
  const Rounded rounded(hull_of(a), radius);
  const ConvexHull hull = hull_of(b);
  expect_side(PosedPolytope(rounded), PosedPolytope(hull), point,
              side_by_oracle(oracle::rounded(oracle::hull_set(a), radius), oracle::hull_set(b), point));
}

// The sphere is farther from the plane than its radius by a few roundings of the corners' coordinates.
TEST(ProofConstants, ASphereBesideThePlaneOfATriangleIsDecidedExactly) {
  const Vec3 centre{-0x1.9a40ce684b7bbp-2, -0x1.d4ec0437fd7f4p-1, -0x1.300184b1d9133p-2};
  const Triangle triangle{
      std::array<Vec3, 3>{Vec3{0x1.dbeb90e4f226p-3, 0x1.945c5e9ca4088p-1, -0x1.6e08e343224bcp-3},
                          Vec3{-0x1.e9f215209c3ep-2, -0x1.e4a12b4609839p-1, -0x1.91778c686b34cp-1},
                          Vec3{-0x1.1107fd3526ec4p-2, -0x1.fc051b9aa29b3p-1, 0x1.c2a795618790ep-1}}};
  const double radius = 0x1.cdd9340625647p-14;
  const auto normal = oracle::cross(exact(triangle[1]) - exact(triangle[0]), exact(triangle[2]) - exact(triangle[0]));
  const oracle::Rational height = oracle::dot(normal, exact(centre) - exact(triangle[0]));
  ASSERT_GT(height * height, exact(radius) * exact(radius) * oracle::dot(normal, normal));
  EXPECT_TRUE(plane_rejects(PosedSphere(Sphere(radius), {{}, centre}), triangle));
}

// The ray touches an edge, where it leaves one side of the box and enters another: at the same time, of which one is
// rounded down and the other up.
TEST(ProofConstants, ARayThatTouchesTheBoxOfAMeshInAnEdgeIsNotSaidToMissIt) {
  const double small = 7 * 0x1p-56;
  const BspTree tree(Model(test::box_between({-1, 3, -1}, {1, 8, 1})));
  const Vec3 origin{-small, -3 * small, 0}, motion{2, 6, 0};
  ASSERT_EQ((exact(1) - exact(origin.x)) * exact(motion.y), (exact(3) - exact(origin.y)) * exact(motion.x));
  EXPECT_TRUE(tree.cast_ray(origin, motion));
}

/// Whether x √square is at most y.
bool is_at_most_by_root(const oracle::Rational& x, const oracle::Rational& square, const oracle::Rational& y) {
  if (x <= 0 && y >= 0) return true;
  if (x > 0 && y < 0) return false;
  return x > 0 ? x * x * square <= y * y : x * x * square >= y * y;
}

// The edges are so nearly parallel that rounding turns their cross product by 2.5 · 2^-53 over the sine.
TEST(ProofConstants, TheNormalOfASliverIsAsFarOffAsItsErrorSays) {
  const std::array<Vec3, 3> corner{Vec3{-0x1.4be46af005444p-2, -0x1.9c8d739d7aebcp-2, -0x1.edf2775f02a4cp-2},
                                   Vec3{0x1.8a9a4bd9ed03p-2, 0x1.3f8fb1c6bc1ap-1, -0x1.57fc5f943f9fcp-3},
                                   Vec3{0x1.628d5943e9499p-6, 0x1.925354fdaa9f3p-4, -0x1.4d8ad9e6189d5p-2}};
  const VoronoiRegions regions{Triangle{corner}};
  const RegionParts::Side& side = regions.parts().sides.front();
  auto normal = oracle::cross(exact(corner[1]) - exact(corner[0]), exact(corner[2]) - exact(corner[0]));
  if (oracle::dot(normal, exact(side.normal)) < 0) normal = -normal;
  const oracle::Rational square = oracle::dot(normal, normal), error = exact(side.error);
  const auto near = [&](double seen, const oracle::Rational& true_one) {
    return is_at_most_by_root(exact(seen) - error, square, true_one) &&
           is_at_most_by_root(-exact(seen) - error, square, -true_one);
  };
  EXPECT_TRUE(near(side.normal.x, normal.x));
  EXPECT_TRUE(near(side.normal.y, normal.y));
  EXPECT_TRUE(near(side.normal.z, normal.z));
}

}  // namespace
}  // namespace toccata
