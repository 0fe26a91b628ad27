#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "narrow/penetration_checks.hpp"
#include "narrow/primitives/pair_depths.hpp"
#include "narrow/typed_forms.hpp"
#include "support/fewer_cases.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/simd.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/narrow/box_box.hpp"
#include "toccata/narrow/primitives.hpp"

// Depths, contact points and close distances of balls, capsules and boxes by the formulas for them, compared with
// rational arithmetic, and in all their forms with each other.
namespace toccata::test {
namespace {

constexpr std::size_t ball = 0, capsule = 1, box = 2;

class RoundPairs {
 public:
  explicit RoundPairs(std::uint64_t seed) : random_(seed) {}

  /// A pair of two kinds, as deep in each other, or as far apart where it is negative, along the way between near
  /// points.
  ConvexCase near(std::size_t kind_a, std::size_t kind_b, double depth) {
    ConvexCase pair{{shape(kind_a), pose()}, {shape(kind_b), pose()}};
    pair.b.pose.offset = pair.a.pose.offset + 4.0 * direction();
    const Distance apart = distance(posed(pair.a), posed(pair.b));
    const Vec3 way = apart.on_b - apart.on_a;
    pair.b.pose.offset = pair.b.pose.offset - (1 + depth / std::sqrt(dot(way, way))) * way;
    return pair;
  }

  /// With centres as near to each other.
  ConvexCase deep(std::size_t kind_a, std::size_t kind_b, double apart) {
    ConvexCase pair{{shape(kind_a), pose()}, {shape(kind_b), pose()}};
    pair.b.pose.offset = pair.a.pose.offset + apart * direction();
    return pair;
  }

  double between(double low, double high) { return random_.between(low, high); }

 private:
  ConvexShape shape(std::size_t kind) {
    if (kind == ball) return Sphere(random_.between(0.3, 0.7), 0.25 * direction());
    if (kind == capsule) return Capsule({0.125, 0, -0.5}, {0, 0.25, 0.5}, random_.between(0.2, 0.4));
    return Box({0.5, random_.between(0.1, 0.9), 0.4}, 0.125 * direction());
  }
  Vec3 direction() {
    const Vec3 v{random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1)};
    return (1 / std::sqrt(dot(v, v))) * v;
  }
  Pose pose() {
    Pose pose;
    pose.linear = rotation_about(direction(), random_.between(0, 360));
    pose.offset = {random_.between(-1, 1), random_.between(-1, 1), random_.between(-1, 1)};
    return pose;
  }

