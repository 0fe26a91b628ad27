#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "narrow/convex/aligned_cores.hpp"
#include "narrow/convex/canonical_order.hpp"
#include "narrow/convex_distance_checks.hpp"
#include "narrow/exact/exact_distance.hpp"
#include "narrow/museum.hpp"
#include "narrow/primitives/closed_forms.hpp"
#include "support/simd_levels.hpp"
#include "toccata/bounds/aabb.hpp"

// That distances are right in every regime is swept (convex_distance_sweep.cpp). Here: what else they promise.
namespace toccata {
namespace {

using test::ConvexCase;

PosedPolytope box(const Vec3& half_extents, const Vec3& centre, const Mat3& linear = {}) {
  return PosedPolytope(Box(half_extents), {linear, centre});
}

Mat3 turned(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {{Vec3{c, -s, 0}, Vec3{s, c, 0}, Vec3{0, 0, 1}}};
}

/// Calls `visit` with pairs of every kind in every regime.
template <class Visit>
void for_all_kinds(const Visit& visit) {
  std::uint64_t number = 0;
  for (const std::string& kind : test::convex_kinds())
    for (std::uint64_t i = 0; i < 14 * 15; ++i) {
      Random random(++number);
      visit(test::numbered_case(kind, i, random), number);
    }
}

TEST(ConvexDistance, IsTheSameAtEverySimdLevel) {
  std::vector<Distance> distances;
  const auto ask_all = [&](const auto& see) {
    for_all_kinds(
        [&](const ConvexCase& pair, std::uint64_t) { see(distance(test::posed(pair.a), test::posed(pair.b))); });
  };
  ask_all([&](const Distance& d) { distances.push_back(d); });
  test::at_every_simd_level([&](SimdLevel level) {
    std::size_t at = 0;
    ask_all([&](const Distance& d) { ASSERT_EQ(d, distances[at++]) << name_of(level) << ", pair " << at; });
  });
}

TEST(ConvexDistance, HoldsThatOfExactArithmetic) {
  VertexPairs first;
  first.append(0, 0);
  for_all_kinds([&](const ConvexCase& pair, std::uint64_t number) {
    const PosedPolytope a = test::posed(pair.a), b = test::posed(pair.b);
    const Distance fast = distance(a, b);
    const ExactNearest nearest = exact_nearest(a, b, first);
    ASSERT_EQ(fast.upper == 0, offset_shapes_meet(nearest, a.radius(), b.radius())) << number << ": " << to_text(pair);
    ASSERT_EQ(test::width_fault(fast), "") << number << ": " << to_text(pair);
    if (nearest.meet) return;
    const Distance slow = rounded_distance(nearest, a.radius(), b.radius());
    ASSERT_TRUE(fast.lower <= slow.lower && slow.upper <= fast.upper) << number << ": " << to_text(pair);
    const oracle::Rational size = test::size_of(test::set_of(pair.a), test::set_of(pair.b));
    ASSERT_EQ(test::exact_witness_fault(fast, a, b, size), "") << number << ": " << to_text(pair);
  });
}

// Balls just above an edge that is turned about the way to it: what rounding does to that way is mostly across it, and
// may be longer than the way itself and the radius.
TEST(ConvexDistance, IsRightWhereRoundingIsAcrossIt) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Pose pose{turned(random.between(0, 6)), {}};
    const Vec3 h{random.between(0.5, 1.5), random.between(0.5, 1.5), random.between(0.5, 1.5)};
    const Vec3 on_edge = transform(pose, {random.between(-h.x, h.x), h.y, h.z});
    const auto ball_at = [&](double gap) {
      const Vec3 above = on_edge + Vec3{0, 0, gap};
      return test::PlacedPolytope{Sphere(gap * std::pow(10, random.between(-6, 0)), above), {}};
    };
    const ConvexCase box{ball_at(std::pow(10, random.between(-14, -8))), {Box(h), pose}};
    ASSERT_EQ(test::distance_fault(box), "") << i << ": " << to_text(box);
    const Segment edge({-h.x, h.y, h.z}, {h.x, h.y, h.z});
    const ConvexCase segment{ball_at(std::pow(10, random.between(-18, -8))), {edge, pose}};
    ASSERT_EQ(test::distance_fault(segment), "") << i << ": " << to_text(segment);
  }
}

