#include "trees/near_triangles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "math/floats.hpp"
#include "oracle/convex.hpp"
#include "support/simd_levels.hpp"
#include "toccata/core/random.hpp"
#include "trees/wide_point.hpp"

namespace toccata::test {
namespace {

using oracle::exact;
using oracle::Rational;

/// A mesh in its tree.
struct Scene {
  explicit Scene(TriangleMesh given) : mesh(std::move(given)) {
    std::vector<Aabb> boxes;
    for (const auto& corner : mesh.triangles())
      boxes.push_back(merge(merge(merge(Aabb{}, mesh.vertices()[corner[0]]), mesh.vertices()[corner[1]]),
                            mesh.vertices()[corner[2]]));
    tree = build_wide_bvh(boxes);
    leaves = leaf_triangles(tree, mesh);
  }

  [[nodiscard]] oracle::RationalPoint in_tree(const Vec3& v) const {
    const auto of = [&](int axis) { return (exact(v[axis]) - exact(tree.origin[axis])) / exact(tree.unit); };
    return {of(0), of(1), of(2)};
  }

  /// The exact square of how far a triangle of the tree is from a point of it.
  [[nodiscard]] Rational squared_distance(const Vec3& at, std::size_t number) const {
    const auto& corner = mesh.triangles()[number];
    oracle::ConvexSet triangle;
    for (const Index i : corner) triangle.vertices.push_back(in_tree(mesh.vertices()[i]));
    return oracle::nearest_points(oracle::point_set(at), triangle).squared_distance;
  }

  TriangleMesh mesh;
  WideBvh tree;
  LeafTriangles leaves;
};

struct Found {
  std::vector<Index> numbers;
  std::vector<float> lowers;
  float limit;
  friend bool operator==(const Found&, const Found&) = default;
};

Found found(const Scene& scene, const Vec3& at, std::size_t k, float limit = infinite_float) {
  NearTriangles::Memory memory;
  NearTriangles near(k, limit, memory);
  static_cast<void>(find_near(scene.tree, scene.leaves, {at, 0}, near));
  const auto left = near.those_left();
  return {{left.begin(), left.end()}, {memory.lowers.data(), memory.lowers.data() + left.size()}, near.limit()};
}

Vec3 in_cube(Random& random, double size) {
  const double x = random.between(-size, size), y = random.between(-size, size);
  return {x, y, random.between(-size, size)};
}

/// Large, small, tiny triangles, needles, some of no area or no extent.
Scene triangles_of_all_kinds(Random& random, double scale, const Vec3& origin) {
  std::vector<Vec3> vertices;
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 0; i < 24; ++i) {
    const double size = std::exp2(-2.0 * static_cast<double>(random.below(20)));
    const Vec3 a = in_cube(random, 1), u = in_cube(random, size), v = in_cube(random, size);
    const auto kind = random.below(5);
    const Vec3 b = a + u;
    const Vec3 c = kind == 0   ? a
                   : kind == 1 ? a + 0.3 * u
                   : kind == 2 ? a + 0.7 * u + 0x1p-30 * v
                   : kind == 3 ? b
                               : a + v;
    for (const Vec3& p : {a, b, c}) vertices.push_back(scale * p + origin);
    triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return Scene(TriangleMesh(std::move(vertices), std::move(triangles)));
}

/// Anywhere, far away, or at a hair's distance of a corner.
Vec3 some_point(Random& random, const Scene& scene) {
  const auto where = random.below(4);
  if (where == 0) return in_cube(random, 2);
  if (where == 1) return in_cube(random, std::exp2(random.between(1, 29)));
  const Vec3& corner = scene.mesh.vertices()[random.below(scene.mesh.vertices().size())];
  const Vec3 near_corner = (1 / scene.tree.unit) * (corner - scene.tree.origin);
  return where == 2 ? near_corner : near_corner + in_cube(random, std::exp2(random.between(-60, 0)));
}

/// What is wrong with the bounds; nothing where all is right.
std::string fault_of_bounds(const Scene& scene, const Vec3& at, std::size_t k) {
  std::vector<Rational> squares;
  for (std::size_t i = 0; i < scene.mesh.triangle_count(); ++i) squares.push_back(scene.squared_distance(at, i));
  const Found some = found(scene, at, k);
  for (std::size_t i = 0; i < some.numbers.size(); ++i)
    if (exact(double{some.lowers[i]}) * exact(double{some.lowers[i]}) > squares[some.numbers[i]])
      return "lower of " + std::to_string(some.numbers[i]);
  std::vector<Rational> sorted = squares;
  std::sort(sorted.begin(), sorted.end());
  const Rational limit = exact(double{some.limit});
  if (limit * limit < sorted[k - 1]) return "limit";
  // 2⁻¹⁹ of the greatest coordinate and 2⁻²³ are what may be added.
  const double size = std::max({std::fabs(at.x), std::fabs(at.y), std::fabs(at.z)}) + 2;
  if (double{some.limit} > std::sqrt(static_cast<double>(sorted[k - 1])) + 0x1p-17 * size) return "a loose limit";
  for (std::size_t i = 0; i < squares.size(); ++i)
    if (squares[i] <= sorted[k - 1] && std::count(some.numbers.begin(), some.numbers.end(), i) != 1)
      return "it misses " + std::to_string(i);
  return "";
}

TEST(NearTriangles, BoundsHoldInRationalArithmeticAtEverySimdLevel) {
  test::at_every_simd_level([](SimdLevel level) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      Random random(seed);
      const double scale = std::exp2(static_cast<double>(random.below(200)) - 100);
      const Scene scene = triangles_of_all_kinds(random, scale, scale * in_cube(random, 1e6));
      const Vec3 at = some_point(random, scene);
      const std::size_t k = std::array<std::size_t, 4>{1, 1, 3, 24}[random.below(4)];
      ASSERT_EQ(fault_of_bounds(scene, at, k), "") << "seed " << seed << ", " << name_of(level);
    }
  });
}

