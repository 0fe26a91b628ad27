// What floats tell of rays and the triangles of a block is held against rational arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "oracle/rays.hpp"
#include "support/simd_levels.hpp"
#include "toccata/core/random.hpp"
#include "trees/wide_ray.hpp"

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;
using oracle::RationalPoint;

/// A ray and a block in floats, and what they stand for, which differs by as much as the ray admits.
struct LanesCase {
  WideRay ray;
  WideBlock block{};
  TriangleLanes lanes{};
  RationalPoint origin, motion;
  std::array<oracle::RationalTriangle, WideBlock::width> triangle;
};

Vec3 some_point(Random& random, double size) {
  const double x = random.between(-size, size), y = random.between(-size, size);
  return {x, y, random.between(-size, size)};
}

Vec3 rounded_to_floats(const Vec3& v) {
  return {double{static_cast<float>(v.x)}, double{static_cast<float>(v.y)}, double{static_cast<float>(v.z)}};
}

Vec3 within_units(const Vec3& v) {
  return {std::clamp(v.x, -1.0, 1.0), std::clamp(v.y, -1.0, 1.0), std::clamp(v.z, -1.0, 1.0)};
}

double greatest_of(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// Slivers, segments and points among them.
std::array<Vec3, 3> some_corners(Random& random, double size) {
  const Vec3 a = some_point(random, 1), u = some_point(random, size), v = some_point(random, size);
  switch (random.below(8)) {
    case 0:
      return {a, a, a};
    case 1:
      return {a, a + u, a + 0.3 * u};
    case 2:
      return {a, a + u, a + 0.5 * u + 1e-5 * v};
    case 3:
      return {a, a + u, a};
    default:
      return {a, a + u, a + v};
  }
}

void set_triangle(LanesCase& c, std::size_t lane, const std::array<Vec3, 3>& corners, double off, Random& random) {
  Vec3 least{9, 9, 9}, most{-9, -9, -9};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 corner = corners[k], meant = some_point(random, off + 0x1p-25);
    c.triangle[lane].vertex[k] = exact(corner) + exact(meant);
    for (int axis = 0; axis < 3; ++axis) {
      c.lanes.corner[k][static_cast<std::size_t>(axis)][lane] = static_cast<float>(corner[axis]);
      least[axis] = std::min(least[axis], corner[axis]);
      most[axis] = std::max(most[axis], corner[axis]);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    c.block.centre[i][lane] = static_cast<float>(0.5 * (least[axis] + most[axis]));
    c.block.extent[i][lane] = static_cast<float>(0.5 * (most[axis] - least[axis]) + 0x1p-23);
  }
  c.block.child[lane] = -1;
}

/// Where rays aim: at a place on the triangle, its rim or a corner, or beside it.
Vec3 target_of(const std::array<Vec3, 3>& t, Random& random) {
  const double r = random.unit(), s = random.unit() * (1 - r);
  switch (random.below(5)) {
    case 0:
      return t[random.below(3)];
    case 1:
      return 0.5 * (t[0] + t[1]);
    case 2:
      return t[1] + r * (t[2] - t[1]);
    case 3:
      return t[0] + 1.2 * r * (t[1] - t[0]) + 1.1 * s * (t[2] - t[0]);
    default:
      return t[0] + r * (t[1] - t[0]) + s * (t[2] - t[0]);
  }
}

void set_ray(LanesCase& c, const Vec3& aim, double off, double lean, Random& random) {
  Vec3 from = some_point(random, 1);
  if (random.below(4) == 0) from = aim + some_point(random, 1e-3);
  if (random.below(5) == 0) from = {aim.x, aim.y, -1};
  from = within_units(rounded_to_floats(from));
  const double lengths[] = {0.5, 1, 1 + 1e-7, 1.01, 1.3, 1.5, 2, 3};
  const Vec3 motion = rounded_to_floats(lengths[random.below(8)] * (aim - from));
  const double most = greatest_of(motion);
  c.ray.pad = static_cast<float>(off + lean * most + 0x1p-20);
  c.ray.lean = static_cast<float>(lean);
  for (int axis = 0; axis < 3; ++axis) {
    c.ray.origin[static_cast<std::size_t>(axis)] = static_cast<float>(from[axis]);
    c.ray.motion[static_cast<std::size_t>(axis)] = static_cast<float>(motion[axis]);
  }
  c.origin = exact(from) + exact(some_point(random, 0x1p-25));
  c.motion = exact(motion) + exact(some_point(random, 0.99 * lean * most));
}

LanesCase some_case(Random& random) {
  LanesCase c;
  const double size = std::ldexp(1.0, -static_cast<int>(random.below(random.below(3) == 0 ? 22 : 8)));
  const double off = random.below(2) == 0 ? 0 : std::ldexp(1.0, -14 - static_cast<int>(random.below(20)));
  const double lean = random.below(2) == 0 ? 0 : std::ldexp(1.0, -12 - static_cast<int>(random.below(30)));
  std::array<Vec3, 3> aimed_at;
  for (std::size_t lane = 0; lane < WideBlock::width; ++lane) {
    aimed_at = some_corners(random, size);
    for (Vec3& corner : aimed_at) corner = rounded_to_floats(within_units(corner));
    set_triangle(c, lane, aimed_at, off, random);
  }
  c.block.count = WideBlock::width;
  set_ray(c, target_of(aimed_at, random), off, lean, random);
  return c;
}

/// The ray meets the box, or hardly misses it: it is of such lanes that something is told.
bool meets_box(const LanesCase& c, std::size_t lane) {
  double enter = 0, leave = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double middle = double{c.block.centre[axis][lane]} - c.ray.origin[axis], motion = c.ray.motion[axis];
    const double reach = double{c.block.extent[axis][lane]} + c.ray.pad + 0x1p-18;
    if (motion == 0) {
      if (std::fabs(middle) > reach) return false;
      continue;
    }
    enter = std::max(enter, std::min((middle - reach) / motion, (middle + reach) / motion));
    leave = std::min(leave, std::max((middle - reach) / motion, (middle + reach) / motion));
  }
  return enter <= leave;
}

