#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/command.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

using DepthJson = nlohmann::json;

/// Two knots that hold each other in several places.
std::vector<std::string> depth_of_knots(std::vector<std::string> more) {
  std::vector<std::string> words{"check", "gen:torus-knot?around=40&sides=6", "gen:torus-knot?around=40&sides=6",
                                 "--penetration", "--pose-b"};
  for (const char* number : {"1", "0", "0", "0", "1", "0", "0", "0", "1", "0.7", "0.1", "0"})
    words.emplace_back(number);
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

DepthJson reported_depth(std::vector<std::string> more) {
  more.emplace_back("--json");
  const auto run = test::run_command(depth_of_knots(std::move(more)));
  EXPECT_EQ(run.exit_code, 1) << run.err;
  return DepthJson::parse(run.out);
}

TEST(CheckDepth, PrecisionAndTimeLimitAreAskedAndTheEndIsTold) {
  const DepthJson wide = reported_depth({"--precision", "50"});
  EXPECT_EQ(wide["asked"]["query"]["precision"], 50);
  EXPECT_FALSE(wide["pairs"][0]["penetration"].contains("ended"));
  const DepthJson soon = reported_depth({"--time-per-depth", "1e-9"});
  EXPECT_EQ(soon["asked"]["query"]["time_per_depth"], 1e-9);
  const DepthJson depth = soon["pairs"][0]["penetration"];
  EXPECT_EQ(depth["ended"], "out of time");
  // The bracket holds all the same: that of a longer search has a depth in common with it.
  EXPECT_LE(depth["lower"], wide["pairs"][0]["penetration"]["upper"]);
  EXPECT_GE(depth["upper"], wide["pairs"][0]["penetration"]["lower"]);
}

TEST(CheckDepth, IsToldAsTheBracketItIsWhereverItIsTold) {
  const test::TemporaryFolder folder;
  const std::vector<std::string> words = depth_of_knots({"--precision", "0.5"});
  const auto asked = [&](std::vector<std::string> more) {
    more.insert(more.begin(), words.begin(), words.end());
    return test::run_command(more, folder.path());
  };
  const DepthJson pair = DepthJson::parse(asked({"--json"}).out)["pairs"][0];
  const double lower = pair["penetration"]["lower"].get<double>(), upper = pair["penetration"]["upper"].get<double>();
  ASSERT_GT(upper, 1.01 * lower);
  const std::string told = bracket_text(lower, upper) + " deep";
  ASSERT_NE(told.find(" to "), std::string::npos) << told;
  const std::string moved = "moving " + pair["b"].get<std::string>();
  const auto run = asked({"--junit", "found.xml", "--sarif", "found.sarif", "--glb", "found.glb"});
  const auto tells = [&](const std::string& text) { return text.find(told) != std::string::npos; };
  EXPECT_TRUE(tells(run.out) && run.out.find(moved) != std::string::npos) << told << "\n" << run.out;
  for (const char* file : {"found.xml", "found.sarif", "found.glb"})
    EXPECT_TRUE(tells(test::text_of(folder / file))) << file << " tells " << told;
  const DepthJson region = pair["regions"][0];
  EXPECT_NE(run.out.find(bracket_text(region["depth"].get<double>(), region["depth_upper"].get<double>()) + " deep"),
            std::string::npos)
      << run.out;
}

TEST(CheckDepth, WhatIsNoNumberAboveZeroIsToldAndLeftOut) {
  for (const char* word : {"0", "-1", "nan", "inf", "10%", "much"}) {
    SCOPED_TRACE(word);
    const auto precise = test::run_command(depth_of_knots({"--precision", word}));
    EXPECT_EQ(precise.exit_code, 1);
    EXPECT_NE(
        precise.err.find(std::string("--precision ") + word + " is not a finite number above 0: answered with 0.1"),
        std::string::npos)
        << precise.err;
    const auto timed = test::run_command(depth_of_knots({"--time-per-depth", word}));
    EXPECT_EQ(timed.exit_code, 1);
    EXPECT_NE(timed.err.find(std::string("--time-per-depth ") + word + " is not a finite number above 0"),
              std::string::npos)
        << timed.err;
  }
}

TEST(CheckDepth, AtManyPosesTheEndIsToldToo) {
  const test::TemporaryFolder folder;
  folder.write("poses.txt", "1 0 0 0 1 0 0 0 1 0.7 0.1 0\n1 0 0 0 1 0 0 0 1 9 0 0\n");
  const auto asked = [&](std::vector<std::string> more) {
    std::vector<std::string> words{"check",
                                   "gen:torus-knot?around=40&sides=6",
                                   "gen:torus-knot?around=40&sides=6",
                                   "--penetration",
                                   "--poses",
                                   "poses.txt",
                                   "--time-per-depth",
                                   "1e-9"};
    words.insert(words.end(), more.begin(), more.end());
    return test::run_command(words, folder.path()).out;
  };
  const std::string table = asked({}), csv = asked({"--csv"});
  EXPECT_NE(table.find(", when the time was over"), std::string::npos) << table;
  EXPECT_NE(csv.find(",direction_z,depth_ended\n0,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",out of time\n1,apart,"), std::string::npos) << csv;
  EXPECT_EQ(csv.substr(csv.size() - 2), ",\n") << csv;
}

// The answer, which here cannot be written, comes after.
TEST(CheckDepth, AWrongPrecisionIsToldBeforeTheWork) {
  const auto run = test::run_command(depth_of_knots({"--precision", "much", "--save-case", "no-folder/case.json"}));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("--precision much is not a finite number above 0"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("no-folder"), std::string::npos) << run.err;
  const auto whole = test::run_command(depth_of_knots({"--precision", "much"}));
  EXPECT_EQ(whole.err.find("--precision much"), whole.err.rfind("--precision much")) << whole.err;
}

TEST(CheckDepth, AnotherPrecisionThanThatOfACaseAsksAnotherQuestion) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(test::run_command(depth_of_knots({"--save-case", "case.json"}), folder.path()).exit_code, 1);
  const auto run = test::run_command({"check", "case.json", "--penetration", "--precision", "2"}, folder.path());
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_NE(run.err.find("as --penetration --precision asks another"), std::string::npos) << run.err;
}

TEST(CheckDepth, ACaseWithAPrecisionOfNoDepthIsRefused) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(test::run_command(depth_of_knots({"--save-case", "case.json"}), folder.path()).exit_code, 1);
  DepthJson kept = DepthJson::parse(test::text_of(folder / "case.json"));
  kept["query"]["penetration"] = false;
  folder.write("case.json", kept.dump());
  const auto run = test::run_command({"replay", "case.json"}, folder.path());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("/query/precision: this is about depths, which are not asked for"), std::string::npos)
      << run.err;
}

TEST(CheckDepth, ACaseWithAPrecisionThatIsNoneIsRefused) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(test::run_command(depth_of_knots({"--save-case", "case.json"}), folder.path()).exit_code, 1);
  EXPECT_EQ(test::run_command({"replay", "case.json"}, folder.path()).exit_code, 0);
  DepthJson kept = DepthJson::parse(test::text_of(folder / "case.json"));
  kept["query"]["precision"] = -3;
  folder.write("case.json", kept.dump());
  const auto run = test::run_command({"replay", "case.json"}, folder.path());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("/query/precision: this is not above 0"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace toccata
