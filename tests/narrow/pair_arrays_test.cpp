#include "toccata/narrow/pair_arrays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>

#include "support/convex_cases.hpp"
#include "support/simd_levels.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

Triangle world(const Triangle& t, const Pose& pose) {
  return {{transform(pose, t[0]), transform(pose, t[1]), transform(pose, t[2])}};
}

/// All pairs of two kinds, of every regime.
template <class AppendPair>
void for_cases(const std::string& kind_a, const std::string& kind_b, const AppendPair& append) {
  for (const std::string& regime : test::convex_regimes())
    for (std::uint64_t seed = 0; seed < 21; ++seed) {
      Random random(seed);
      append(test::convex_case(kind_a, kind_b, regime, random));
    }
}

/// Every number of the two, −0 and 0 told apart.
bool same_bits(const Distance& x, const Distance& y) {
  const auto numbers = [](const Distance& d) {
    return std::array{d.lower, d.upper, d.on_a.x, d.on_a.y, d.on_a.z, d.on_b.x, d.on_b.y, d.on_b.z};
  };
  return std::ranges::equal(numbers(x), numbers(y), {}, std::bit_cast<std::uint64_t, double>,
                            std::bit_cast<std::uint64_t, double>) &&
         x.status == y.status;
}

/// Each pair as it is answered alone, at every SIMD level.
template <class ArrayA, class ArrayB>
void expect_like_one_by_one(const ArrayA& a, const ArrayB& b) {
  ASSERT_GT(a.size(), 100U);
  std::vector<Distance> distances;
  for (std::size_t i = 0; i < a.size(); ++i) distances.push_back(distance(a[i], b[i]));
  test::at_every_simd_level([&](SimdLevel level) {
    const std::vector<std::uint8_t> found = overlap_each(a, b);
    const std::vector<Distance> far = distance_each(a, b);
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_EQ(found[i], overlap(a[i], b[i]) ? 1 : 0) << "pair " << i << " at " << name_of(level);
      ASSERT_TRUE(same_bits(distance(a[i], b[i]), distances[i])) << "pair " << i << " at " << name_of(level);
      ASSERT_TRUE(same_bits(far[i], distances[i])) << "pair " << i << " at " << name_of(level);
    }
  });
}

TEST(PairArrays, SpheresAndSpheres) {
  SphereArray a, b;
  for_cases("sphere", "sphere", [&](const test::ConvexCase& pair) {
    a.append(PosedSphere(std::get<Sphere>(pair.a.shape), pair.a.pose));
    b.append(PosedSphere(std::get<Sphere>(pair.b.shape), pair.b.pose));
  });
  expect_like_one_by_one(a, b);
}

TEST(PairArrays, SpheresAndTriangles) {
  SphereArray a;
  TriangleArray b;
  for_cases("sphere", "triangle", [&](const test::ConvexCase& pair) {
    a.append(PosedSphere(std::get<Sphere>(pair.a.shape), pair.a.pose));
    b.append(world(std::get<Triangle>(pair.b.shape), pair.b.pose));
  });
  expect_like_one_by_one(a, b);
}

TEST(PairArrays, SpheresAndBoxes) {
  SphereArray a;
  BoxArray b;
  for_cases("sphere", "box", [&](const test::ConvexCase& pair) {
    a.append(PosedSphere(std::get<Sphere>(pair.a.shape), pair.a.pose));
    b.append(PosedBox(std::get<Box>(pair.b.shape), pair.b.pose));
  });
  expect_like_one_by_one(a, b);
}

TEST(PairArrays, CapsulesAndCapsules) {
  CapsuleArray a, b;
  for_cases("capsule", "capsule", [&](const test::ConvexCase& pair) {
    a.append(PosedCapsule(std::get<Capsule>(pair.a.shape), pair.a.pose));
    b.append(PosedCapsule(std::get<Capsule>(pair.b.shape), pair.b.pose));
  });
  expect_like_one_by_one(a, b);
}

TEST(PairArrays, AlignedBoxesTouchInEveryCorner) {
  AlignedBoxArray a, b;
  std::vector<std::uint8_t> right;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z) {
        a.append({0, 0, 0}, {1, 1, 1});
        const Vec3 lower{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        b.append(lower, lower + Vec3{1, 1, 1});
        right.push_back(std::abs(x) < 2 && std::abs(y) < 2 && std::abs(z) < 2 ? 1 : 0);
      }
  test::at_every_simd_level([&](SimdLevel) { EXPECT_EQ(overlap_each(a, b), right); });
}

TEST(PairArrays, OfDifferentLengthsAreRefused) {
  SphereArray one;
  one.append({{0, 0, 0}, 1});
  EXPECT_THROW(static_cast<void>(overlap_each(one, SphereArray{})), Error);
  EXPECT_TRUE(overlap_each(SphereArray{}, SphereArray{}).empty());
  EXPECT_THROW(static_cast<void>(distance_each(one, SphereArray{})), Error);
  EXPECT_TRUE(distance_each(SphereArray{}, SphereArray{}).empty());
}

}  // namespace
}  // namespace toccata
