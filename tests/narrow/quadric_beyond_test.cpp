#include "narrow/quadrics/distance/quadric_beyond.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "toccata/math/pose.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata::test {
namespace {

class TrianglesAround {
 public:
  explicit TrianglesAround(double size) : size_(size) {}

  /// A triangle of the size of the shape or smaller, up to three sizes away.
  Triangle next() {
    const Vec3 middle = 3 * size_ * vector();
    const double part = size_ * std::exp2(-8 * std::fabs(unit_(random_)));
    return {{middle + part * vector(), middle + part * vector(), middle + part * vector()}};
  }
  Vec3 vector() { return {unit_(random_), unit_(random_), unit_(random_)}; }

 private:
  double size_;
  std::mt19937_64 random_{20261123};
  std::uniform_real_distribution<double> unit_{-1, 1};
};

// What is told to be beyond is so by all of its interval; and most that are, are told.
TEST(QuadricBeyond, OnlyWhatIsFartherIsBeyond) {
  for (const double size : {1.0, 1e-9, 1e12}) {
    TrianglesAround triangles(size);
    const Pose pose{rotation_about({1, 2, 3}, 40), size * Vec3{0.25, -0.5, 0.125}};
    for (const PosedQuadric& shape : {PosedQuadric(Ellipsoid({size, 0.5 * size, 0.125 * size}), pose),
                                      PosedQuadric(Cylinder(size, size), pose), PosedQuadric(Cone(size, size), pose)}) {
      QuadricBeyond beyond(shape);
      int farther = 0, told = 0;
      for (int i = 0; i < 600; ++i) {
        const Triangle triangle = triangles.next();
        const Distance gap = distance(PosedPolytope(triangle), shape);
        const double length = 0.5 * size;
        const bool is_told = beyond.is_beyond(triangle.vertex, length);
        EXPECT_TRUE(!is_told || gap.lower > length);
        EXPECT_FALSE(beyond.is_beyond(triangle.vertex, gap.upper));
        farther += gap.lower > length ? 1 : 0;
        told += is_told ? 1 : 0;
        beyond.look_along(gap.on_a - gap.on_b);
      }
      EXPECT_GT(told, farther / 2) << size;
    }
  }
}

TEST(QuadricBeyond, ATriangleThatTouchesIsBeyondNoLength) {
  const PosedQuadric egg(Ellipsoid({1, 2, 3}));
  QuadricBeyond beyond(egg);
  beyond.look_along({0, 0, 1});
  const std::array<Vec3, 3> on_top{Vec3{-1, -1, 3}, Vec3{2, -1, 3}, Vec3{0, 2, 3}};
  EXPECT_FALSE(beyond.is_beyond(on_top, 0));
  std::array<Vec3, 3> above = on_top;
  for (Vec3& p : above) p.z = 3.5;
  EXPECT_TRUE(beyond.is_beyond(above, 0.49));
  EXPECT_FALSE(beyond.is_beyond(above, 0.5));
  EXPECT_FALSE(beyond.is_beyond(above, std::numeric_limits<double>::infinity()));
}

}  // namespace
}  // namespace toccata::test
