// The truth is arithmetic without fused multiply-add, and g++ fuses by default where the target can: this file and the
// library must be compiled with -ffp-contract=off.
#include <gtest/gtest.h>

#include <cfloat>

#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

static_assert(FLT_EVAL_METHOD == 0, "doubles must be computed as doubles");

// x² = 1 + 2^-26 + 2^-54, which rounds to y; only a fused x² − y sees the last term.
constexpr double x = 0x1.0000002p0;
constexpr double y = 0x1.0000004p0;

#if defined(__x86_64__)
[[gnu::target("fma")]]
#endif
double
square_minus(const volatile double& a, const volatile double& b) {  // volatile: computed when the test runs
  const double factor = a;
  return factor * factor - b;
}

TEST(Contraction, IsOffWhereTheProcessorCouldFuse) {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor cannot fuse";
#endif
  EXPECT_EQ(square_minus(x, y), 0);
}

TEST(Contraction, DoesNotHappenInWorldVertices) {
  Pose pose;
  pose.linear[0] = {x, 1, 0};
  EXPECT_EQ(transform(pose, {x, -y, 0}).x, 0);
  pose.linear[0] = {1, x, 0};
  EXPECT_EQ(transform(pose, {-y, x, 0}).x, 0);
  pose.linear[0] = {0, 0, x};
  pose.offset.x = -y;
  EXPECT_EQ(transform(pose, {0, 0, x}).x, 0);
}

}  // namespace
}  // namespace toccata
