#include "toccata/query/relation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/mesh_soups.hpp"
#include "support/relation_cases.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"

namespace toccata::test {
namespace {

Relation solids(RelationKind kind, Containment containment = Containment::none) {
  return {kind, containment, false, true, true, Status::exact};
}

const Relation apart = solids(RelationKind::apart);
const Relation touching = solids(RelationKind::touching);
Relation overlapping(Containment containment = Containment::none) {
  return solids(RelationKind::overlapping, containment);
}

Relation swapped(Relation r) {
  std::swap(r.a_solid, r.b_solid);
  if (r.containment == Containment::a_in_b)
    r.containment = Containment::b_in_a;
  else if (r.containment == Containment::b_in_a)
    r.containment = Containment::a_in_b;
  return r;
}

/// The answer, which must be the same both ways round, mirrored, scaled by powers of two, and with each mesh's
/// triangles in another order.
Relation asked(const Model& a, const Model& b, const PairQuery& query = {}) {
  const Relation answer = relation(a, b, query);
  EXPECT_EQ(relation(b, a, {query.pose_b, query.pose_a, query.solid_b, query.solid_a}), swapped(answer));
  const auto changed = [&](const Vec3& factor) {
    PairQuery other = query;
    for (Pose* pose : {&other.pose_a, &other.pose_b})
      for (int i = 0; i < 3; ++i) {
        pose->linear[i] = factor[i] * pose->linear[i];
        pose->offset[i] *= factor[i];
      }
    return other;
  };
  for (const Vec3& factor : {Vec3{-1, 1, 1}, Vec3{0x1p-40, 0x1p-40, 0x1p-40}, Vec3{0x1p300, 0x1p300, 0x1p300}})
    EXPECT_EQ(relation(a, b, changed(factor)), answer) << "factor " << factor.x;
  std::vector<std::array<Index, 3>> turned;
  for (const auto& [i, j, k] : a.mesh().triangles()) turned.insert(turned.begin(), {j, k, i});
  EXPECT_EQ(relation(Model(TriangleMesh({a.mesh().vertices().begin(), a.mesh().vertices().end()}, turned)), b, query),
            answer);
  return answer;
}

Relation asked(const TriangleMesh& a, const TriangleMesh& b, const PairQuery& query = {}) {
  return asked(Model(a), Model(b), query);
}

TriangleMesh unit_box() { return box_between({0, 0, 0}, {1, 1, 1}); }

PairQuery b_moved(double x, double y, double z) { return {Pose{}, Pose::translation(x, y, z)}; }

TEST(Relation, OfBoxesSideBySide) {
  EXPECT_EQ(asked(unit_box(), unit_box(), b_moved(2, 0, 0)), apart);
  EXPECT_EQ(asked(unit_box(), unit_box(), b_moved(1, 0, 0)), touching);
  EXPECT_EQ(asked(unit_box(), unit_box(), b_moved(1, 0.5, 0.25)), touching);
  EXPECT_EQ(asked(unit_box(), unit_box(), b_moved(1, 1, 0)), touching);
  EXPECT_EQ(asked(unit_box(), unit_box(), b_moved(1, 1, 1)), touching);
  EXPECT_EQ(asked(unit_box(), unit_box(), b_moved(std::nextafter(1, 2), 0, 0)), apart);
  EXPECT_EQ(asked(unit_box(), unit_box(), b_moved(std::nextafter(1, 0), 0, 0)), overlapping());
}

TEST(Relation, OfAlignedBoxesThatShareHalfTheirVolume) {
  EXPECT_EQ(asked(unit_box(), unit_box(), b_moved(0.5, 0, 0)), overlapping());
  EXPECT_EQ(asked(unit_box(), other_box_mesh({0, 0, 0.5}, {1, 1, 1.5})), overlapping());
  EXPECT_EQ(asked(unit_box(), unit_box(), b_moved(0.5, 0.5, 0)), overlapping());
}

TEST(Relation, OfEqualSolids) {
  EXPECT_EQ(asked(unit_box(), unit_box()), overlapping(Containment::equal));
  EXPECT_EQ(asked(unit_box(), other_box_mesh({0, 0, 0}, {1, 1, 1})), overlapping(Containment::equal));
  EXPECT_EQ(asked(unit_box(), inverted(unit_box())), overlapping(Containment::equal));
  EXPECT_EQ(asked(l_mesh(), joined({box_between({0, 0, 0}, {2, 1, 1}), box_between({0, 1, 0}, {1, 2, 1})})),
            overlapping(Containment::equal));
  // Turned by 180° about its own middle, another numbering of the same triangles.
  const Pose turned{{{{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}}, {1, 1, 0}};
  EXPECT_EQ(asked(unit_box(), unit_box(), {Pose{}, turned}), overlapping(Containment::equal));
}

TEST(Relation, OfASolidInAnother) {
  const TriangleMesh large = box_between({0, 0, 0}, {4, 4, 4});
  EXPECT_EQ(asked(unit_box(), large, {Pose::translation(1, 1, 1), Pose{}}), overlapping(Containment::a_in_b));
  EXPECT_EQ(asked(unit_box(), large), overlapping(Containment::a_in_b));
  EXPECT_EQ(asked(unit_box(), large, {Pose::translation(0, 1, 2), Pose{}}), overlapping(Containment::a_in_b));
  EXPECT_EQ(asked(sphere_mesh(1, 2), sphere_mesh(1.5, 1)), overlapping(Containment::a_in_b));
  // From face to face through the middle.
  EXPECT_EQ(asked(large, box_between({1, 1, 0}, {2, 2, 4})), overlapping(Containment::b_in_a));
}

TEST(Relation, OfAHollowSolidAndItsCore) {
  const TriangleMesh core = sphere_mesh(1, 3);
  const TriangleMesh hollow = joined({box_between({-2, -2, -2}, {2, 2, 2}), inverted(core)});
  EXPECT_EQ(asked(core, hollow), touching);
  EXPECT_EQ(asked(placed(core, 0.999, {}), hollow), apart);
  EXPECT_EQ(asked(placed(core, 1.001, {}), hollow), overlapping());
  EXPECT_EQ(asked(box_between({-2, -2, -2}, {2, 2, 2}), hollow), overlapping(Containment::b_in_a));
}

TEST(Relation, OfNestedShells) {
  const auto shell = [](double outer, double inner) {
    return joined({sphere_mesh(outer, 2), inverted(sphere_mesh(inner, 2))});
  };
  EXPECT_EQ(asked(shell(4, 3), shell(2, 1)), apart);
  EXPECT_EQ(asked(shell(4, 2), shell(2, 1)), touching);
  EXPECT_EQ(asked(shell(4, 1), shell(3, 2)), overlapping(Containment::b_in_a));
  EXPECT_EQ(asked(shell(4, 2), shell(3, 1)), overlapping());
  // A ball that fills the hole: all of the shell's hole is in it.
  EXPECT_EQ(asked(shell(4, 2), sphere_mesh(3, 2)), overlapping());
  EXPECT_EQ(asked(shell(4, 2), sphere_mesh(5, 2)), overlapping(Containment::a_in_b));
}

TEST(Relation, OfSeveralParts) {
  const TriangleMesh two = joined({unit_box(), placed(unit_box(), 1, {5, 0, 0})});
  EXPECT_EQ(asked(two, box_between({2, 0, 0}, {3, 1, 1})), apart);
  EXPECT_EQ(asked(two, box_between({4.5, -1, -1}, {7, 2, 2})), overlapping());
  EXPECT_EQ(asked(two, box_between({-1, -1, -1}, {7, 2, 2})), overlapping(Containment::a_in_b));
  EXPECT_EQ(asked(two, box_between({5.25, 0.25, 0.25}, {5.5, 0.5, 0.5})), overlapping(Containment::b_in_a));
  EXPECT_EQ(asked(two, placed(two, 1, {1, 0, 0})), touching);
}

TEST(Relation, OfSolidsThatOverlapThemselves) {
  const TriangleMesh crossed = joined({box_between({0, 0, 0}, {3, 1, 1}), box_between({1, -1, 0}, {2, 2, 1})});
  EXPECT_EQ(asked(crossed, box_between({1.25, 0.25, 0.25}, {1.5, 0.5, 0.5})), overlapping(Containment::b_in_a));
  EXPECT_EQ(asked(crossed, box_between({0.5, 0.25, 0.25}, {2.5, 0.5, 0.5})), overlapping(Containment::b_in_a));
  EXPECT_EQ(asked(crossed, box_between({0, 1, 0}, {1, 2, 1})), touching);
  // Where one part winds against the other there is nothing.
  const TriangleMesh cancelled =
      joined({box_between({0, 0, 0}, {2, 1, 1}), inverted(box_between({1, 0, 0}, {3, 1, 1}))});
  EXPECT_EQ(asked(cancelled, box_between({1, 0, 0}, {2, 1, 1})), touching);
  EXPECT_EQ(asked(cancelled, box_between({1.25, 0.25, 0.25}, {1.5, 0.5, 0.5})), apart);
}

TEST(Relation, OfSolidsWithoutVolume) {
  const TriangleMesh sheet({{0.25, 0.25, 0.5}, {0.75, 0.25, 0.5}, {0.25, 0.75, 0.5}}, {{0, 1, 2}, {0, 2, 1}});
  EXPECT_EQ(asked(sheet, unit_box()), touching);
  EXPECT_EQ(asked(sheet, sheet), touching);
  EXPECT_EQ(asked(sheet, sheet, b_moved(0, 0, 1)), apart);
  const TriangleMesh needle({{0.25, 0.25, 0.5}, {0.75, 0.25, 0.5}}, {{0, 1, 1}});
  ASSERT_TRUE(Model(needle).closed());
  EXPECT_EQ(asked(needle, unit_box()), touching);
}

TEST(Relation, OfSurfaceAndSolid) {
  const Model box(unit_box());
  // Closed as it may be: a triangle that is a segment is.
  const auto with_surface = [&](const TriangleMesh& surface) {
    return asked(Model(surface), box, {Pose{}, Pose{}, Solid::none, Solid::automatic});
  };
  const auto triangle = [](const Vec3& p, const Vec3& q, const Vec3& r) {
    return TriangleMesh({p, q, r}, {{0, 1, 2}});
  };
  const auto answer = [](RelationKind kind, Containment containment = Containment::none) {
    return Relation{kind, containment, false, false, true, Status::exact};
  };
  EXPECT_EQ(with_surface(triangle({2, 0, 0}, {3, 0, 0}, {2, 1, 0})), answer(RelationKind::apart));
  EXPECT_EQ(with_surface(triangle({0.25, 0.25, 1}, {0.5, 0.25, 1}, {0.25, 0.5, 2})), answer(RelationKind::touching));
  EXPECT_EQ(with_surface(triangle({-1, -1, 1}, {3, -1, 1}, {-1, 3, 1})), answer(RelationKind::touching));
  EXPECT_EQ(with_surface(triangle({0.25, 0.25, 0.5}, {0.5, 0.25, 0.5}, {0.25, 0.5, 2})),
            answer(RelationKind::crossing));
  EXPECT_EQ(with_surface(triangle({0.25, 0.25, 0.5}, {0.5, 0.25, 0.5}, {0.25, 0.5, 0.75})),
            answer(RelationKind::crossing, Containment::a_in_b));
  // A diagonal wall: it meets the box in edges and vertices only, and splits it.
  EXPECT_EQ(with_surface(TriangleMesh({{0, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}})),
            answer(RelationKind::crossing));
  // A segment from corner to corner, given as a triangle, and one along an edge.
  EXPECT_EQ(with_surface(triangle({0, 0, 0}, {1, 1, 1}, {1, 1, 1})), answer(RelationKind::crossing));
  EXPECT_EQ(with_surface(triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0})), answer(RelationKind::touching));
}

/// A triangle a few doubles high where the tip of a tetrahedron below touches its inside, just at the point that is
/// looked at first; every other double there is that same point.
TEST(Relation, OfATipThatTouchesATriangleAFewDoublesHigh) {
  const double step = 0x1p-52;
  const Vec3 p{0, 1, 0}, q{10, 1 + 7 * step, 0}, r{10, 1 + 13 * step, 0};
  const TriangleMesh tip = tetrahedron_mesh({5, 1 + 4 * step, 0}, {4, 0, -1}, {6, 0, -1}, {5, 3, -1});
  EXPECT_EQ(asked(tip, tetrahedron_mesh(p, q, r, {11, 9, 1})), touching);
  EXPECT_EQ(asked(tip, TriangleMesh({p, q, r}, {{0, 1, 2}})),
            (Relation{RelationKind::touching, Containment::none, false, true, false, Status::exact}));
  // The tip goes through the triangle.
  const TriangleMesh deep = tetrahedron_mesh({5, 1 + 4 * step, 0x1p-60}, {4, 0, -1}, {6, 0, -1}, {5, 3, -1});
  EXPECT_EQ(asked(deep, tetrahedron_mesh(p, q, r, {11, 9, 1})), overlapping());
  EXPECT_EQ(asked(deep, TriangleMesh({p, q, r}, {{0, 1, 2}})),
            (Relation{RelationKind::crossing, Containment::none, false, true, false, Status::exact}));
}

/// Fins of half the distance that they have, side by side along x from the origin, on z = 0.
TriangleMesh row_of_fins(int count, double distance, double length) {
  std::vector<TriangleMesh> fins;
  for (int i = 0; i < count; ++i)
    fins.push_back(box_between({i * distance, 0, 0}, {i * distance + distance / 2, length, 1}));
  return joined(fins);
}

TriangleMesh field_of_blocks(int side) {
  std::vector<TriangleMesh> rows;
  for (int i = 0; i < side; ++i) rows.push_back(placed(row_of_fins(side, 2, 1), 1, {0, 2.0 * i, 0}));
  return joined(rows);
}

/// More than a thousand contacts on one face, some of whose segments are long, and turned.
TEST(Relation, OfManyPartsOnOneFace) {
  const Pose turned{rotation_about({0, 0, 1}, 37), {}};
  const TriangleMesh below({{-99, -99, 0}, {999, -99, 0}, {-99, 999, 0}, {0, 0, -9}},
                           {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
  const TriangleMesh above({{-99, -99, 0}, {999, -99, 0}, {-99, 999, 0}, {0, 0, 999}},
                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  const TriangleMesh face({{-99, -99, 0}, {999, -99, 0}, {-99, 999, 0}}, {{0, 1, 2}});
  for (const TriangleMesh& parts : {field_of_blocks(11), row_of_fins(120, 0.125, 15)})
    for (const Pose& pose : {Pose{}, turned}) {
      const Model model(parts);
      const PairQuery query{pose, pose};
      EXPECT_EQ(relation(model, Model(below), query), touching);
      EXPECT_EQ(relation(model, Model(above), query), overlapping(Containment::a_in_b));
      EXPECT_EQ(relation(Model(joined({parts, box_between({-2, -2, -0x1p-40}, {-1, -1, 1})})), Model(below), query),
                overlapping());
      EXPECT_EQ(relation(model, Model(face), query),
                (Relation{RelationKind::touching, Containment::none, false, true, false, Status::exact}));
    }
}

TEST(Relation, OfSurfaces) {
  const auto as_surfaces = [](double x, double y, double z) {
    PairQuery query = b_moved(x, y, z);
    query.solid_a = query.solid_b = Solid::none;
    return asked(unit_box(), unit_box(), query);
  };
  EXPECT_EQ(as_surfaces(2, 0, 0), (Relation{RelationKind::apart, Containment::none, false}));
  EXPECT_EQ(as_surfaces(1, 0, 0), (Relation{RelationKind::touching, Containment::none, true}));
  EXPECT_EQ(as_surfaces(0.5, 0, 0).kind, RelationKind::touching);
  EXPECT_EQ(as_surfaces(0.5, 0.25, 0.125), (Relation{RelationKind::crossing, Containment::none, false}));
}

TEST(Relation, WhatIsAskedWronglyIsAnError) {
  const Model box(unit_box()), open(TriangleMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  PairQuery query;
  query.solid_b = Solid::all;
  EXPECT_THROW(static_cast<void>(relation(box, open, query)), Error);
  EXPECT_NO_THROW(static_cast<void>(relation(open, box, query)));
  query.pose_b.linear[0] = {};
  EXPECT_THROW(static_cast<void>(relation(open, box, query)), Error);
}

}  // namespace
}  // namespace toccata::test
