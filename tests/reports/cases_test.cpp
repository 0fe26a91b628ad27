// Every case in tests/cases is asked again and must have the answer recorded in it, to the bit. A bug report is a file
// that is put there, with the right answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "toccata/reports/case_file.hpp"

namespace toccata {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> case_files() {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(TOCCATA_CASES))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Cases, AllHaveTheAnswerRecorded) {
  const std::vector<fs::path> files = case_files();
  EXPECT_GE(files.size(), 8U);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file);
    const Case content = read_case(file);
    ASSERT_TRUE(content.question);
    EXPECT_FALSE(content.answer.empty());
    for (const int threads : {1, 3}) EXPECT_EQ(replay(content, {threads, {}}).difference, "");
  }
}

}  // namespace
}  // namespace toccata
