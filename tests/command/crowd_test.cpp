#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "support/command.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata {
namespace {

using test::run_command;
using Json = nlohmann::json;

TEST(CrowdCommand, ComparesAllMethodsOnEveryScene) {
  for (const std::string scene : {"uniform", "clustered", "sizes", "static", "terrain", "fast"}) {
    const auto run = run_command({"crowd", "--count", "300", "--frames", "4", "--scene", scene, "--compare", "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["scene"], scene);
    std::set<std::string> methods;
    for (const Json& one : json["methods"]) {
      methods.insert(one["method"]);
      EXPECT_EQ(one["pairs"], json["methods"][0]["pairs"]) << one["method"];
      EXPECT_GT(one["pairs"], 0) << scene;
    }
    EXPECT_EQ(methods.size(), broad_phase_methods().size());
  }
}

TEST(CrowdCommand, TellsWhatWasChosenAndWhy) {
  const auto run = run_command({"crowd", "--count", "1", "--frames", "1"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("1 box, uniform, 1 frame\n")) << run.out;
  EXPECT_NE(run.out.find("\nauto: "), std::string::npos) << run.out;
}

/// Before a frame is timed.
TEST(CrowdCommand, RefusesMoreThanAPageHolds) {
  const test::TemporaryFolder folder;
  const auto run = run_command({"crowd", "--count", "100000000", "--html", "x.html"}, folder.path());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("a page holds at most 1,142,857 boxes, not 100,000,000"), std::string::npos) << run.err;
}

TEST(CrowdCommand, HelpTellsExitCodesAndThreads) {
  const auto run = run_command({"crowd", "--help"});
  EXPECT_NE(run.out.find("Exit code: 0"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("[0 - 1024]=1"), std::string::npos) << run.out;
}

TEST(CrowdCommand, RefusesWhatMakesNoCrowd) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--count", "0"},
                                                {"--count", "-1"},
                                                {"--frames", "0"},
                                                {"--scene", "unifrom"},
                                                {"--method", "gird"},
                                                {"--seed", "-1"},
                                                {"--seed", "18446744073709551616"},
                                                {"--threads", "-1"}}) {
    std::vector<std::string> all = {"crowd"};
    all.insert(all.end(), words.begin(), words.end());
    const auto run = run_command(all);
    EXPECT_EQ(run.exit_code, 2) << words[0] << ' ' << words[1];
    EXPECT_NE(run.err.find("error"), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

}  // namespace
}  // namespace toccata
