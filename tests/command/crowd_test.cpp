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
  for (const std::string scene : {"uniform", "clustered", "sizes", "static", "terrain", "fast", "bounce", "pile"}) {
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
  EXPECT_NE(run.out.find("\nbroad phase          ms per step      worst in contact     begin      end\nbrute-force  "),
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
    EXPECT_EQ(json["schema"], "toccata/crowd-world/3");
    EXPECT_EQ(json["count"], 400);
    EXPECT_EQ(json["frames"], 30);
    EXPECT_GT(json["pairs"], 0);
    EXPECT_GT(json["begin"], 0);
    EXPECT_GT(json["end"], 0);
    EXPECT_LE(json["median_ms"], json["worst_ms"]);
    answers.insert(Json({json["pairs"], json["begin"], json["end"], json["digest"]}).dump());
  }
  EXPECT_EQ(answers.size(), 1U);
}

TEST(CrowdCommand, LetsBodiesStandLieAndFallInAWorld) {
  for (const std::string scene : {"stacks", "pile", "floor", "terrain"}) {
    std::set<std::string> answers;
    for (const std::string threads : {"1", "2"}) {
      const auto run = run_command(
          {"crowd", "--world", "--bodies", scene, "--count", "150", "--frames", "20", "--threads", threads, "--json"});
      ASSERT_EQ(run.exit_code, 0) << run.err;
      const Json json = Json::parse(run.out);
      EXPECT_EQ(json["scene"], scene);
      EXPECT_GT(json["pairs"], 50) << scene;
      answers.insert(json["digest"].dump());
    }
    EXPECT_EQ(answers.size(), 1U) << scene;
  }
  const auto run = run_command({"crowd", "--world", "--bodies", "stacks", "--count", "20", "--frames", "1"});
  EXPECT_TRUE(run.out.starts_with("20 bodies (stacks), 1 frame\n")) << run.out;
  EXPECT_EQ(run_command({"crowd", "--bodies", "stacks"}).exit_code, 2);
}

/// Some where options are read, some before a World is made.
TEST(CrowdCommand, RefusesWhatMakesNoWorld) {
  const std::map<std::vector<std::string>, std::string> refused{{{"--count", "0"}, "--count"},
                                                                {{"--count", "100000001"}, "--count"},
                                                                {{"--frames", "0"}, "--frames"},
                                                                {{"--threads", "-1"}, "--threads"},
                                                                {{"--method", "gird"}, "--method: gird"},
                                                                {{"--scene", "uniform"}, "--scene"},
                                                                {{"--bounds", "balls"}, "--bounds"},
                                                                {{"--cells", "tracked"}, "--cells"},
                                                                {{"--compare"}, "--compare"},
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

/// All methods find the same pairs of them, fewer than of the boxes around them, and other ones.
TEST(CrowdCommand, BoundsMayBeBallsAndTurnedBoxes) {
  std::set<std::string> digests;
  for (const std::string bounds : {"boxes", "balls", "oriented"}) {
    const auto run = run_command(
        {"crowd", "--count", "300", "--frames", "3", "--bounds", bounds, "--compare", "--threads", "2", "--json"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json["bounds"], bounds);
    for (const Json& one : json["methods"]) EXPECT_EQ(one["digest"], json["methods"][0]["digest"]) << one["method"];
    EXPECT_GT(json["methods"][0]["pairs"], 0);
    digests.insert(json["methods"][0]["digest"]);
  }
  EXPECT_EQ(digests.size(), 3U);
  const auto told = run_command({"crowd", "--count", "50", "--frames", "1", "--bounds", "oriented"});
  EXPECT_TRUE(told.out.starts_with("50 oriented boxes, uniform, 1 frame\n")) << told.out;
}

/// For boxes and for bodies: a case answers again with the same pairs, is drawn, and tells where it has others.
TEST(CrowdCommand, CasesAreAnsweredAgainBitForBit) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--count", "60", "--bounds", "balls"}, {"--world", "--count", "60"}}) {
    const test::TemporaryFolder folder;
    std::vector<std::string> all = {"crowd", "--frames", "8", "--save-case", "case.json"};
    all.insert(all.end(), words.begin(), words.end());
    const auto asked = run_command(all, folder.path());
    ASSERT_EQ(asked.exit_code, 0) << asked.err;
    for (const std::vector<std::string>& again :
         {std::vector<std::string>{"crowd", "case.json"}, {"check", "case.json"}, {"replay", "case.json"}}) {
      const auto answered = run_command(again, folder.path());
      EXPECT_EQ(answered.exit_code, 0) << answered.err;
      EXPECT_EQ(answered.out.substr(0, answered.out.find('\n')), asked.out.substr(0, asked.out.find('\n')));
      EXPECT_EQ(answered.err, "");
    }
    const auto drawn = run_command({"crowd", "case.json", "--html", "a.html", "--glb", "a.glb"}, folder.path());
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "a.html"));
    EXPECT_TRUE(test::text_of(folder.path() / "a.glb").starts_with("glTF"));
    std::string text = test::text_of(folder.path() / "case.json");
    const std::size_t digest = text.find("\"digest\":") + 12;
    text[text[digest] == '"' ? digest + 1 : digest] ^= 1;
    folder.write("case.json", text);
    const auto other = run_command({"crowd", "case.json"}, folder.path());
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_NE(other.err.find("digest: recorded"), std::string::npos) << other.err;
  }
}