TEST(ConvexDistance, DoesNotChangeWhileAWorkspaceIsKept) {
  Random random(1);
  for (const char* kind : {"hull", "box", "rounded-hull", "needle-hull"}) {
    const test::ConvexShape a = test::random_convex(kind, random), b = test::random_convex("hull", random);
    SimplexCache workspace;
    for (int step = 0; step < 400; ++step) {
      const double angle = 0.02 * step, way = 3 * std::cos(0.05 * step);
      const PosedPolytope posed_a = test::posed({a, {}}), posed_b = test::posed({b, {turned(angle), {way, 0.5, 0.3}}});
      ASSERT_EQ(distance(posed_a, posed_b, &workspace), distance(posed_a, posed_b)) << kind << ", step " << step;
      ASSERT_EQ(overlap(posed_a, posed_b, &workspace), overlap(posed_a, posed_b)) << kind << ", step " << step;
    }
    EXPECT_GT(workspace.counts.certificates, workspace.counts.exact) << kind;
  }
}

// Which of many nearest points.

TEST(ConvexDistance, OfParallelFacesIsToldAtTheirLeastCommonPoint) {
  const Distance d = distance(box({1, 1, 1}, {0, 0, 0}), box({1, 1, 1}, {1.5, -0.5, 3}));
  EXPECT_EQ(d, (Distance{1, 1, {0.5, -1, 1}, {0.5, -1, 2}, Status::exact}));
}

TEST(ConvexDistance, OfFacesTurnedInTheirPlaneIsToldWhereEdgesCross) {
  // The upper box is a diamond around x = 1, seen from above; its corner at x < −1 is outside the lower box, and the
  // least common points are where its two edges leave the side x = −1.
  const std::vector<Vec3> diamond = {{-3, 0, 2}, {1, -4, 2}, {5, 0, 2}, {1, 4, 2}, {1, 0, 5}};
  const ConvexHull upper(diamond);
  const Distance d = distance(box({1, 8, 1}, {0, 0, 0}), PosedPolytope(upper));
  EXPECT_EQ(d, (Distance{1, 1, {-1, -2, 1}, {-1, -2, 2}, Status::exact}));
}

TEST(ConvexDistance, OfParallelEdgesIsToldAtTheirLeastCommonPoint) {
  const PosedPolytope a(Segment({0, 0, 0}, {4, 4, 0})), b(Segment({3, 1, 7}, {-1, -3, 7}));
  const Distance d = distance(a, b);
  EXPECT_EQ(d.on_a, (Vec3{0, 0, 0}));
  EXPECT_EQ(d.on_b, (Vec3{1, -1, 7}));
  EXPECT_EQ(test::exchanged(distance(b, a)), d);
}

TEST(ConvexDistance, OfRoundShapesMovesTheLeastCommonPointToTheSurface) {
  const PosedPolytope a(Rounded(Box({1, 1, 1}), 0.25)), b(Capsule({-0.5, 0, 3}, {3, 0, 3}, 0.5));
  EXPECT_EQ(distance(a, b), (Distance{1.25, 1.25, {-0.5, 0, 1.25}, {-0.5, 0, 2.5}, Status::exact}));
}

TEST(ConvexDistance, OfRoundShapesThatMeetDividesTheWayAsTheRadiiDo) {
  const PosedPolytope a(Sphere(3)), b(Sphere(1, {2, 0, 0}));
  EXPECT_EQ(distance(a, b), (Distance{0, 0, {1.5, 0, 0}, {1.5, 0, 0}, Status::exact}));
}

// Intervals.

TEST(ConvexDistance, OfBallsAlongAnAxisHoldsTheDoubleThatItIs) {
  const Distance d = distance(PosedPolytope(Sphere(1)), PosedPolytope(Sphere(1, {0, 5, 0})));
  EXPECT_LE(d.lower, 3);
  EXPECT_GE(d.upper, 3);
  EXPECT_LE(d.upper - d.lower, 3e-12);
}

TEST(ConvexDistance, IsNarrowWhereItIsNoDouble) {
  const Distance d = distance(PosedPolytope(Point({0, 0, 0})), PosedPolytope(Point({1, 1, 0})));
  EXPECT_LE(d.lower, std::numbers::sqrt2);
  EXPECT_GE(d.upper, std::nextafter(std::numbers::sqrt2, 2));
  EXPECT_EQ(test::width_fault(d), "");
}

TEST(ConvexDistance, OfSizesAtTheEndsOfTheRange) {
  for (const double size : {0x1p-1070, 0x1p-1000, 0x1p-500, 0x1p500, 0x1p1000}) {
    const PosedPolytope a(Box({size, size, size})), b(Segment({3 * size, -size, 0}, {3 * size, size, size}));
    const Distance d = distance(a, b);
    EXPECT_EQ(d.lower, 2 * size);
    EXPECT_EQ(d.upper, 2 * size);
    EXPECT_EQ(d.on_a, (Vec3{size, -size, 0}));
    EXPECT_FALSE(overlap(a, b));
    EXPECT_TRUE(overlap(a, PosedPolytope(Segment({size, size, size}, {3 * size, 0, 0}))));
  }
}

