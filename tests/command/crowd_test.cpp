#include <gtest/gtest.h>

#include <filesystem>
#include <map>
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

TEST(CrowdCommand, TellsOfBodiesInAWorld) {
  const auto run = run_command({"crowd", "--world", "--count", "1", "--frames", "1"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with("1 body that flies, 1 frame\n")) << run.out;
  EXPECT_NE(run.out.find("\nbroad phase          ms per step      worst in contact     begun    ended\nbrute-force  "),
            std::string::npos)
      << run.out;
  EXPECT_TRUE(run.out.ends_with("          0         0        0\n")) << run.out;
}

TEST(CrowdCommand, FindsTheSamePairsInAWorldByEveryMethod) {
  std::set<std::string> answers;
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--method", "brute-force"}, {"--method", "grid"}, {"--threads", "2"}}) {
    std::vector<std::string> all = {"crowd", "--world", "--count", "400", "--frames", "30", "--json"};
    all.insert(all.end(), words.begin(), words.end());
    const auto run = run_command(all);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["schema"], "toccata/crowd-world/1");
    EXPECT_EQ(json["count"], 400);
    EXPECT_EQ(json["frames"], 30);
    EXPECT_GT(json["pairs"], 0);
    EXPECT_GT(json["begun"], 0);
    EXPECT_GT(json["ended"], 0);
    EXPECT_LE(json["median_ms"], json["worst_ms"]);
    answers.insert(Json({json["pairs"], json["begun"], json["ended"]}).dump());
  }
  EXPECT_EQ(answers.size(), 1U);
}

/// Some where options are read, some before a World is made.
TEST(CrowdCommand, RefusesWhatMakesNoWorld) {
  const std::map<std::vector<std::string>, std::string> refused{
      {{"--count", "0"}, "--count"},
      {{"--count", "100000001"}, "--count"},
      {{"--frames", "0"}, "--frames"},
      {{"--threads", "-1"}, "--threads"},
      {{"--method", "gird"}, "--method: gird"},
      {{"--scene", "uniform"}, "--scene excludes --world"},
      {{"--cells", "tracked"}, "--cells excludes --world"},
      {{"--compare"}, "--compare excludes --world"},
      {{"--save-case", "case.json"}, "--save-case is about boxes"},
      {{"--size", "90x90"}, "--png FILE.png"}};
  const test::TemporaryFolder folder;
  for (const auto& [words, complaint] : refused) {
    std::vector<std::string> all = {"crowd", "--world"};
    all.insert(all.end(), words.begin(), words.end());
    const auto run = run_command(all, folder.path());
    EXPECT_EQ(run.exit_code, 2) << words[0];
    EXPECT_NE(run.err.find(complaint), std::string::npos) << run.err;
    EXPECT_EQ(run.out, "");
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
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
