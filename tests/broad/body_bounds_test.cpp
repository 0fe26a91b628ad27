#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "broad/mixed_life.hpp"
#include "toccata/broad/bound_pairs.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

using Pairs = std::vector<IndexPair>;

TEST(BodyBounds, AreCleanedUpByTheirOwnOverlapThroughALife) {
  for (const BroadPhaseMethod method : broad_phase_methods())
    for (std::size_t kinds = 1; kinds <= 3; ++kinds) {
      Random random(100 * kinds + static_cast<std::size_t>(method));
      test::MixedLife life({method, static_cast<int>(1 + kinds % 2)}, kinds);
      for (int frame = 0; frame < 22; ++frame)
        ASSERT_EQ(life.live(frame, random), "") << name_of(method) << " of " << kinds << " kinds in frame " << frame;
      EXPECT_GT(life.cleaned(), 100U) << "boxes around them tell nearly the same";
    }
}

TEST(BodyBounds, TellTheSameAsWhenAskedOnce) {
  Random random(8);
  std::vector<Ball> balls;
  std::vector<Obb> oriented;
  for (int i = 0; i < 200; ++i) {
    balls.push_back(test::random_ball(random));
    oriented.push_back(test::random_oriented_box(random));
  }
  BroadPhase of_balls, of_oriented;
  of_balls.add(balls);
  of_oriented.add(oriented);
  const auto list = [](std::span<const IndexPair> pairs) { return Pairs(pairs.begin(), pairs.end()); };
  EXPECT_EQ(list(of_balls.update()), overlapping_pairs(std::span<const Ball>(balls)));
  EXPECT_EQ(list(of_oriented.update()), overlapping_pairs(std::span<const Obb>(oriented)));
  EXPECT_FALSE(of_balls.pairs().empty());
  EXPECT_FALSE(of_oriented.pairs().empty());
}

TEST(BodyBounds, ABallMeetsABoxWhereItsCentreIsAsNearAsItsRadius) {
  Random random(9);
  int met = 0, apart = 0;
  for (int i = 0; i < 3000; ++i) {
    const Aabb box = test::random_box("uniform", 0, random);
    const Ball ball = test::random_ball(random);
    if (is_empty(ball)) continue;
    long double squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const long double x = ball.centre[axis];
      const long double beside = std::max(
          {0.0L, static_cast<long double>(box.lower[axis]) - x, x - static_cast<long double>(box.upper[axis])});
      squared += beside * beside;
    }
    const long double distance = std::sqrt(squared), radius = ball.radius;
    if (std::fabs(distance - radius) < 1e-12L) continue;
    EXPECT_EQ(bounds_overlap(box, ball), distance < radius);
    EXPECT_EQ(bounds_overlap(ball, box), distance < radius);
    // The same box, told otherwise.
    const Vec3 half = 0.5 * (box.upper - box.lower);
    const Obb oriented{box.lower + half, {}, half};
    if (std::fabs(distance - radius) > 1e-9L) {
      EXPECT_EQ(bounds_overlap(oriented, ball), distance < radius);
    }
    (distance < radius ? met : apart) += 1;
  }
  EXPECT_GT(met, 40);
  EXPECT_GT(apart, 100);
}

/// Ways of whole length, so that it is known which balls touch: also where differences of centres are too large for
/// doubles, or squares too small.
TEST(BodyBounds, BallsAreComparedExactlyInEitherOrderOfWhateverSize) {
  struct Way {
    Vec3 half;
    double length;  ///< of the half
  };
  for (const auto& [half, length] : {Way{{2, 3, 6}, 7}, Way{{-3, 4, 0}, 5}, Way{{1, -4, 2}, std::sqrt(21.0)}})
    for (const int exponent : {0, 1021, 1000, 480, -510, -1070}) {
      const bool is_whole = length == std::floor(length);
      const double scale = std::ldexp(1.0, exponent), radius = scale * length;
      const Vec3 centre = scale * half;
      const Ball one{-centre, radius}, other{centre, radius};
      const Ball smaller{centre, std::nextafter(radius, 0.0)}, larger{centre, std::nextafter(radius, HUGE_VAL)};
      const auto expect = [&, &length = length](const AnyBound& a, const AnyBound& b, bool meet) {
        EXPECT_EQ(bounds_overlap(a, b), meet) << length << " times 2^" << exponent;
        EXPECT_EQ(bounds_overlap(b, a), meet) << length << " times 2^" << exponent;
      };
      if (is_whole) {
        expect(one, other, true);
        expect(one, smaller, false);
        expect(one, larger, true);
        expect(Ball{{}, radius}, Aabb{centre, centre}, true);
        expect(Ball{{}, smaller.radius}, Aabb{centre, centre}, false);
      } else {
        EXPECT_EQ(bounds_overlap(one, other), bounds_overlap(other, one));
        EXPECT_EQ(bounds_overlap(one, smaller), bounds_overlap(smaller, one));
      }
    }
}

