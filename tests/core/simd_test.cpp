#include "toccata/core/simd.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "toccata/core/error.hpp"

namespace toccata {
namespace {

TEST(Simd, TheHighestLevelIsUsedUnlessAnotherIsAskedFor) {
  const std::vector<SimdLevel> levels = simd_levels();
  ASSERT_FALSE(levels.empty());
  EXPECT_EQ(levels.front(), SimdLevel::scalar);
  EXPECT_TRUE(std::is_sorted(levels.begin(), levels.end()));
  EXPECT_EQ(simd_level(), levels.back());
  for (const SimdLevel level : levels) {
    use_simd_level(level);
    EXPECT_EQ(simd_level(), level) << name_of(level);
  }
  EXPECT_EQ(simd_levels(), levels);
  use_simd_level(levels.back());
}

TEST(Simd, ALevelThatTheMachineLacksIsRefused) {
  const std::vector<SimdLevel> levels = simd_levels();
  for (const SimdLevel level : {SimdLevel::sse4, SimdLevel::avx2, SimdLevel::avx512})
    if (std::find(levels.begin(), levels.end(), level) == levels.end()) {
      EXPECT_THROW(use_simd_level(level), Error);
    }
}

}  // namespace
}  // namespace toccata