TEST(NearTriangles, AreTheSameAtEverySimdLevel) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const Scene scene = triangles_of_all_kinds(random, 1, {});
    const Vec3 at = some_point(random, scene);
    const Found at_best = found(scene, at, 2);
    test::at_every_simd_level(
        [&](SimdLevel level) { EXPECT_EQ(found(scene, at, 2), at_best) << seed << ", " << name_of(level); });
  }
}

TEST(NearTriangles, AreThoseWithinTheLimit) {
  Random random(3);
  const Scene scene = triangles_of_all_kinds(random, 1, {});
  EXPECT_TRUE(found(scene, {9, 0, 0}, 1, 1.0F).numbers.empty());
  EXPECT_TRUE(found(scene, {0, 0, 0}, 1, -1.0F).numbers.empty());
  EXPECT_EQ(found(scene, {9, 0, 0}, 24, 100.0F).numbers.size(), 24U);
  EXPECT_EQ(found(scene, {9, 0, 0}, 24, 100.0F).limit, found(scene, {9, 0, 0}, 24).limit);
}

TEST(NearTriangles, AreAllOfManyThatAreEquallyNear) {
  std::vector<Vec3> vertices{{0, 0, 1}};
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 0; i < 1000; ++i) {
    const double angle = 0.001 * static_cast<double>(i);
    vertices.push_back({std::cos(angle), std::sin(angle), 0});
    if (i > 0) triangles.push_back({0, i, i + 1});
  }
  const Scene scene(TriangleMesh(std::move(vertices), std::move(triangles)));
  const Vec3 above = (1 / scene.tree.unit) * (Vec3{0, 0, 3} - scene.tree.origin);
  EXPECT_EQ(found(scene, above, 1).numbers.size(), 999U);
}

}  // namespace
}  // namespace toccata::test
