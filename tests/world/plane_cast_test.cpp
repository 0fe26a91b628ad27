#include "world/character_mover/plane_cast.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "oracle/convex.hpp"
#include "toccata/core/random.hpp"
#include "world/character_mover/rounded_box.hpp"

// What is left out by planes and boxes is compared with exact distances along the way.
namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

Vec3 place_of_cast(Random& random, double size) {
  const double x = random.between(-size, size), y = random.between(-size, size);
  return {x, y, random.between(-size, size)};
}

/// A capsule's axis, where it goes, and a triangle beside or before it, seldom a needle.
struct WayCase {
  Vec3 low, high, motion;
  Triangle triangle{};
  double distance = 0;

  [[nodiscard]] FewCorners corners() const {
    FewCorners few;
    few.add(low);
    few.add(high);
    return few;
  }
  /// The exact square of the distance at a time of the way, whose place is rounded as the mover rounds it.
  [[nodiscard]] Rational square_at(double time) const {
    const Vec3 by = time * motion;
    return oracle::squared_distance(oracle::segment_set(low + by, high + by),
                                    oracle::triangle_set(triangle[0], triangle[1], triangle[2]));
  }
  [[nodiscard]] bool is_free_at(double time) const { return square_at(time) > exact(distance) * exact(distance); }
};

WayCase random_way(Random& random) {
  WayCase one;
  const Vec3 far = random.below(2) == 0 ? Vec3{} : place_of_cast(random, 1000);
  one.low = far + place_of_cast(random, 0.2);
  one.high = one.low + (random.below(3) == 0 ? place_of_cast(random, 1) : Vec3{0, 0, 1});
  const Vec3 to_middle = place_of_cast(random, 1.2), middle = one.low + to_middle;
  one.motion = random.below(2) == 0 ? place_of_cast(random, 0.5) : to_middle;
  for (Vec3& corner : one.triangle.vertex) corner = middle + place_of_cast(random, 0.4);
  if (random.below(4) == 0) one.triangle.vertex[2] = one.triangle[0] + 1.01 * (one.triangle[1] - one.triangle[0]);
  one.distance = random.between(0.1, 0.6);
  return one;
}

constexpr double spare = 1e-9;

TEST(PlaneCast, NothingIsMetBeforeTheTimesThatItTells) {
  Random random(21);
  int beside = 0, on_the_way = 0;
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const WayCase one = random_way(random);
    const FewCorners corners = one.corners();
    const PlaneCast cast(corners, one.motion, {one.distance, spare, 0});
    const PlaneCast::Times times = cast.times_of(planes_of(one.triangle));
    const double free = std::min(1.0, std::max(times.free, times.earliest));
    if (free == 0) continue;
    (free < 1 ? on_the_way : beside) += 1;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 0.9375, 0.999}) EXPECT_TRUE(one.is_free_at(share * free));
    if (cast.is_kept_off(face_of(one.triangle))) {
      EXPECT_GT(times.free, 1);
    }
  }
  EXPECT_GT(beside, 50);
  EXPECT_GT(on_the_way, 40);
}

/// A face and a side tell what neither tells alone: 0.3 beside the edge and 0.4 above the face are 0.5.
TEST(PlaneCast, AFaceAndASideAreTakenTogether) {
  const Triangle triangle{{Vec3{0, 0, 0}, {-4, 4, 0}, {-4, -4, 0}}};
  const Triangle turned{{Vec3{0, -4, 0}, {0, 4, 0}, {-4, 0, 0}}};
  FewCorners corners;
  corners.add({0.3, 0, 0.4});
  corners.add({0.3, 0, 1.4});
  for (const double distance : {0.45, 0.4999}) {
    const PlaneCast::Times times = PlaneCast(corners, {}, {distance, spare, 0}).times_of(planes_of(turned));
    EXPECT_LE(times.free, 1);
    EXPECT_GT(times.earliest, 1);
  }
  EXPECT_LE(PlaneCast(corners, {}, {0.5001, spare, 0}).times_of(planes_of(turned)).earliest, 1);
  EXPECT_LE(PlaneCast(corners, {}, {0.5001, spare, 0}).times_of(planes_of(triangle)).earliest, 1);
  // It goes down by 0.2, and is met at once, halfway, or not.
  const Vec3 down{0, 0, -0.2};
  const double at_half = std::hypot(0.3, 0.3);
  EXPECT_NEAR(PlaneCast(corners, down, {at_half, spare, 0}).times_of(planes_of(turned)).earliest, 0.5, 1e-6);
  EXPECT_GT(PlaneCast(corners, down, {0.3, spare, 0}).times_of(planes_of(turned)).earliest, 1);
}

TEST(RoundedBox, MissesOnlyWhatIsFartherThanItsRadius) {
  const RoundedBox box({{0, 0, 0}, {1, 1, 1}}, 0.5);
  const auto misses = [&](const Vec3& at) { return box.misses({at, at + Vec3{1, 1, 1}}); };
  EXPECT_FALSE(misses({0.25, 0.25, 0.25}));
  EXPECT_FALSE(misses({1.5, 0, 0}));  // at the radius
  EXPECT_TRUE(misses({1.5001, 0, 0}));
  EXPECT_FALSE(misses({1.3, 1.4, 0}));  // 0.3 and 0.4 are 0.5
  EXPECT_TRUE(misses({1.3001, 1.4, 0}));
  EXPECT_TRUE(misses({1.4, 1.4, 0.5}));  // though the boxes around them meet
  EXPECT_TRUE(misses({-1.3001, 0, 1.4}));
}

}  // namespace
}  // namespace toccata::test