TEST(BodyBounds, OverlapTheSameInEitherOrderWhereTheyBarelyTouch) {
  Random random(12);
  for (int i = 0; i < 2000; ++i) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.between(-900, 900)));
    const auto bound = [&](int kind) -> AnyBound {
      const Vec3 centre = scale * test::vector_between(random, -1, 1);
      if (kind == 0) return Ball{centre, scale * random.between(0.5, 1)};
      const Obb oriented = test::random_oriented_box(random);
      if (kind == 1) return Obb{centre, oriented.axes, scale * test::vector_between(random, 0.2, 0.8)};
      return Aabb{centre, centre + scale * test::vector_between(random, 0, 1)};
    };
    const AnyBound a = bound(i % 3), b = bound(i / 3 % 3);
    EXPECT_EQ(bounds_overlap(a, b), bounds_overlap(b, a)) << i;
  }
}

TEST(BodyBounds, ABoxMeetsAnOrientedBoxAsTwoOrientedOnesDo) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Random random(10);
  int met = 0, apart = 0;
  for (int i = 0; i < 2000; ++i) {
    const Obb oriented = test::random_oriented_box(random);
    const Vec3 centre = test::vector_between(random, 0, 7), half = test::vector_between(random, 0.1, 1);
    const Aabb box{centre - half, centre + half};
    const bool meet = overlap(Obb{centre, {}, half}, oriented);
    EXPECT_EQ(bounds_overlap(box, oriented), meet);
    EXPECT_EQ(bounds_overlap(oriented, box), meet);
    (meet ? met : apart) += 1;
    EXPECT_EQ(bounds_overlap(oriented, Aabb{{-infinity, -infinity, -infinity}, {infinity, 1, 1}}),
              !is_empty(oriented) &&
                  overlap(box_around(oriented), Aabb{{-infinity, -infinity, -infinity}, {infinity, 1, 1}}));
  }
  EXPECT_GT(met, 30);
  EXPECT_GT(apart, 500);
  EXPECT_FALSE(bounds_overlap(Aabb{}, Obb{}));
  EXPECT_FALSE(bounds_overlap(Ball{}, Obb{{}, {}, {1, 1, 1}}));
}

TEST(BodyBounds, GrowByAMargin) {
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    const double margin = std::pow(10, random.between(-9, 3));
    const Vec3 direction = test::vector_between(random, -1, 1);
    const double length = std::sqrt(dot(direction, direction));
    if (length == 0) continue;
    const Vec3 outward = (1 / length) * direction;
    const Ball ball{test::vector_between(random, 0, 7), random.between(0, 2)};
    EXPECT_TRUE(contains(offset_outward(ball, margin), ball.centre + ((ball.radius + margin) * (1 - 1e-13)) * outward));
    Obb box = test::random_oriented_box(random);
    if (is_empty(box)) continue;
    EXPECT_TRUE(contains(offset_outward(box, margin), farthest_point(box, outward) + (margin * (1 - 1e-6)) * outward));
  }
  EXPECT_EQ(offset_outward(Ball{}, 2), Ball{});
  EXPECT_EQ(offset_outward(Obb{}, 2), Obb{});
  EXPECT_EQ(offset_outward(Ball{{1, 2, 3}, 4}, 0), (Ball{{1, 2, 3}, 4}));
  EXPECT_THROW(static_cast<void>(offset_outward(Ball{{1, 2, 3}, 4}, -1)), Error);
  EXPECT_THROW(static_cast<void>(offset_outward(Obb{{}, {}, {1, 1, 1}}, std::nan(""))), Error);
}

