// Cylinders, cones and ellipsoids as models: every question of any two, against 60 digits and against the pairs of the
// narrow room; alone, exchanged, in compounds and in batches.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "narrow/quadric_cases.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/narrow/quadrics.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/faces_in_region.hpp"
#include "toccata/query/manifold.hpp"
#include "toccata/query/nearest.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/relation.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata::test {
namespace {

constexpr std::uint64_t quadric_seed = 20261122;

template <class Placed>
Model quadric_model(const Placed& placed) {
  return std::visit([](const auto& shape) { return Model(shape); }, placed.shape);
}

PairQuery poses_of(const Pose& a, const Pose& b) { return {a, b, Solid::automatic, Solid::automatic}; }

std::string fault_of_numbers(const Distance& d, bool met, const oracle::FineNearness& truth) {
  if (oracle::Fine(d.lower) > truth.upper || oracle::Fine(d.upper) < truth.lower) return "distance";
  if (!met && truth.meet) return "overlap: apart, but they meet";
  if (met && d.lower > 0) return "overlap: they are apart";
  return "";
}

/// All questions are those of the pair, exchanged ones too, and agree with the oracle.
template <class B>
std::string fault_of_models(const PlacedQuadric& a, const B& b) {
  const Model model_a = quadric_model(a), model_b = quadric_model(b);
  const PosedQuadric posed_a = posed(a);
  const auto posed_b = posed(b);
  const PairQuery query = poses_of(a.pose, b.pose), back = poses_of(b.pose, a.pose);
  const Distance gap = distance(model_a, model_b, query);
  const bool met = overlap(model_a, model_b, query);
  std::string wrong = fault_of_numbers(gap, met, oracle::fine_nearness(fine_set(a), fine_set(b), 1e-14, 400));
  if (!wrong.empty()) return wrong;
  if (!(gap == distance(posed_a, posed_b)) || !(distance(model_b, model_a, back) == flipped(gap))) return "distance";
  if (met != overlap(posed_a, posed_b) || met != overlap(model_b, model_a, back)) return "overlap";
  const Relation lie = relation(model_a, model_b, query);
  if (!(lie == relation(posed_a, posed_b)) || !(relation(model_b, model_a, back) == flipped(lie))) return "relation";
  if (contacts(model_a, model_b, query).size() != (met ? 1U : 0U)) return "contacts";
  if (!(manifold(model_a, model_b, query) == manifold(posed_a, posed_b))) return "manifold";
  if (!(manifold(model_b, model_a, back) == manifold(posed_b, posed_a))) return "manifold, exchanged";
  if (!within_distance(model_a, model_b, gap.upper, query)) return "closer than the upper end";
  if (gap.lower > 0 && within_distance(model_a, model_b, gap.lower / 2, query)) return "closer than half the lower end";
  if (distance_within(model_a, model_b, gap.upper, query) != std::optional(gap)) return "distance within";
  const Vec3 way = 2.0 * (a.pose.offset - b.pose.offset) + Vec3{0.125, 0.25, 0.5};
  const std::optional<Cast> cast = cast_shape(posed_b, way, posed_a), found = cast_shape(model_b, way, model_a, back);
  if (cast.has_value() != found.has_value()) return "cast";
  if (cast && (cast->lower != found->lower || cast->upper != found->upper)) return "the time of a cast";
  if (lie.a_solid && lie.b_solid) {
    const Penetration depth = penetration(model_a, model_b, query);
    if (!(depth == penetration(posed_a, posed_b))) return "penetration";
    if (!(penetration(model_b, model_a, back) == flipped(depth))) return "penetration, exchanged";
  }
  return "";
}

TEST(QuadricModels, EveryQuestionOfAnyPairIsThatOfThePair) {
  std::uint64_t number = 0;
  for (const std::string& kind_a : quadric_kinds())
    for (const std::string& kind_b : quadric_other_kinds())
      for (int i = 0; i < 3; ++i) {
        const std::string& regime = quadric_regimes()[number % quadric_regimes().size()];
        Random random(quadric_seed + ++number);
        const QuadricCase pair = quadric_case(kind_a, kind_b, regime, random);
        const std::string fault = std::visit([&](const auto& b) { return fault_of_models(pair.a, b); }, pair.b);
        EXPECT_EQ(fault, "") << kind_a << " " << kind_b << " " << regime << ", seed " << quadric_seed + number;
      }
}

/// The largest coordinate of a set along an axis or against it.
double reach_of(const oracle::FineSet& set, int axis, double sign) {
  oracle::FinePoint direction;
  (axis == 0 ? direction.x : axis == 1 ? direction.y : direction.z) = sign;
  const oracle::FinePoint p = oracle::farthest(set, direction);
  return (axis == 0 ? p.x : axis == 1 ? p.y : p.z).convert_to<double>();
}

// A region that ends at the shape's last point is met, and one that ends well before it is not: the boxes by which
// pairs are left out are large enough and no larger than that.
TEST(QuadricModels, BoxesReachAsFarAsTheShape) {
  for (std::uint64_t number = 0; number < 60; ++number) {
    Random random(quadric_seed + number);
    const std::string& kind = quadric_kinds()[number % 3];
    const PlacedQuadric placed =
        quadric_case(kind, kind, quadric_regimes()[number % quadric_regimes().size()], random).a;
    const oracle::FineSet set = fine_set(placed);
    const Model model = quadric_model(placed);
    for (int axis = 0; axis < 3; ++axis) {
      const double top = reach_of(set, axis, 1), bottom = reach_of(set, axis, -1), size = top - bottom;
      Vec3 normal{};
      normal[axis] = -1;
      const auto meets_above = [&](double height) {
        Vec3 point{};
        point[axis] = height;
        const std::vector<SceneInstance> two{{model, placed.pose}, {HalfSpace(point, normal), {}}};
        return !check_all(two).pairs.empty();
      };
      // Far from the origin the top is rounded.
      EXPECT_TRUE(meets_above(std::min(top - 1e-9 * size, std::nextafter(top, -HUGE_VAL))))
          << kind << ", seed " << quadric_seed + number;
      if (std::abs(top) < 1e6 * size) {
        EXPECT_FALSE(meets_above(top + 1e-9 * size)) << kind << ", seed " << quadric_seed + number;
      }
    }
  }
}

// A lamp: a cone on a post. What it answers is the least of what its parts do, and the containment of both.
TEST(QuadricModels, CompoundsAreTheUnionOfTheirParts) {
  const Pose turned{rotation_about({1, 2, 3}, 40), {3, -1, 2}};
  const Cylinder post(0.125, 1);
  const Cone shade(0.75, 0.25);
  const Pose up = Pose::translation(0, 0, 1.25);
  const Model lamp(Compound(std::array{CompoundPart{post}, CompoundPart{shade, up}}));
  Random random(quadric_seed);
  for (int i = 0; i < 40; ++i) {
    const Ellipsoid egg({0.25, 0.5, 0.375});
    const Pose pose{quadric_linear("affine", random), turned.offset + 2.0 * quadric_direction(random)};
    const PairQuery query = poses_of(turned, pose);
    const Distance first = distance(post, egg, query), second = distance(shade, egg, poses_of(turned * up, pose));
    const Distance all = distance(lamp, egg, query);
    EXPECT_EQ(all.upper, std::min(first.upper, second.upper));
    EXPECT_EQ(overlap(lamp, egg, query), all.upper == 0 || all.status == Status::undecided);
    EXPECT_EQ(contacts(lamp, egg, query).size(), (first.lower == 0) + (second.lower == 0));
    EXPECT_EQ(relation(egg, lamp, poses_of(pose, turned)), flipped(relation(lamp, egg, query)));
  }
}

/// On an area, with all points at this height and as deep.
void expect_standing(const Manifold& m, double height, double depth) {
  ASSERT_GE(m.count, 3);
  for (int i = 0; i < m.count; ++i) {
    const ManifoldPoint& p = m.points[static_cast<std::size_t>(i)];
    EXPECT_NEAR(p.position.z, height, 1e-13);
    EXPECT_NEAR(p.depth, depth, 1e-13);
  }
}

// A can over the joint of two tables, one of them a compound's part, and on a mesh: each contact has points of its own.
TEST(QuadricModels, ContactsWithCompoundsAndMeshesHaveTheManifoldsOfTheirElements) {
  const Cylinder can(0.5, 1);
  const PairQuery on_top{.pose_b = Pose::translation(0.125, 0, 1.9375)};
  const std::array halves{CompoundPart{Box({1, 1, 1}), Pose::translation(-1, 0, 0)},
                          CompoundPart{Box({1, 1, 1}), Pose::translation(1, 0, 0)}};
  const Model tables{Compound(halves)};
  const std::vector<Contact> both = contacts(tables, can, on_top);
  ASSERT_EQ(both.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Manifold m = manifold(tables, can, both[i], on_top);
    expect_standing(m, 0.96875, 0.0625);
    EXPECT_EQ(m, manifold(PosedPolytope(Box({1, 1, 1}), halves[i].pose), PosedQuadric(can, on_top.pose_b)));
    for (std::size_t k = 0; k < static_cast<std::size_t>(m.count); ++k)
      EXPECT_GE((i == 0 ? -1 : 1) * m.points[k].position.x, -1e-15);
  }
  const Model slab(toccata::box_mesh({1, 1, 1}));
  const std::vector<Contact> on_mesh = contacts(slab, can, on_top);
  EXPECT_EQ(on_mesh.size(), 2U);
  for (const Contact& contact : on_mesh) {
    const Manifold m = manifold(slab, can, contact, on_top);
    EXPECT_EQ(m,
              manifold(PosedPolytope(world_triangle(slab, {}, contact.element_a)), PosedQuadric(can, on_top.pose_b)));
    EXPECT_EQ(m.normal, (Vec3{0, 0, 1}));
    expect_standing(m, 0.96875, 0.0625);
  }
}

// Beside a box of any size, undecided is within 10⁻¹² of the size of the quadric alone (docs/truth.md).
TEST(QuadricModels, OnlyWithinTheBandOfItsOwnSizeIsUndecided) {
  constexpr double gap = 4e-12;
  for (std::uint64_t number = 0; number < 60; ++number) {
    Random random(quadric_seed + number);
    const QuadricShape shape = quadric_shape(quadric_kinds()[number % 3], {0.5, 0.75, 1});
    const Mat3 turned = quadric_linear("far", random);
    const auto at = [&](double height) { return posed({shape, {turned, {0.125, 0.25, height}}}); };
    const double touching = 8 - distance(at(8), PosedHalfSpace(HalfSpace({0, 0, 0}, {0, 0, 1}))).upper;
    for (const double size : {1.0, 1e3, 1e6, 1e9}) {
      const PosedPolytope box(Box({4 * size, 4 * size, 4 * size}), Pose::translation(0, 0, -4 * size));
      EXPECT_EQ(quadric_contact(at(touching + gap), box), QuadricContact::apart) << size << ", " << number;
      EXPECT_EQ(quadric_contact(at(touching - gap), box), QuadricContact::contact) << size << ", " << number;
    }
  }
}

/// A bracket that holds the depth and whose translation parts the two.
void expect_depth(const Model& a, const Model& b, const PairQuery& query, double depth) {
  const Penetration found = penetration(a, b, query);
  EXPECT_LE(found.lower, depth * (1 + 1e-9));
  EXPECT_GE(found.upper, depth * (1 - 1e-9));
  EXPECT_GT(found.lower, 0.6 * depth);
  EXPECT_LT(found.upper, 1.1 * depth);
  PairQuery moved = query;
  moved.pose_b.offset = moved.pose_b.offset + (1 + 1e-9) * found.upper * found.direction;
  EXPECT_NE(relation(a, b, moved).kind, RelationKind::overlapping);
}

// A table of which the legs are cylinders, and a floor.
// The triangle that is touched tells the mesh.
TEST(QuadricModels, TouchingTrianglesIsToldExactly) {
  const Model crate(toccata::box_mesh({1, 1, 1})), field(HeightField(2, 2, 4, 4, std::vector<double>{0, 0, 0, 0}));
  const auto expect_touching = [](const Model& mesh, const Model& shape, const Vec3& place) {
    const PairQuery query = poses_of({}, {{}, place});
    EXPECT_TRUE(overlap(mesh, shape, query));
    EXPECT_FALSE(contacts(mesh, shape, query).empty());
    const Relation lie = relation(mesh, shape, query);
    EXPECT_EQ(lie.kind, RelationKind::touching);
    EXPECT_EQ(lie.status, Status::exact);
    const Distance gap = distance(mesh, shape, query);
    EXPECT_EQ(gap.upper, 0);
    EXPECT_EQ(gap.status, Status::exact);
    const std::optional<Cast> cast = cast_shape(shape, {0, 0, -1}, mesh, poses_of({{}, place}, {}));
    ASSERT_TRUE(cast);
    EXPECT_EQ(cast->upper, 0);
    EXPECT_EQ(cast->status, Status::exact);
    if (!lie.a_solid) return;
    const Penetration depth = penetration(mesh, shape, query);
    EXPECT_EQ(depth.upper, 0);
    EXPECT_EQ(depth.status, Status::exact);
  };
  const Model can(Cylinder(0.5, 1)), cone(Cone(0.5, 1)), egg(Ellipsoid({0.5, 1, 0.75}));
  expect_touching(crate, can, {0.25, 0.3, 2});
  expect_touching(crate, can, {1.5, 0.1, 0.5});
  expect_touching(crate, can, {1.5, 1, 2});
  expect_touching(crate, cone, {0, 0.7, -2});
  expect_touching(crate, egg, {0.1, 0.125, 1.75});
  expect_touching(field, can, {2.3, 1.1, 1});
  expect_touching(field, cone, {2, 2, 1});
  expect_touching(field, egg, {1.7, 2, 0.75});
}

TEST(QuadricModels, CompoundsOfThemArePartedToo) {
  const Cylinder leg(0.25, 1);
  std::vector<CompoundPart> parts{{Box({2, 1, 0.125}), Pose::translation(0, 0, 2)}};
  for (const double x : {-1.5, 1.5})
    for (const double y : {-0.5, 0.5}) parts.push_back({leg, Pose::translation(x, y, 1)});
  const Model table{Compound(parts)}, floor = Box({8, 8, 1});
  expect_depth(table, floor, {.pose_b = Pose::translation(0, 0, -0.875)}, 0.125);
  expect_depth(floor, table, {.pose_a = Pose::translation(0, 0, -0.875)}, 0.125);
  const HalfSpace ground({0, 0, 0.25}, {0, 0, 1});
  expect_depth(table, ground, {}, 0.25);
  // An egg between the legs, above the floor, below the top.
  expect_depth(table, Ellipsoid({0.25, 0.25, 0.5}), {.pose_b = Pose::translation(0, 0, 1.5)}, 0.125);
  EXPECT_EQ(penetration(table, Ellipsoid({0.25, 0.25, 0.5}), {.pose_b = Pose::translation(0, 0, 1.25)}).upper, 0);
}

TEST(QuadricModels, RaysRegionsAndHalfSpacesMeetThem) {
  const Ellipsoid egg({1, 2, 3});
  const std::optional<RayHit> hit = cast_ray({10, 0, 0}, {-18, 0, 0}, egg);
  ASSERT_TRUE(hit);
  EXPECT_LE(hit->lower, 0.5);
  EXPECT_GE(hit->upper, 0.5);
  EXPECT_EQ(faces_in_region(Ball{{0, 3, 0}, 1.125}, egg).size(), 1U);
  EXPECT_TRUE(faces_in_region(Ball{{0, 3, 0}, 0.875}, egg).empty());
  const HalfSpace floor({0, 0, 0}, {0, 0, 1});
  const PairQuery above{.pose_a = Pose::translation(0, 0, 3.5)}, sunk{.pose_a = Pose::translation(0, 0, 2.5)};
  EXPECT_FALSE(overlap(egg, floor, above));
  EXPECT_EQ(relation(egg, floor, sunk).kind, RelationKind::overlapping);
  EXPECT_LE(penetration(floor, egg, {.pose_b = Pose::translation(0, 0, 2.5)}).lower, 0.5);
  EXPECT_GE(penetration(floor, egg, {.pose_b = Pose::translation(0, 0, 2.5)}).upper, 0.5);
  const std::optional<ShapeHit> falling = cast_shape(egg, {0, 0, -1}, floor, above);
  ASSERT_TRUE(falling);
  EXPECT_LE(falling->lower, 0.5);
  EXPECT_GE(falling->upper, 0.5);
  EXPECT_TRUE(cast_shape(floor, {0, 0, 1}, egg, {.pose_b = Pose::translation(0, 0, 3.5)}));
}

/// The first of all triangles, each cast by itself.
template <class CastOne>
std::optional<ShapeHit> first_of_triangles(const Model& mesh, const CastOne& cast_one) {
  std::optional<ShapeHit> first;
  for (Index i = 0; i < mesh.element_count(); ++i) {
    const std::optional<Cast> one = cast_one(PosedPolytope(world_triangle(mesh, {}, i)));
    if (!one || (first && first->upper <= one->upper)) continue;
    first = ShapeHit{*one, i, i, 0, 0};
  }
  return first;
}

TEST(QuadricModels, CastsAtManyTrianglesAreTheFirstOfAllAndLookAtFew) {
  const Model rock(noise_sphere_mesh({.radius = 1, .roughness = 0.3, .subdivisions = 3, .seed = 5}));
  for (std::uint64_t number = 0; number < 15; ++number) {
    Random random(quadric_seed + number);
    const PlacedQuadric mover{quadric_shape(quadric_kinds()[number % 3], {0.1, 0.15, 0.2}),
                              {quadric_linear("affine", random), 2.0 * quadric_direction(random)}};
    const Vec3 way = 2.0 * (random.between(0, 0.8) * quadric_direction(random) - mover.pose.offset);
    const PosedQuadric shape = posed(mover);
    const PairQuery query{mover.pose, {}, Solid::automatic, Solid::none};
    Workspace workspace;
    const std::optional<ShapeHit> found = cast_shape(quadric_model(mover), way, rock, query, workspace);
    EXPECT_LT(workspace.counts().items, rock.element_count() / 4) << number;
    const std::optional<ShapeHit> first =
        first_of_triangles(rock, [&](const PosedPolytope& t) { return cast_shape(shape, way, t); });
    ASSERT_EQ(found.has_value(), first.has_value()) << number;
    if (!found) continue;
    EXPECT_EQ(found->upper, first->upper) << number;
    EXPECT_EQ(found->element_b, first->element_b) << number;
    const PairQuery back{{}, mover.pose, Solid::none, Solid::automatic};
    const std::optional<ShapeHit> other = cast_shape(rock, -way, quadric_model(mover), back);
    const std::optional<ShapeHit> last =
        first_of_triangles(rock, [&](const PosedPolytope& t) { return cast_shape(t, -way, shape); });
    ASSERT_TRUE(other && last) << number;
    EXPECT_EQ(other->upper, last->upper) << number;
    EXPECT_EQ(other->element_a, last->element_a) << number;
  }
}

TEST(QuadricModels, ManyQuestionsAtOnceAreTheSingleOnes) {
  std::vector<ModelPair> pairs;
  for (std::uint64_t number = 0; number < 66; ++number) {
    Random random(quadric_seed + number);
    const QuadricCase pair = quadric_case(quadric_kinds()[number % 3], quadric_other_kinds()[number % 11],
                                          quadric_regimes()[number / 6], random);
    std::visit(
        [&](const auto& b) {
          pairs.push_back({quadric_model(pair.a), quadric_model(b), {pair.a.pose, b.pose}});
        },
        pair.b);
  }
  for (const int threads : {1, 3}) {
    const BatchOptions options{.threads = threads};
    const auto met = overlap_each(pairs, options);
    const auto gaps = distance_each(pairs, options);
    const auto lies = relation_each(pairs, options);
    const auto points = manifold_each(pairs, options);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_EQ(points[i], manifold(pairs[i].a, pairs[i].b, pairs[i].query)) << i;
      EXPECT_EQ(met[i], overlap(pairs[i].a, pairs[i].b, pairs[i].query)) << i;
      EXPECT_EQ(gaps[i], distance(pairs[i].a, pairs[i].b, pairs[i].query)) << i;
      EXPECT_EQ(lies[i], relation(pairs[i].a, pairs[i].b, pairs[i].query)) << i;
    }
  }
}

