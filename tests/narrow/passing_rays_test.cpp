#include "narrow/triangles/passing_rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/simd_levels.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

Vec3 some_point(Random& random, double size) {
  const double x = random.between(-size, size), y = random.between(-size, size);
  return {x, y, random.between(-size, size)};
}

/// Triangles of all sizes, slivers among them, and rays through a point within, some of which end before it.
struct Cases {
  std::vector<PreparedRay> rays;
  std::vector<Triangle> triangles;
};

Cases some_cases(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  Cases cases;
  for (std::size_t i = 0; i < count; ++i) {
    const double size = std::ldexp(1.0, random.below(4) == 0 ? static_cast<int>(random.below(600)) - 300
                                                             : static_cast<int>(random.below(20)) - 10);
    const Vec3 a = some_point(random, size), u = some_point(random, size);
    const Vec3 v = random.below(5) == 0 ? 0.3 * u + some_point(random, 1e-9 * size) : some_point(random, size);
    const double s = random.between(0.1, 0.5), r = random.between(0.1, 0.5);
    const Vec3 through = a + s * u + r * v, from = some_point(random, 2 * size);
    const double lengths[] = {0.9, 1, 1.1, 2, 100};
    cases.rays.emplace_back(from, lengths[random.below(5)] * (through - from));
    cases.triangles.push_back({{a, a + u, a + v}});
  }
  return cases;
}

TEST(PassingRays, AreToldToTheLastBitAsOneByOneAtEverySimdLevel) {
  test::at_every_simd_level([](SimdLevel level) {
    const Cases cases = some_cases(7, 2003);  // so that lanes are left over
    std::vector<PassingRay> passing;
    for (std::size_t i = 0; i < cases.rays.size(); ++i) passing.push_back({&cases.rays[i], cases.triangles[i]});
    std::vector<PassingHit> hits(passing.size());
    hits_of_passing(passing, hits);
    std::size_t told = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const PassingHit alone = hit_of_passing(passing[i]);
      ASSERT_EQ(alone.told, hits[i].told) << i << " " << name_of(level);
      if (!hits[i].told) continue;
      ASSERT_EQ(alone.cast, hits[i].cast) << i << " " << name_of(level);
      const RayTime time = ray_time_of_passing(cases.rays[i], cases.triangles[i]);
      ASSERT_TRUE(time.hit) << i << " " << name_of(level);
      ASSERT_EQ(hits[i].cast, ray_hit(cases.rays[i], cases.triangles[i], time)) << i << " " << name_of(level);
      ASSERT_FALSE(time.exact);
      ++told;
    }
    EXPECT_GT(told, 300U);
    EXPECT_LT(told, 1900U);
  });
}

TEST(PassingRays, TimesAreThoseOfAnyRay) {
  const Cases cases = some_cases(8, 500);
  for (std::size_t i = 0; i < cases.rays.size(); ++i) {
    const RayTime any = ray_time(cases.rays[i], cases.triangles[i]);
    if (!any.hit || any.exact) continue;
    const RayTime passing = ray_time_of_passing(cases.rays[i], cases.triangles[i]);
    ASSERT_TRUE(passing.hit) << i;
    ASSERT_EQ(passing.lower, any.lower) << i;
    ASSERT_EQ(passing.upper, any.upper) << i;
  }
}

TEST(PassingRays, OfNoneAreNone) { hits_of_passing({}, {}); }

}  // namespace
}  // namespace toccata