TEST(ConvexDistance, IsInfiniteAboveWhereNoDoubleIsLargeEnough) {
  const double most = std::numeric_limits<double>::max();
  const Distance d = distance(PosedPolytope(Point({-most, 0, 0})), PosedPolytope(Point({most, most, most})));
  EXPECT_EQ(d.lower, most);
  EXPECT_EQ(d.upper, std::numeric_limits<double>::infinity());
  EXPECT_EQ(d.on_b, (Vec3{most, most, most}));
}

// What is common in use takes no slow path.

TEST(ConvexDistance, OfAlignedBoxesIsAClosedForm) {
  SimplexCache workspace;
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto any = [&] {
      const double x = random.between(0.1, 1), y = random.between(0.1, 1), z = random.between(0.1, 1);
      return Vec3{x, y, z};
    };
    const Vec3 size_a = any(), size_b = any(), place = 3.0 * any();
    const PosedPolytope a = box(size_a, {}), b = box(size_b, place);
    VertexPairs first;
    first.append(0, 0);
    const ExactNearest nearest = exact_nearest(a, b, first);
    const Distance d = distance(a, b, &workspace);
    EXPECT_EQ(overlap(a, b), nearest.meet);
    if (nearest.meet) {
      EXPECT_EQ(d.upper, 0);
    } else {
      EXPECT_EQ(d, rounded_distance(nearest, 0, 0));
    }
  }
  EXPECT_EQ(workspace.counts.closed_forms, 1000U);
}

/// A ball, an upright or a lying capsule, a box or a rounded one, at coordinates that are often equal.
PosedPolytope aligned_body(Random& random) {
  const auto coarse = [&] { return static_cast<double>(random.below(9)) / 4; };
  const auto fine = [&] { return random.between(0.1, 1); };
  const bool is_coarse = random.below(2) == 0;
  const auto any = [&] { return is_coarse ? 0.25 + coarse() : fine(); };
  const Vec3 at = is_coarse ? Vec3{2 * coarse(), 2 * coarse(), 2 * coarse()} : 3.0 * Vec3{fine(), fine(), fine()};
  const Pose pose = Pose::translation(at);
  Vec3 way{};
  way[static_cast<int>(random.below(3))] = any();
  switch (random.below(4)) {
    case 0:
      return PosedPolytope(Sphere(0.5 * any()), pose);
    case 1:
      return PosedPolytope(Capsule(-way, way, 0.5 * any()), pose);
    case 2:
      return PosedPolytope(Box({any(), any(), any()}), pose);
    default:
      return PosedPolytope(Rounded(Box({any(), any(), any()}), 0.25 * any()), pose);
  }
}

void expect_exact_distance(const Distance& found, const ExactNearest& nearest, double radius_a, double radius_b) {
  const Distance exact = rounded_distance(nearest, radius_a, radius_b);
  EXPECT_EQ(found.lower, exact.lower);
  EXPECT_EQ(found.upper, exact.upper);
  if (nearest.meet) return;  // any common point of the cores will do
  EXPECT_EQ(found.on_a, exact.on_a);
  EXPECT_EQ(found.on_b, exact.on_b);
}

TEST(AlignedCores, AreAnsweredAsByExactArithmeticAndWithoutIt) {
  Random random(3);
  std::size_t told = 0, depths = 0;
  for (int i = 0; i < 4000; ++i) {
    SCOPED_TRACE(i);
    const PosedPolytope a = aligned_body(random), b = aligned_body(random);
    const ExactNearest nearest = exact_nearest(a, b, first_vertices());
    const std::optional<Distance> d = distance_of_aligned_cores(a, b);
    if (d) expect_exact_distance(*d, nearest, a.radius(), b.radius());
    const std::optional<bool> meet = aligned_cores_meet(a, b);
    if (meet) {
      EXPECT_EQ(*meet, offset_shapes_meet(nearest, a.radius(), b.radius()));
    }
    told += static_cast<std::size_t>(d.has_value() && meet.has_value());
    if (a.radius() + b.radius() == 0 && !nearest.meet) continue;
    const bool is_in_order = is_canonical_order(a, b);
    const PosedPolytope &first = is_in_order ? a : b, &second = is_in_order ? b : a;
    const std::optional<ConvexSeparation> parted = part_aligned_cores(first, second);
    depths += static_cast<std::size_t>(parted.has_value());
    if (!parted) continue;
    const ConvexSeparation expanded = part_by_expansion(first, second);
    const std::optional<Penetration> found = is_in_order ? parted->penetration : flipped(parted->penetration);
    const Penetration wide = is_in_order ? expanded.penetration : flipped(expanded.penetration);
    EXPECT_LE((1 - 0x1p-49) * wide.lower, found->lower);
    EXPECT_GE((1 + 0x1p-49) * wide.upper, found->upper);
    EXPECT_LE(wide.lower, found->upper);
    EXPECT_GE(wide.upper, found->lower);
    EXPECT_LE(found->upper, (1 + 0x1p-48) * found->lower);
    if (!(found->upper > 0)) continue;
    const Vec3 apart = (found->upper + 1e-12) * found->direction;
    EXPECT_FALSE(overlap_by_gjk(a, b.moved(apart)));
    const Vec3 between = found->on_a - found->on_b;
    EXPECT_NEAR(dot(between, found->direction), found->upper, 1e-12);
  }
  EXPECT_GT(told, 3600U);
  EXPECT_GT(depths, 2000U);
}