template <class Action>
std::string quadric_refusal(const Action& action) {
  try {
    static_cast<void>(action());
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

// A lamp on a table: the surface of each part, and inside of some.
TEST(QuadricModels, NearestPointsAndSignedDistancesOfCompounds) {
  const std::vector<CompoundPart> parts{{Box({2, 2, 0.5}), {}},
                                        {Cylinder(0.25, 1), Pose::translation(0, 0, 1.5)},
                                        {Cone(1, 0.5), Pose::translation(0, 0, 3)}};
  const Model lamp((Compound(parts)));
  const SignedDistance in_post = signed_distance({0.125, 0, 1.5}, lamp);
  EXPECT_EQ(in_post.side, Side::inside);
  EXPECT_EQ(in_post.element, 1U);
  EXPECT_NEAR(in_post.upper, -0.125, 1e-12);
  EXPECT_EQ(signed_distance({0, 1, 2.5}, lamp).side, Side::boundary);
  const SignedDistance beside = signed_distance({0.75, 0, 1.5}, lamp);
  EXPECT_EQ(beside.side, Side::outside);
  EXPECT_NEAR(beside.lower, 0.5, 1e-12);
  const std::vector<SurfacePoint> three = nearest_points({0, 0, 2.75}, 3, lamp);
  ASSERT_EQ(three.size(), 3U);
  EXPECT_EQ(three[0].element + three[1].element, 3U);
  EXPECT_NEAR(three[0].upper, 0.25, 1e-12);
  EXPECT_NEAR(three[1].upper, 0.25, 1e-12);
  EXPECT_NEAR(three[2].upper, 2.25, 1e-11);
  const std::vector<Vec3> points{{0.125, 0, 1.5}, {0.75, 0, 1.5}};
  const auto many = signed_distance_each(points, lamp);
  EXPECT_EQ(many[0], in_post);
  EXPECT_EQ(many[1], beside);
}

TEST(QuadricModels, WhatIsNotAnsweredSaysSo) {
  Pose flat;
  flat.linear[2] = {0, 0, 0};
  const std::string singular = quadric_refusal([&] { return overlap(Cylinder(1, 1), Sphere(1), {.pose_a = flat}); });
  EXPECT_TRUE(singular.starts_with("model a: the cylinder: the pose")) << singular;
  EXPECT_NE(singular.find("singular"), std::string::npos);
  EXPECT_NE(quadric_refusal([] { return penetration(Model(Cone(1, 1)), Model(Point())); }).find("surface"),
            std::string::npos);
  EXPECT_TRUE(taken_as_solid(Model(Cone(1, 1)), Solid::automatic));
}

}  // namespace
}  // namespace toccata::test