TEST(CrowdCommand, ReadsNothingButItsCases) {
  const test::TemporaryFolder folder;
  const auto refused = [&](const std::vector<std::string>& words, const std::string& complaint) {
    const auto run = run_command(words, folder.path());
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find(complaint), std::string::npos) << run.err;
  };
  refused({"crowd", "gen:box"}, "gen:box is no case of a crowd");
  ASSERT_EQ(run_command({"inspect", "gen:box", "--save-case", "box.json"}, folder.path()).exit_code, 0);
  refused({"crowd", "box.json"}, "box.json holds a question, inspect: `");
  for (const std::vector<std::string>& option : {std::vector<std::string>{"--count", "5"},
                                                 {"--method", "grid"},
                                                 {"--world"},
                                                 {"--threads", "2"},
                                                 {"--compare"}}) {
    std::vector<std::string> all = {"crowd", "box.json"};
    all.insert(all.end(), option.begin(), option.end());
    refused(all, option[0]);
  }
}

TEST(CrowdCommand, WritesAnAnimationForBlender) {
  const test::TemporaryFolder folder;
  for (const std::vector<std::string>& words : {std::vector<std::string>{"crowd", "--count", "40", "--frames", "3"},
                                                {"crowd", "--world", "--count", "40", "--frames", "3"}}) {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"--glb", "crowd.glb"});
    const auto run = run_command(all, folder.path());
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find("crowd.glb: 4 "), std::string::npos) << run.out;
    EXPECT_NE(test::text_of(folder.path() / "crowd.glb").find("\"animations\""), std::string::npos);
  }
}

/// On a terminal a bar tells how far it is; nothing of it is in what is redirected.
TEST(CrowdCommand, TheProgressBarIsForTerminalsAlone) {
  std::vector<std::string> words = {"crowd", "--count", "3000", "--frames", "1000", "--method", "brute-force"};
  const std::string seen = test::seen_on_terminal(words, "]");
  EXPECT_NE(seen.find("\rframes ["), std::string::npos) << seen;
  words[4] = "12";
  const auto redirected = run_command(words);
  EXPECT_EQ(redirected.exit_code, 0);
  EXPECT_EQ(redirected.err, "");
  EXPECT_EQ(redirected.out.find('\r'), std::string::npos);
}

TEST(CrowdCommand, HelpTellsExitCodesAndThreads) {
  const auto run = run_command({"crowd", "--help"});
  EXPECT_NE(run.out.find("Exit code: 0"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("0 to 1024=1"), std::string::npos) << run.out;
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
