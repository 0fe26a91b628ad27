// The main of every test program: the tests it was linked with, and thin slices of the families of its sweeps as tests,
// <sweep>.<family>.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "support/fewer_cases.hpp"
#include "support/sweep.hpp"
#include "toccata/core/simd.hpp"

namespace toccata::test {
namespace {

constexpr std::uint64_t slice_seed = 0;

#ifdef __OPTIMIZE__
constexpr bool built_to_be_slow = false;
#else
constexpr bool built_to_be_slow = true;
#endif

const char* simd_level_of_environment() { return std::getenv("TOCCATA_SIMD"); }

std::uint64_t slice_of(const Sweep& sweep) {
  const bool thin = built_to_be_slow || simd_level_of_environment() != nullptr;
  return fewer_under_tsan(thin && sweep.thin_slice > 0 ? sweep.thin_slice : sweep.slice);
}

/// Some families of a sweep.
class SweepSlice : public testing::Test {
 public:
  SweepSlice(const Sweep& sweep, std::vector<std::string> families) : sweep_(sweep), families_(std::move(families)) {}

  void TestBody() override {
    const std::uint64_t cases = slice_of(sweep_);
    for (const std::string& family : families_) {
      const SweepResult result = sweep_.run(family, slice_seed, cases);
      EXPECT_GT(result.cases, 0U);
      EXPECT_EQ(result.wrong, 0U) << family << ": " << result.first_failure << "\nseed " << slice_seed << ", " << cases
                                  << " cases";
    }
  }

 private:
  const Sweep& sweep_;
  std::vector<std::string> families_;
};

/// The families whose names have the same text before a slash are one test, since a test costs a process.
void register_slices() {
  const auto name_of_test = [](const std::string& family) { return family.substr(0, family.find('/')); };
  for (const Sweep& sweep : sweeps()) {
    std::map<std::string, std::vector<std::string>> tests;
    for (const std::string& family : sweep.families) tests[name_of_test(family)].push_back(family);
    for (const auto& [name, families] : tests) {
      const std::vector<std::string>& own = families;
      testing::RegisterTest(sweep.name.c_str(), name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                            [&sweep, own]() -> testing::Test* { return new SweepSlice(sweep, own); });
    }
  }
}

/// The SIMD level that the environment's TOCCATA_SIMD names is used in all tests. False where the machine lacks it, and
/// with TOCCATA_SIMD_LOWER where it is the highest, which is used anyway.
bool use_level_of_environment() {
  const char* name = simd_level_of_environment();
  if (name == nullptr) return true;
  if (std::getenv("TOCCATA_SIMD_LOWER") != nullptr && name == name_of(simd_levels().back())) {
    std::printf("%s is used in all tests\n", name);
    return false;
  }
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