/// The least point of an edge beside an edge is a vertex, and so are the features told.
TEST(AlignedCores, HaveFeaturesThatHoldTheNearestPoints) {
  Random random(6);
  std::size_t told = 0;
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const PosedPolytope a = aligned_body(random), b = aligned_body(random);
    if (a.radius() + b.radius() == 0) continue;
    const std::optional<ConvexSeparation> parted = part_aligned_cores(a, b);
    if (!parted || parted->pairs.size == 0) continue;
    ++told;
    const auto expect_held = [&](const PosedPolytope& shape, const std::array<Index, 4>& vertex, const Vec3& on_core) {
      Aabb around;
      for (std::size_t k = 0; k < parted->pairs.size; ++k) around = merge(around, shape.vertex(vertex[k]));
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(on_core[axis], around.lower[axis] - 1e-12);
        EXPECT_LE(on_core[axis], around.upper[axis] + 1e-12);
      }
    };
    const Penetration& p = parted->penetration;
    expect_held(a, parted->pairs.a, p.on_a - a.radius() * p.direction);
    expect_held(b, parted->pairs.b, p.on_b + b.radius() * p.direction);
  }
  EXPECT_GT(told, 400U);
}

TEST(AlignedCores, ExchangedHaveTheSameBits) {
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const PosedPolytope a = aligned_body(random), b = aligned_body(random);
    const Distance there = distance(a, b), back = distance(b, a);
    EXPECT_EQ(there, (Distance{back.lower, back.upper, back.on_b, back.on_a, back.status}));
    EXPECT_EQ(penetration(a, b), flipped(penetration(b, a)));
    EXPECT_EQ(manifold(a, b), flipped(manifold(b, a)));
  }
}

/// The commonest pair of a game: an upright capsule and a box that is not turned. Exact arithmetic took fifty times as
/// long.
TEST(AlignedCores, OfAnUprightCapsuleAndABoxNeedNoExactArithmetic) {
  SimplexCache workspace;
  Random random(5);
  const Box box({0.7, 0.6, 0.65});
  for (int i = 0; i < 1000; ++i) {
    const auto any = [&] { return random.between(-2.5, 2.5); };
    const PosedPolytope a(Capsule({0, 0, -0.5}, {0, 0, 0.5}, 0.9), Pose::translation(any(), any(), any()));
    const PosedPolytope b(box, Pose::translation(any(), any(), any()));
    static_cast<void>(overlap(a, b, &workspace));
    static_cast<void>(distance(a, b, &workspace));
    static_cast<void>(penetration(a, b, &workspace));
  }
  EXPECT_LT(workspace.counts.exact, 5U);
  EXPECT_GT(workspace.counts.closed_forms, 2990U);
}

/// Also where the segment crosses the box, ends in it, lies beside a face or an edge, or the pose is no rotation.
TEST(ConvexOverlap, OfACapsuleAndABoxIsToldByAFormula) {
  Random random(8);
  std::size_t told = 0;
  constexpr std::size_t count = 4000;
  for (std::size_t i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const auto any = [&](double size) {
      return Vec3{random.between(-size, size), random.between(-size, size), random.between(-size, size)};
    };
    const Vec3 half = Vec3{1.1, 1.1, 1.1} + any(1);
    Pose pose{i % 3 == 0 ? Mat3{} : turned(random.between(0, 7)), any(2)};
    if (i % 5 == 0) pose.linear[0] = pose.linear[0] + 1e-9 * pose.linear[1];
    Vec3 way = any(3);
    if (i % 4 == 0) way = {0, 0, way.z};
    const PosedPolytope capsule(Capsule(-way, way, random.between(0.01, 1)), Pose::translation(any(3)));
    const PosedPolytope body(Box(half), pose);
    const Nearness found = nearness_by_formula(capsule, body);
    EXPECT_EQ(found, nearness_by_formula(body, capsule));
    if (found == Nearness::unknown) continue;
    ++told;
    EXPECT_EQ(found == Nearness::meet, overlap_by_gjk(capsule, body));
  }
  EXPECT_GT(told, count - 10);
}