TEST(BodyBounds, CostNothingWhereThereAreNone) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < 1000; ++i) boxes.push_back({{2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}});
  BroadPhase plain({BroadPhaseMethod::brute_force}), mixed({BroadPhaseMethod::brute_force});
  plain.add(boxes);
  mixed.add(boxes);
  const std::vector<Index> box = plain.add(std::vector<Aabb>{{{9, 9, 9}, {10, 10, 10}}});
  const std::vector<Index> ball = mixed.add(std::vector<Ball>{{{9, 9, 9}, 1}});
  EXPECT_GT(mixed.bytes(), plain.bytes() + 5'000);
  plain.remove(box);
  mixed.remove(ball);
  plain.update();
  mixed.update();
  EXPECT_EQ(mixed.bytes(), plain.bytes());
}

TEST(BodyBounds, TakeNoMoreMemoryForMoving) {
  BroadPhase phase({BroadPhaseMethod::brute_force});
  const std::vector<Index> numbers = phase.add(std::vector<Ball>(1000));
  const auto move_to = [&](double x) {
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < numbers.size(); ++i) balls.push_back({{x, 3 * static_cast<double>(i), 0}, 1});
    phase.move(numbers, balls);
    phase.update();
  };
  move_to(1);
  move_to(2);
  const std::size_t bytes = phase.bytes();
  for (int x = 3; x < 20; ++x) move_to(x);
  EXPECT_EQ(phase.bytes(), bytes);
  phase.move(numbers, std::vector<Obb>(numbers.size(), Obb{}));
  phase.update();
  EXPECT_GT(phase.bytes(), bytes + numbers.size() * sizeof(Obb));
}

TEST(BodyBounds, ACopyKeepsThem) {
  BroadPhase phase;
  phase.add(std::vector<Ball>{{{0, 0, 0}, 1}, {{1.5, 1.5, 0}, 1}, {{1.3, 1.3, 0}, 1}});
  EXPECT_EQ(phase.update().size(), 2U);
  BroadPhase copy = phase;
  copy.move(std::vector<Index>{0}, std::vector<Ball>{{{0.2, 0.2, 0}, 1}});
  EXPECT_EQ(copy.update().size(), 3U);
  EXPECT_EQ(phase.update().size(), 2U);
  EXPECT_EQ(std::get<Ball>(phase.bound(0)).centre, (Vec3{0, 0, 0}));
}

template <class Call>
std::string said_by(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(BodyBounds, RefusesWhatIsNoneAndChangesNothing) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  BroadPhase phase;
  const Ball ball{{0, 0, 0}, 1};
  const std::vector<Index> both = phase.add(std::vector<Ball>{ball, ball});
  phase.update();
  EXPECT_EQ(said_by([&] {
              phase.add(std::vector<Ball>{ball, {{0, infinity, 0}, 1}});
            }),
            "ball 1 of the 2 to add: its centre is not finite");
  EXPECT_EQ(said_by([&] {
              phase.move(both, std::vector<Ball>{{{5, 5, 5}, 1}, {{0, 0, 0}, nan}});
            }),
            "ball 1: its radius is not a number");
  Obb box{{0, 0, 0}, {}, {1, 1, 1}};
  box.axes[2] = {0, 0.1, 1};
  EXPECT_EQ(said_by([&] { phase.add(std::vector<Obb>{box}); }),
            "oriented box 0 of the 1 to add: its axes are not of unit length and at right angles: make them with "
            "orthonormal_axes");
  box.half.y = nan;
  EXPECT_EQ(said_by([&] {
              phase.move(both, std::vector<Obb>{{}, box});
            }),
            "oriented box 1: a half extent is not a number");
  EXPECT_EQ(phase.update().size(), 1U);
  EXPECT_EQ(phase.size(), 2U);
  EXPECT_EQ(phase.bound(0), AnyBound(ball));
  EXPECT_THROW(static_cast<void>(phase.bound(2)), Error);
}

}  // namespace
}  // namespace toccata
