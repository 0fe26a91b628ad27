#include "toccata/io/query_files.hpp"

#include <gtest/gtest.h>

#include <string>

#include "io/formats/parse_poses.hpp"
#include "io/text_file.hpp"

namespace toccata {
namespace {

using test::bytes_of;
using test::message_of;

std::vector<PairQuery> poses(const std::string& text) { return io::parse_poses(bytes_of(text), "p.txt"); }
std::string error_of_poses(const std::string& text) {
  return message_of([&] { (void)poses(text); });
}

const std::string identity = "1 0 0 0 1 0 0 0 1 0 0 0";

TEST(PosesFile, TwelveNumbersPlaceB) {
  const auto queries = poses("1 2 3 4 5 6 7 8 9 10 11 12\n");
  ASSERT_EQ(queries.size(), 1U);
  EXPECT_EQ(queries[0].pose_a, Pose{});
  EXPECT_EQ(queries[0].pose_b, Pose::from_numbers({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(queries[0].solid_a, Solid::automatic);
}

TEST(PosesFile, TwentyFourPlaceAAndThenB) {
  const auto queries = poses("1 2 3 4 5 6 7 8 9 10 11 12 " + identity + "\n");
  ASSERT_EQ(queries.size(), 1U);
  EXPECT_EQ(queries[0].pose_a, Pose::from_numbers({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(queries[0].pose_b, Pose{});
}

TEST(PosesFile, LinesOfMatricesAndQuaternionsPlaceBOrBoth) {
  const std::string matrix = "1 0 0 5 0 1 0 6 0 0 1 7 0 0 0 1 ", quaternion = "5 6 7 0 0 0 2 ";
  const Pose moved = Pose::translation(5, 6, 7);
  const auto queries =
      poses(matrix + "\n" + quaternion + "\n" + matrix + matrix + "\n" + quaternion + quaternion + "\n");
  ASSERT_EQ(queries.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(queries[i].pose_a, i < 2 ? Pose{} : moved) << i;
    EXPECT_EQ(queries[i].pose_b, moved) << i;
  }
  EXPECT_NE(error_of_poses("1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1\n").find("p.txt:1: the last row"), std::string::npos);
}

TEST(PosesFile, EveryNumberIsTheNearestDouble) {
  const auto queries = poses("0.1 1e-320 -0 +.5 5. 1e23 9007199254740993 2.2250738585072011e-308 1E2 0 1e-400 -7\n");
  EXPECT_EQ(queries[0].pose_b, Pose::from_numbers({0.1, 1e-320, -0.0, 0.5, 5, 1e23, 9007199254740992.0,
                                                   0x0.fffffffffffffp-1022, 100, 0, 0, -7}));
}

TEST(PosesFile, LinesCommasAndComments) {
  const std::string text =
      "\xEF\xBB\xBF# two queries\r\n\r\n  1,0,0, 0,1,0, 0,0,1, 1,0,0  # moved\r\n\t#\r\n" + identity;
  const auto queries = poses(text);
  ASSERT_EQ(queries.size(), 2U);
  EXPECT_EQ(queries[0].pose_b, Pose::translation(1, 0, 0));
  EXPECT_EQ(queries[1].pose_b, Pose{});
}

TEST(PosesFile, EveryErrorNamesFileAndLine) {
  const struct {
    std::string text, message;
  } cases[] = {
      {"", "p.txt: the file holds no pose; "},
      {"# none\n\n,\n", "p.txt: the file holds no pose; "},
      {identity + "\n1 0 0\n", "p.txt:2: a line of 12 or 24 numbers has 3; "},
      {"\n" + identity + " 7 # x\n", "p.txt:2: a line of 12 or 24 numbers has 13; "},
      {identity + " " + identity + " " + identity, "p.txt:1: a line of 12 or 24 numbers has 36; "},
      {"1 0 0 0 1 0 0 0 1 0 0 nan\n", "p.txt:1: the number \"nan\" is not a finite decimal number; "},
      {"1 0 0 0 1 0 0 0 1 0 0 inf\n", "p.txt:1: the number \"inf\" is not a finite decimal number; "},
      {"1 0 0 0 1 0 0 0 1 0 0 0x1\n", "p.txt:1: the number \"0x1\" is not a finite decimal number; "},
      {"1 0 0 0 1 0 0 0 1 0 0 1e999\n", "p.txt:1: the number \"1e999\" is larger than any double; "},
      {"1 0 0 0 1 0 0 0 1 0 0 0;\n", "p.txt:1: the number \"0;\" is not a finite decimal number; "},
      {std::string("1 0\0 0", 6), "p.txt: this is binary data where text was expected; "},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(error_of_poses(text).substr(0, message.size()), message) << text;
}

TEST(PosesFile, IsReadFromAFile) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("poses.txt", identity + "\n" + identity + "\n");
  EXPECT_EQ(read_poses(path).size(), 2U);
  const std::string missing = message_of([&] { (void)read_poses(folder / "none.txt"); });
  EXPECT_NE(missing.find("none.txt: there is no such file"), std::string::npos) << missing;
}

}  // namespace
}  // namespace toccata
