#include "support/evidence.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace toccata::test {
namespace {

std::filesystem::path file_in_test_folder(const char* name) { return std::filesystem::path(testing::TempDir()) / name; }

Evidence three_shards_of_two_commits() {
  Evidence evidence;
  evidence.add("needles", 0, {.cases = 10}, 0.5, "0.1.0", "abc");
  evidence.add("needles", 2, {.cases = 10}, 0.5, "0.1.0", "abc");
  evidence.add("needles", 1, {.cases = 10, .wrong = 1, .first_failure = "case 7"}, 0.5, "0.1.0", "def");
  return evidence;
}

TEST(Evidence, AddsUpOverCommits) {
  const Evidence evidence = three_shards_of_two_commits();
  EXPECT_EQ(evidence.family("needles").cases(), 30U);
  EXPECT_EQ(evidence.family("needles").cases_of("abc"), 20U);
  EXPECT_EQ(evidence.family("needles").cases_of("nobody"), 0U);
  EXPECT_EQ(evidence.family("needles").wrong(), 1U);
  EXPECT_EQ(evidence.family("needles").next_shard(), 3U);
  EXPECT_EQ(evidence.family("never run").next_shard(), 0U);
}

TEST(Evidence, FillsTheFirstGap) {
  Evidence evidence;
  evidence.add("random", 0, {.cases = 1}, 0, "0.1.0", "abc");
  evidence.add("random", 2, {.cases = 1}, 0, "0.1.0", "abc");
  EXPECT_EQ(evidence.family("random").next_shard(), 1U);
}

TEST(Evidence, IsTheSameAfterWritingAndReading) {
  const auto file = file_in_test_folder("evidence-roundtrip.json");
  three_shards_of_two_commits().write(file);
  const Evidence again = Evidence::read(file, "anything");
  ASSERT_EQ(again.family("needles").runs.size(), 2U);
  EXPECT_EQ(again.family("needles").runs[0].shards, (std::vector<std::uint64_t>{0, 2}));
  EXPECT_EQ(again.family("needles").runs[1].first_failure, "case 7");
  EXPECT_EQ(again.family("needles").seconds(), 1.5);
}

TEST(Evidence, RefusesAnotherFile) {
  const auto file = file_in_test_folder("not-evidence.json");
  std::ofstream(file) << "{\"format\": \"other\"}";
  EXPECT_THROW((void)Evidence::read(file, "anything"), std::runtime_error);
}

}  // namespace
}  // namespace toccata::test
