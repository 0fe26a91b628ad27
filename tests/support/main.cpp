// The main of every test program: the tests it was linked with, and a thin slice of each family of its sweeps as a test
// of its own, <sweep>.<family>.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "support/sweep.hpp"
#include "toccata/core/simd.hpp"

namespace toccata::test {
namespace {

constexpr std::uint64_t slice_seed = 0;

class SweepSlice : public testing::Test {
 public:
  SweepSlice(const Sweep& sweep, const std::string& family) : sweep_(sweep), family_(family) {}

  void TestBody() override {
    const SweepResult result = sweep_.run(family_, slice_seed, sweep_.slice);
    EXPECT_GT(result.cases, 0U);
    EXPECT_EQ(result.wrong, 0U) << result.first_failure << "\nseed " << slice_seed << ", " << sweep_.slice << " cases";
  }

 private:
  const Sweep& sweep_;
  std::string family_;
};

void register_slices() {
  for (const Sweep& sweep : sweeps()) {
    for (const std::string& family : sweep.families) {
      testing::RegisterTest(sweep.name.c_str(), family.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                            [&sweep, family]() -> testing::Test* { return new SweepSlice(sweep, family); });
    }
  }
}

/// The SIMD level that the environment's TOCCATA_SIMD names is used in all tests. False where the machine lacks it.
bool use_level_of_environment() {
  const char* name = std::getenv("TOCCATA_SIMD");
  if (name == nullptr) return true;
  for (const SimdLevel level : simd_levels())
    if (name_of(level) == std::string_view(name)) {
      use_simd_level(level);
      return true;
    }
  std::printf("this machine has no %s\n", name);
  return false;
}

}  // namespace
}  // namespace toccata::test

int main(int argument_count, char** arguments) {
  constexpr int skipped = 77;
  if (!toccata::test::use_level_of_environment()) return skipped;
  testing::InitGoogleTest(&argument_count, arguments);
  toccata::test::register_slices();
  return RUN_ALL_TESTS();
}
