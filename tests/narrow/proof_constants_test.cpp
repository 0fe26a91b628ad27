// Witnesses: with a constant that a proof rests on made a few times too small, these doubles give a false statement
// (docs/design/proof-constants.md).
#include <gtest/gtest.h>

#include "oracle/rational.hpp"
#include "toccata/narrow/primitives.hpp"

namespace toccata {
namespace {

using oracle::exact;

// The corner lies beyond the radius by so little that the squares round to the wrong order.
TEST(ProofConstants, ASphereAlmostAtACornerIsDecidedExactly) {
  const Vec3 centre{0x1.a94a22aa2cf6p+0, 0x1.54ac0c972ea43p+0, 0x1.1cf51ecd60fc3p+0};
  const Vec3 corner{0x1.debcdcc908c0fp-11, -0x1.f828c710c9b37p-11, -0x1.5049f600796d3p-11};
  const double radius = 0x1.337c9351083dbp+1;
  const auto way = exact(centre) - exact(corner);
  ASSERT_GT(oracle::dot(way, way), exact(radius) * exact(radius));
  const PosedSphere sphere(Sphere(radius), {{}, centre});
  EXPECT_FALSE(overlap_by_regions(sphere, {-4, -4, -4}, corner));
  EXPECT_FALSE(overlap_by_clamping(sphere, {-4, -4, -4}, corner));
}

}  // namespace
}  // namespace toccata
