// Witnesses as in proof_constants_test.cpp, for what meshes are compared along and how points come into their trees.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/vec3_measures.hpp"
#include "oracle/rational.hpp"
#include "query/casts/swept_view.hpp"
#include "query/distance/near_view.hpp"
#include "query/distance/relative_motion.hpp"
#include "query/meshes/pair_cull.hpp"
#include "query/meshes/wide_cull.hpp"
#include "query/meshes/world_search.hpp"
#include "query/nearest/way_into_tree.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/convex_parts.hpp"
#include "toccata/query/overlap.hpp"
#include "trees/oriented_boxes.hpp"

namespace toccata {
namespace {

using oracle::exact;

Mat3 stretched_along_x(double factor) { return {{Vec3{factor, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}; }

/// Longer by 3 · 2^-45 along x, which is little enough to be taken for a rotation.
constexpr double hardly_longer = 1 + 0x3p-45;

TEST(ProofConstants, AMatrixThatStretchesALittleAlongOneAxisIsNotTakenForLess) {
  const Stretch stretch = stretch_of(stretched_along_x(hardly_longer));
  ASSERT_TRUE(stretch.is_equal);
  EXPECT_GE(stretch.greatest, hardly_longer);
}

// A matrix of determinant 1 and its inverse in whole numbers, under which the point and minus the point are rounded to
// the same plane: the way back makes a million times as much of that.
TEST(ProofConstants, TheWayIntoATreeCoversTheRoundingOfWorldVertices) {
  const double k = 1025, y = 0x1.008828aa3dep+0;
  const Vec3 vertex{-(k * y), y, 0};
  const Model model(TriangleMesh({vertex, -vertex, {0, 0, 0}}, {{0, 1, 2}}));
  const PosedMesh mesh(model, {{{Vec3{1, k, 0}, Vec3{k, k * k + 1, 0}, Vec3{0, 0, 1}}}, {}});
  const WayIntoTree way(mesh);
  ASSERT_TRUE(way.usable());
  const Vec3 world = mesh.vertex(0), place = way.place(world);
  const oracle::Rational error = abs(exact(place.x) - exact(vertex.x / model.wide_bvh().unit));
  EXPECT_LE(error, exact(way.off(largest_magnitude(world))));
}

// Three quarters of the vertex are no whole number of least doubles, and half of one is more than all other roundings.
TEST(ProofConstants, TheWayIntoATreeOfLeastDoublesCoversWhatUnderflows) {
  const Vec3 vertex{0x2000'0002p-1074, 0, 0};
  const Model model(TriangleMesh({vertex, -vertex, {0, vertex.x, 0}}, {{0, 1, 2}}));
  const PosedMesh mesh(model, scaled(Pose{}, 0.75));
  const WayIntoTree way(mesh);
  ASSERT_TRUE(way.usable());
  const Vec3 world = mesh.vertex(0);
  const oracle::Rational error = abs(exact(way.place(world).x) - exact(vertex.x / model.wide_bvh().unit));
  EXPECT_LE(error, exact(way.off(largest_magnitude(world))));
}

// A point so far away that what rounding it leaves is more than a small mesh.
TEST(ProofConstants, TheWayIntoATreeCoversTheRoundingOfTheWay) {
  const Model model(TriangleMesh({{0.75, 0, 0}, {-0.75, 0, 0}, {0, 0.75, 0.75}}, {{0, 1, 2}}));
  const WayIntoTree way(PosedMesh(model, {{{Vec3{0.6, -0.8, 0}, Vec3{0.8, 0.6, 0}, Vec3{0, 0, 1}}}, {}}));
  ASSERT_TRUE(way.usable());
  const Vec3 point{0x1.bb10ca0c8beebp+40, 0x1.4164edf44a8fp+40, 0x1.9711770b96c57p+40};
  const oracle::Rational along = oracle::dot(exact(way.back()[0]), exact(point)) - exact(way.origin().x);
  EXPECT_LE(abs(exact(way.place(point).x) - along), exact(way.off(largest_magnitude(point))));
}

/// The length of the nearest point's bound for two points, each a tree of its own.
oracle::Rational bound_of_points(const NearFrame& a, const NearFrame& b) {
  OrientedBlock block{};
  block.count = 1;
  block.child.fill(~0);
  for (std::size_t lane = 0; lane < OrientedBlock::width; ++lane) set_lane(block, lane, {});
  const Index item = 0;
  const NearBvh tree{{&block, 1}, {&item, 1}};
  return exact(NearWalk(tree, tree, near_view(a, b), near_view(b, a)).bounds(0, 0, 0).least[0]);
}

TEST(ProofConstants, BoundsCoverThatAPoseIsHardlyARotation) {
  const double distance = 1024;
  const NearFrame a{stretched_along_x(hardly_longer), {}, 1, {}}, b{Mat3{}, {distance, 0, 0}, 1, {distance, 0, 0}};
  ASSERT_TRUE(near_view(a, b).rigid);
  EXPECT_LE(bound_of_points(a, b), exact(distance));
}

// 1/2 + 2^-26 lies between two floats, nearer to the lesser one.
TEST(ProofConstants, TheBoxOfAConvexShapeHoldsIt) {
  const double half = 0.5 + 0x1p-26;
  const ConvexNearBvh near(PosedPolytope(Box({half, half, half}), Pose{}));
  EXPECT_GE(exact(double{near.block.extent[0][0]}) * exact(near.frame.unit), exact(half));
}

// Two points: the frame of the first grows along the way to the second, and that comes nearer by as much, so that seen
// from the first it stays where it was. Both are moved aside, so that the motion in the world is greater.
TEST(ProofConstants, AMotionCoversThatAPoseIsHardlyARotation) {
  const Model point(TriangleMesh({{0, 0, 0}}, {{0, 0, 0}}));
  const double distance = 1024, nearer = distance - 0x3p-35;
  const Pose a_after{stretched_along_x(hardly_longer), {0, 1, 0}};
  const double motion = relative_motion(point, point, Pose{}, Pose::translation(distance, 0, 0), a_after,
                                        Pose::translation(nearer, 1, 0));
  EXPECT_GE(exact(motion), exact(distance) - exact(nearer));
}

// A point, and a region that is where it is along a direction.
TEST(ProofConstants, AProbeCoversTheRoundingOfFloats) {
  const Vec3 point{0x1.626fdap-2, -0x1.d894dep-1, -0x1.194df4p-1};
  const Vec3 direction{0x1.684f2235fb41p-2, -0x1.a376dcb1d782ap-1, -0x1.9d586909522bfp-1};
  WideBvh tree = build_wide_bvh(std::vector<Aabb>(1, {{-0.75, -0.75, -0.75}, {0.75, 0.75, 0.75}}));
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    tree.blocks.at(0).centre[i][0] = static_cast<float>(point[axis]);
    tree.blocks.at(0).extent[i][0] = 0;
  }
  const double along = dot(direction, point);
  WideProbe probe;
  add_axis({direction, 0, {along, along}, 0x1p-50}, tree, probe);
  bool found = false;
  walk_probe(tree, probe, [&](Index) { return found = true; });
  EXPECT_TRUE(found);
}

/// A triangle far from the mesh's origin, which its pose brings back to the world's, so that the sums that are rounded
/// to world vertices are large. The first vertex is a corner of the box around it in the tree.
struct BroughtBack {
  BroughtBack(const Mat3& turn, const Vec3& at, double x, double y)
      : vertex(at),
        mesh(Model(TriangleMesh({at, at + Vec3{x, 0, 0}, at + Vec3{0, y, 0}}, {{0, 1, 2}})),
             {turn, -transform({turn, {}}, at)}),
        world(mesh.vertex(0)),
        inwards(transform({turn, {}}, {x, y, 0})) {}

  /// Whether a search in a region finds the triangle.
  template <class Region>
  [[nodiscard]] bool is_near(const Region& region) const {
    bool found = false;
    visit_triangles_near(mesh, region, [&](Index) {
      found = true;
      return false;
    });
    return found;
  }

  Vec3 vertex;
  PosedMesh mesh;
  Vec3 world;    ///< the first vertex
  Vec3 inwards;  ///< the rest of the box is there, seen from it
};

PosedMesh point_at(const Vec3& point) { return {Model(TriangleMesh({point}, {{0, 0, 0}})), Pose{}}; }

bool is_parted(const BroughtBack& a) {
  return PairCull(a.mesh, point_at(a.world)).disjoint({a.vertex, a.vertex}, {a.world, a.world});
}

/// Both are at one height along every direction when the way begins.
bool is_met_by_the_way(const BroughtBack& a) {
  const PosedMesh point = point_at(a.world);
  const SweptView view(a.mesh, a.inwards, point);
  const auto directions = view.directions();
  const auto height = [](const PosedMesh& mesh, const Vec3& local, const SweptDirection& d, std::size_t side) {
    const WideBvh& tree = mesh.model().wide_bvh();
    return dot(d.form[side], (1 / tree.unit) * (local - tree.origin)) + d.offset[side];
  };
  return std::all_of(directions.begin(), directions.end(), [&](const SweptDirection& d) {
    return std::fabs(height(a.mesh, a.vertex, d, 0) - height(point, a.world, d, 1)) <= d.pad;
  });
}

/// The bound of the distance from a point beyond the vertex is not more than that from the vertex.
bool is_bound_of(const BroughtBack& a) {
  const Vec3 beyond = a.world - a.inwards;
  const PosedMesh point = point_at(beyond);
  const auto boxes_of = [](const PosedMesh& mesh) {
    return oriented_boxes(mesh.model().wide_bvh(), mesh.model().mesh());
  };
  const std::vector<OrientedBlock> boxes_a = boxes_of(a.mesh), boxes_b = boxes_of(point);
  const std::vector<Index> items{0};
  const NearFrame frame_a = near_frame(a.mesh), frame_b = near_frame(point);
  const NearWalk walk({boxes_a, items}, {boxes_b, items}, near_view(frame_a, frame_b), near_view(frame_b, frame_a));
  const oracle::Rational least = exact(walk.bounds(0, 0, 0).least[0]);
  const auto way = exact(a.world) - exact(beyond);
  return least <= 0 || least * least <= oracle::dot(way, way);
}

const Mat3 turn{{Vec3{0x1.6fec31dd91991p-1, 0x1.38bfd967fa2fep-2, 0x1.3fe18c6c3909ap-1},
                 Vec3{0x1.a2fe62c1cbc4cp-3, -0x1.e72927e4a4945p-1, 0x1.d6adc43252a8dp-3},
                 Vec3{0x1.544d07b4e938ep-1, -0x1.31d277563a738p-5, -0x1.7e10bd02c461bp-1}}};
const Mat3 other_turn{{Vec3{0x1.3d0b4bc02038cp-1, -0x1.8ea8021e53d2p-2, -0x1.5d2295a52093fp-1},
                       Vec3{-0x1.cd1c6a727f9cap-2, -0x1.c66715df92196p-1, 0x1.908256cd18e22p-4},
                       Vec3{-0x1.495981ef4841dp-1, 0x1.f8dd44091592bp-3, -0x1.7322f2fb180d4p-1}}};
/// Brought back by the first and by the other turn.
BroughtBack brought_back() { return {turn, {0x1.663b465d029ep+43, 0x1.cabfa365db9p+42, 0x1.d3dc91bfee9ap+43}, -1, 1}; }
BroughtBack brought_back_by_the_other() {
  return {other_turn, {-0x1.d29b70bb8fe6p+43, -0x1.473104aad016p+43, -0x1.68007fea9afp+40}, 1, 1};
}

TEST(ProofConstants, ThePadOfADirectionCoversTheRoundingOfVertices) { EXPECT_FALSE(is_parted(brought_back())); }

TEST(ProofConstants, SizesAlongTheAxesOfACullAreRoundedUp) {
  const BroughtBack a = brought_back(), b = brought_back_by_the_other();
  const WideCull cull = wide_cull(PairCull(a.mesh, b.mesh), a.mesh, b.mesh);
  for (const WideAxes& axes : {cull.of_a, cull.of_b})
    for (std::size_t axis = 0; axis < axes.count; ++axis)
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_GE(exact(double{axes.other_size[i][axis]}), exact(std::fabs(axes.other[i][axis])));
}

TEST(ProofConstants, RegionsAtAVertexThatRoundingMovedAreNotMissed) {
  const BroughtBack a = brought_back_by_the_other();
  EXPECT_TRUE(a.is_near(Aabb{a.world, a.world}));
  EXPECT_TRUE(a.is_near(Aabb{a.world, {a.world.x, a.world.y, HUGE_VAL}}));
}

TEST(ProofConstants, HeightsAlongAWayCoverTheRoundingOfVertices) { EXPECT_TRUE(is_met_by_the_way(brought_back())); }

TEST(ProofConstants, BoundsOfMeshesFarAwayCoverTheRoundingOfVertices) {
  EXPECT_TRUE(is_bound_of(brought_back_by_the_other()));
}

// A vertex on a face of a cube that is the only part.
TEST(ProofConstants, PartsAreApartOnlyWhereRoundedMeshesAre) {
  const Vec3 vertex{1, 0x1.8p-3, 0x1.4p-4};
  std::vector<Vec3> corners;
  for (const double x : {-1, 1})
    for (const double y : {-1, 1})
      for (const double z : {-1, 1}) corners.push_back({x, y, z});
  ConvexParts parts;
  parts.parts.push_back({ConvexHull(corners), 0, 0, 0, {}});
  const Model mesh(TriangleMesh({vertex, {0, 0, 0}, {0, 0, 0.5}}, {{0, 1, 2}}));
  const Pose pose{turn, {}};
  const Model point(Point(transform(pose, vertex)));
  ASSERT_TRUE(overlap(mesh, point, {pose, Pose{}}));
  EXPECT_FALSE(parts_are_apart(ModelWithParts(mesh, parts), ModelWithParts(point), {pose, Pose{}}));
}

}  // namespace
}  // namespace toccata