/// What is wrong with what is told of a lane, or nothing.
std::string fault_of(const LanesCase& c, const RayLanes& told, std::size_t lane) {
  const auto time = oracle::time_of_hit(c.origin, c.motion, c.triangle[lane]);
  const bool possible = (told.possible >> lane & 1U) != 0, certain = (told.certain >> lane & 1U) != 0;
  if (time && !possible) return "a hit is missed";
  if (certain && !possible) return "certain and not possible";
  if (time && *time < exact(double{told.lower[lane]})) return "met before the lower bound";
  if (!certain || !meets_box(c, lane)) return "";
  if (!time) return "no hit where one is certain";
  if (*time > exact(double{told.upper[lane]})) return "met after the upper bound";
  return "";
}

TEST(RayLanes, TellWhatIsTrueAtEverySimdLevel) {
  test::at_every_simd_level([](SimdLevel level) {
    std::size_t hits = 0, certain = 0, dropped = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      Random random(seed);
      const LanesCase c = some_case(random);
      const RayLanes told = ray_lanes(c.ray, c.block, c.lanes);
      for (std::size_t lane = 0; lane < WideBlock::width; ++lane) {
        ASSERT_EQ(fault_of(c, told, lane), "") << "seed " << seed << ", lane " << lane << ", " << name_of(level);
        dropped += (told.possible >> lane & 1U) == 0 ? 1 : 0;
      }
      constexpr std::size_t aimed_at = WideBlock::width - 1;
      hits += (told.possible >> aimed_at & 1U) != 0 ? 1 : 0;
      certain += (told.certain >> aimed_at & 1U) != 0 ? 1 : 0;
    }
    EXPECT_GT(hits, 80U);
    EXPECT_GT(certain, 8U) << "bounds are of use";
    EXPECT_GT(dropped, 1000U);
  });
}

TEST(RayLanes, WithoutKnownErrorsEveryLaneIsPossible) {
  Random random(3);
  LanesCase c = some_case(random);
  c.ray.lean = std::numeric_limits<float>::infinity();
  EXPECT_EQ(ray_lanes(c.ray, c.block, c.lanes).possible, 0xFFU);
  EXPECT_EQ(ray_lanes(c.ray, c.block, c.lanes).certain, 0U);
  c.ray.lean = 0;
  c.ray.motion = {0, 1e-30F, 0};
  EXPECT_EQ(ray_lanes(c.ray, c.block, c.lanes).possible, 0xFFU);
}

}  // namespace
}  // namespace toccata::test