std::string witness_fault_of(const Distance& d, const PosedPolytope& a, const PosedPolytope& b) {
  return test::witness_fault(d, museum::set_of(a), museum::set_of(b));
}

/// Beside it, through it and in it.
TEST(ConvexDistance, OfACapsuleThatMeetsABoxIsAClosedForm) {
  Random random(9);
  std::size_t meeting = 0, told = 0;
  for (int i = 0; i < 500; ++i) {
    const auto any = [&](double size) {
      return Vec3{random.between(-size, size), random.between(-size, size), random.between(-size, size)};
    };
    const Vec3 way = any(3);
    const PosedPolytope capsule(Capsule(-way, way, random.between(0.01, 1)), Pose::translation(any(2)));
    const PosedPolytope body = box({1, 1.5, 0.5}, {0.1, 0.2, 0.3}, turned(random.between(0, 7)));
    SimplexCache workspace;
    const Distance found = distance(capsule, body, &workspace);
    if (found.upper > 0) continue;
    ++meeting;
    told += workspace.counts.closed_forms;
    EXPECT_EQ(witness_fault_of(found, capsule, body), "") << i;
    EXPECT_EQ(distance(body, capsule), test::exchanged(found)) << i;
  }
  EXPECT_GT(meeting, 200U);
  EXPECT_EQ(told, meeting);
}

/// Weights of the corners that it is made of are products of three coordinates, and must not overflow.
TEST(ConvexDistance, OfSolidsThatMeetHasACommonPointWhateverTheirSize) {
  Random random(10);
  for (int i = 0; i < 600; ++i) {
    const double size = std::pow(10.0, random.between(-99, 99)), thin = i % 3 == 0 ? 1e-9 : 1;
    const Mat3 other = turned(random.between(0, 7));
    const PosedPolytope a = box({size, 2 * size, thin * size}, {3 * size, 0, 0}, turned(random.between(0, 7)));
    const PosedPolytope b =
        box({size, thin * size, size}, {random.between(2, 4) * size, 0, 0}, {{other[1], other[2], other[0]}});
    const Distance found = distance(a, b);
    EXPECT_EQ(witness_fault_of(found, a, b), "") << i << ", size " << size;
  }
}

TEST(ConvexOverlap, OfAlignedBoxesThatTouchIsAClosedForm) {
  SimplexCache workspace;
  EXPECT_TRUE(overlap(box({1, 1, 1}, {}), box({1, 1, 1}, {2, 0.5, 0.25}), &workspace));
  EXPECT_FALSE(overlap(box({1, 1, 1}, {}), box({1, 1, 1}, {std::nextafter(2, 3), 0.5, 0.25}), &workspace));
  EXPECT_EQ(workspace.counts.exact, 0U);
}

TEST(ConvexDistance, OfTurnedBoxesIsProvedWithoutExactArithmetic) {
  SimplexCache workspace;
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.between(0, 7);
    const Mat3 other = turned(random.between(0, 7));
    const Mat3 tilted = {{other[1], other[2], other[0]}};
    workspace.simplex_size = 0;
    static_cast<void>(
        distance(box({1, 2, 3}, {}, turned(angle)), box({1, 1, 1}, {4, 4, random.between(0, 5)}, tilted), &workspace));
  }
  EXPECT_LT(workspace.counts.exact, 10U);
}

TEST(ConvexDistance, NeverChangesWithWhatAnotherPairLeftInTheWorkspace) {
  Random random(3);
  SimplexCache workspace;
  workspace.simplex_size = 4;
  workspace.vertex_a = {0, 7, 7, 900};
  workspace.vertex_b = {7, 7, 0, 3};
  const PosedPolytope a = box({1, 1, 1}, {}), b = box({1, 1, 1}, {2.5, 0.5, 0.25}, turned(0.5));
  const PosedPolytope point(Point({3, 3, 3}));
  EXPECT_EQ(distance(a, b, &workspace), distance(a, b));
  EXPECT_EQ(distance(a, point, &workspace), distance(a, point));
  EXPECT_EQ(distance(point, b, &workspace), distance(point, b));
}

}  // namespace
}  // namespace toccata