  Random random_;
};

struct Contacts {
  Penetration depth;
  Manifold manifold;
  Distance distance;
  bool overlap = false;
  friend bool operator==(const Contacts&, const Contacts&) = default;
};

/// Which common point is told depends on the form where the cores meet.
Contacts comparable(Contacts found) {
  if (found.overlap) found.distance.on_a = found.distance.on_b = {};
  return found;
}

Contacts of_any_shapes(const ConvexCase& pair) {
  const PosedPolytope a = posed(pair.a), b = posed(pair.b);
  return {penetration(a, b), manifold(a, b), distance(a, b), overlap(a, b)};
}

/// Nothing where there are no such functions.
std::optional<Contacts> of_posed(const ConvexCase& pair) {
  return std::visit(
      [&](const auto& a, const auto& b) -> std::optional<Contacts> {
        if constexpr (requires {
                        penetration(placed(a, Pose{}), placed(b, Pose{}));
                        distance(placed(a, Pose{}), placed(b, Pose{}));
                      }) {
          const auto x = placed(a, pair.a.pose);
          const auto y = placed(b, pair.b.pose);
          return Contacts{penetration(x, y), manifold(x, y), distance(x, y), overlap(x, y)};
        } else {
          return {};
        }
      },
      pair.a.shape, pair.b.shape);
}

std::optional<Contacts> of_given(const ConvexCase& pair) {
  return std::visit(
      [&](const auto& a, const auto& b) -> std::optional<Contacts> {
        const Pose &p = pair.a.pose, &q = pair.b.pose;
        if constexpr (requires {
                        penetration(a, p, b, q);
                        distance(a, p, b, q);
                      })
          return Contacts{penetration(a, p, b, q), manifold(a, p, b, q), distance(a, p, b, q), overlap(a, p, b, q)};
        else
          return {};
      },
      pair.a.shape, pair.b.shape);
}

/// The exact distance is in the interval, and the points are where it says.
std::string wrong_with_distance(const Distance& d, const oracle::ConvexSet& a, const oracle::ConvexSet& b) {
  if (d.upper == 0) return oracle::overlap(a, b) ? "" : "told to meet";
  if (oracle::compare_distance(a, b, oracle::exact(d.lower)) < 0) return "nearer than lower";
  if (oracle::compare_distance(a, b, oracle::exact(d.upper)) > 0) return "farther than upper";
  if (d.upper > std::nextafter(d.lower, HUGE_VAL) && d.upper - d.lower > 1e-12 * d.upper) return "wide";
  const oracle::Rational near = oracle::exact(1e-11);
  if (oracle::compare_distance(oracle::point_set(d.on_a), a, near) > 0) return "point of a";
  return oracle::compare_distance(oracle::point_set(d.on_b), b, near) > 0 ? "point of b" : "";
}

std::string wrong_with_manifold(const Manifold& m, const Penetration& p, bool meet) {
  if ((m.count > 0) != meet) return "manifold";
  double deepest = 0;
  for (int i = 0; i < m.count; ++i) deepest = std::max(deepest, m.points[static_cast<std::size_t>(i)].depth);
  if (std::fabs(deepest - p.upper) > 1e-9) return "deepest point";
  return !meet || std::fabs(dot(m.normal, p.direction) - 1) <= 1e-9 ? "" : "normal";
}

std::string wrong_with_contacts(const ConvexCase& pair) {
  const oracle::ConvexSet a = set_of(pair.a), b = set_of(pair.b);
  const Contacts found = of_any_shapes(pair);
  if (std::string wrong = wrong_with(found.depth, a, b, size_of(a) + size_of(b)); !wrong.empty()) return wrong;
  if (std::string wrong = wrong_with_distance(found.distance, a, b); !wrong.empty()) return wrong;
  const bool meet = oracle::overlap(a, b);
  if (found.overlap != meet) return "overlap";
  if (std::string wrong = wrong_with_manifold(found.manifold, found.depth, meet); !wrong.empty()) return wrong;
  const Contacts other = of_any_shapes({pair.b, pair.a});
  if (!(flipped(other.depth) == found.depth)) return "depth exchanged";
  if (!same_but_flipped(found.manifold, other.manifold)) return "manifold exchanged";
  const std::optional<Contacts> typed = of_posed(pair), given = of_given(pair);
  if (typed && !(comparable(*typed) == comparable(found))) return "of posed shapes";
  if (given && !(comparable(*given) == comparable(found))) return "of shapes and poses";
  return "";
}

class RoundDepths : public testing::TestWithParam<std::size_t> {
 protected:
  static constexpr std::size_t kinds_a[] = {ball, ball, ball, capsule, capsule};
  static constexpr std::size_t kinds_b[] = {ball, capsule, box, capsule, box};
  [[nodiscard]] std::size_t kind_a() const { return kinds_a[GetParam()]; }
  [[nodiscard]] std::size_t kind_b() const { return kinds_b[GetParam()]; }
};

TEST_P(RoundDepths, AgreeWithRationalsInAllForms) {
  RoundPairs pairs(50 + GetParam());
  for (const double depth : {1e-1, 1e-2, 1e-4, 1e-7, 1e-9, 1e-12, -1e-12, -1e-7, -1e-4, -1e-1})
    for (int k = 0; k < fewer_under_tsan(6); ++k) {
      const ConvexCase pair = pairs.near(kind_a(), kind_b(), depth);
      EXPECT_EQ(wrong_with_contacts(pair), "") << to_text(pair);
    }
  for (int k = 0; k < fewer_under_tsan(12); ++k) {
    const ConvexCase pair = pairs.deep(kind_a(), kind_b(), pairs.between(0, 0.6));
    EXPECT_EQ(wrong_with_contacts(pair), "") << to_text(pair);
  }
}

// In general position nothing is left to the general way, however shallow or close, and bounds are neighbouring doubles
// but for the direction.
TEST_P(RoundDepths, AreMostlyToldByTheFormula) {
  RoundPairs pairs(60 + GetParam());
  int depths = 0, distances = 0, manifolds = 0;
  const int count = 200;
  for (int k = 0; k < count; ++k) {
    const double size = std::pow(10.0, pairs.between(-8, -1));
    const ConvexCase deep = pairs.near(kind_a(), kind_b(), size), apart = pairs.near(kind_a(), kind_b(), -size);
    const Penetration depth = depth_of_primitives(posed(deep.a), posed(deep.b));
    if (is_known(depth)) {
      ++depths;
      EXPECT_GT(depth.lower, 0);
      EXPECT_LE(depth.upper - depth.lower, 0x1p-48 * depth.upper);
    }
    manifolds += is_known(manifold_of_primitives(posed(deep.a), posed(deep.b))) ? 1 : 0;
    SimplexCache counting;
    static_cast<void>(distance(posed(apart.a), posed(apart.b), &counting));
    distances += static_cast<int>(counting.counts.closed_forms);
    EXPECT_EQ(depth_of_primitives(posed(apart.a), posed(apart.b)).upper, 0);
  }
  EXPECT_GE(depths, count * 97 / 100);
  EXPECT_GE(distances, count * 90 / 100);
  EXPECT_GE(manifolds, count * 80 / 100);
}

TEST_P(RoundDepths, HaveTheSameBitsAtEveryLevel) {
  RoundPairs pairs(70 + GetParam());
  const SimdLevel best = simd_level();
  for (int k = 0; k < 60; ++k) {
    const double size = std::pow(10.0, pairs.between(-9, -0.5));
    const ConvexCase pair = k % 3 == 0   ? pairs.deep(kind_a(), kind_b(), size)
                            : k % 3 == 1 ? pairs.near(kind_a(), kind_b(), size)
                                         : pairs.near(kind_a(), kind_b(), -size);
    const std::optional<Contacts> expected = of_given(pair);
    ASSERT_TRUE(expected.has_value());
    for (const SimdLevel level : simd_levels()) {
      use_simd_level(level);
      EXPECT_TRUE(*of_given(pair) == *expected) << name_of(level) << ' ' << to_text(pair);
    }
    use_simd_level(best);
  }
}

// Where cores meet, the general search answers; where it begins must not depend on the form.
TEST_P(RoundDepths, HaveTheSameBitsInAllFormsWhereCoresMeet) {
  RoundPairs pairs(90 + GetParam());
  for (int k = 0; k < fewer_under_tsan(400); ++k) {
    const ConvexCase pair = pairs.deep(kind_a(), kind_b(), pairs.between(0, 0.6));
    const Contacts found = comparable(of_any_shapes(pair));
    const std::optional<Contacts> typed = of_posed(pair), given = of_given(pair);
    ASSERT_TRUE(typed && given);
    EXPECT_TRUE(comparable(*typed) == found) << to_text(pair);
    EXPECT_TRUE(comparable(*given) == found) << to_text(pair);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, RoundDepths, testing::Range<std::size_t>(0, 5));

// Rounding bends the faces of a box that is far from the origin: one of the two ways to cut each in triangles is right.
TEST(RoundDepthsOf, ABallOnABentFaceAgreesWithRationals) {
  RoundPairs pairs(80);
  for (int k = 0; k < fewer_under_tsan(60); ++k) {
    ConvexCase pair = pairs.near(ball, box, std::pow(10.0, pairs.between(-9, -5)));
    const Vec3 far{1000.0 + k, -77.25, 4096};
    pair.a.pose.offset = pair.a.pose.offset + far;
    pair.b.pose.offset = pair.b.pose.offset + far;
    const oracle::ConvexSet a = set_of(pair.a), b = set_of(pair.b);
    const Penetration p = penetration(posed(pair.a), posed(pair.b));
    EXPECT_EQ(wrong_with(p, a, b, size_of(a) + size_of(b)), "") << to_text(pair);
  }
}

// What is held at an end, or lies along a face, is not taken for free by rounding.
TEST(RoundDepthsOf, NearlyParallelCapsulesAgreeWithRationals) {
  RoundPairs pairs(81);
  for (int k = 0; k < fewer_under_tsan(60); ++k) {
    const double turn = std::pow(10.0, pairs.between(-16, 1));
    ConvexCase pair = pairs.near(capsule, k % 2 == 0 ? capsule : box, 1e-3);
    const Vec3 axis{pairs.between(-1, 1), pairs.between(-1, 1), pairs.between(-1, 1)};
    if (k % 2 == 0) {
      pair.b.shape = pair.a.shape;
      pair.b.pose = pair.a.pose * Pose::rotation(axis, turn);
      pair.b.pose.offset = pair.a.pose.offset + 0.3 * axis;
    } else {
      pair.a.shape = Capsule({-0.25, 0, 0}, {0.25, 0, 0}, 0.25);
      pair.a.pose = pair.b.pose * Pose::rotation(axis, turn);
      pair.a.pose.offset = transform(pair.b.pose, {0.1, 0.1, 0.4 + 0.3 + pairs.between(-0.1, 0)});
    }
    const oracle::ConvexSet a = set_of(pair.a), b = set_of(pair.b);
    const Penetration p = penetration(posed(pair.a), posed(pair.b));
    EXPECT_EQ(wrong_with(p, a, b, size_of(a) + size_of(b)), "") << to_text(pair);
    EXPECT_EQ(wrong_with_distance(distance(posed(pair.a), posed(pair.b)), a, b), "") << to_text(pair);
  }
}

// The direction of boxes that are apart parts them, by the corners as they are.
TEST(RoundDepthsOf, BoxesThatAreApartTellADirectionThatPartsThem) {
  RoundPairs pairs(82);
  for (int k = 0; k < 200; ++k) {
    const ConvexCase pair = pairs.near(box, box, -std::pow(10.0, pairs.between(-9, 0.5)));
    const Box &a = std::get<Box>(pair.a.shape), &b = std::get<Box>(pair.b.shape);
    const Penetration p = penetration(a, pair.a.pose, b, pair.b.pose);
    EXPECT_EQ(p.upper, 0);
    EXPECT_TRUE(is_nearly_unit(p.direction));
    EXPECT_TRUE(p == penetration(posed(pair.a), posed(pair.b)));
    EXPECT_TRUE(p == flipped(penetration(b, pair.b.pose, a, pair.a.pose)));
    const oracle::RationalPoint along = oracle::exact(p.direction);
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j)
        EXPECT_GT(dot(along, oracle::exact(transform(pair.b.pose, b.corner(j))) -
                                 oracle::exact(transform(pair.a.pose, a.corner(i)))),
                  oracle::Rational(0));
  }
}

TEST(RoundDepthsOf, WhatIsNotAllowedIsRefused) {
  const Pose stretched{{{Vec3{2, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, {}}, nowhere = Pose::translation(NAN, 0, 0);
  for (const Pose& pose : {stretched, nowhere}) {
    EXPECT_THROW(static_cast<void>(penetration(Sphere(1), pose, Sphere(1), Pose{})), Error);
    EXPECT_THROW(static_cast<void>(manifold(Sphere(1), pose, Box({1, 1, 1}), Pose{})), Error);
    EXPECT_THROW(static_cast<void>(overlap(Capsule({0, 0, 0}, {1, 0, 0}, 1), pose, Box({1, 1, 1}), Pose{})), Error);
  }
  EXPECT_THROW(static_cast<void>(penetration(Sphere(1), Pose{}, Box({1, 1, 1}), nowhere)), Error);
}

TEST(RoundDepths, OfABoxThatRoundingFlattensAreNone) {
  const double far = 0x1p45;
  const Box plate({1, 1, 0x1p-10});
  const Penetration found =
      penetration(Sphere(1.1), Pose::translation(1.4, 1.3, far), plate, Pose::translation(0, 0, far));
  EXPECT_EQ(found.upper, penetration(PosedPolytope(Sphere(1.1), Pose::translation(1.4, 1.3, far)),
                                     PosedPolytope(plate, Pose::translation(0, 0, far)))
                             .upper);
  EXPECT_EQ(found.lower, 0);
}

TEST(RoundDepths, OfLeastSizesAgreeWithOverlap) {
  const Sphere a(1.5e-162);
  const Pose beside = Pose::translation(1.58e-162, 1.58e-162, 1.58e-162);
  EXPECT_TRUE(overlap(PosedPolytope(a, {}), PosedPolytope(a, beside)));
  EXPECT_GT(penetration(a, {}, a, beside).upper, 0);
  const Capsule rod({0, 0, 0}, {3e-162, 3e-162, 3e-162}, 2.8e-162);
  const Box block({1e-162, 1e-162, 1e-162});
  const Pose aside = Pose::translation(2.58e-162, 2.58e-162, 2.58e-162);
  EXPECT_EQ(overlap(rod, aside, block, {}), overlap(PosedPolytope(rod, aside), PosedPolytope(block, {})));
}

TEST(RoundDepths, AlongAnAxisTheDirectionIsOfLengthOne) {
  const double apart = 0x1.dae147ae147aep+0;
  const Penetration found =
      penetration(Sphere(0x1.96e6a337a80dp+1), {}, Sphere(0x1.3189630a4d4b3p-11), Pose::translation(apart, 0, 0));
  EXPECT_EQ(std::fabs(found.direction.x), 1);
}

}  // namespace
}  // namespace toccata::test
