#include <gtest/gtest.h>

#include "narrow/convex_distance_checks.hpp"

namespace toccata {
namespace {

TEST(ConvexDistance, AgreesWithTheOracleForEveryKindAndRegime) {
  std::uint64_t number = 0;
  for (const std::string& kind_a : test::convex_kinds())
    for (const std::string& kind_b : test::convex_kinds())
      for (const std::string& regime : test::convex_regimes()) {
        Random random(++number);
        const test::ConvexCase pair = test::convex_case(kind_a, kind_b, regime, random);
        ASSERT_EQ(test::distance_fault(pair), "")
            << kind_a << " and " << kind_b << ", " << regime << ", seed " << number << ": " << to_text(pair);
      }
}

}  // namespace
}  // namespace toccata
