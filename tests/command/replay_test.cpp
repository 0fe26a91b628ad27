// `--save-case` keeps what is asked and the answer in one file, and `replay` asks it again.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/command.hpp"
#include "support/page.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using test::text_of;
using Words = std::vector<std::string>;

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

void write_inputs(const TemporaryFolder& folder) {
  folder.write("poses.txt", "1 0 0 0 1 0 0 0 1 0.1 0 0\n1 0 0 0 1 0 0 0 1 9 0 0\n");
  folder.write("bow.off", "OFF\n5 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 1\n1 1 -1\n3 0 1 2\n3 0 3 4\n");
}

const std::vector<Words> questions = {
    {"check", "gen:box", "bow.off", "--faces"},
    {"check", "gen:box", "gen:icosphere", "--penetration", "--clearance", "all"},
    {"check", "gen:box", "gen:icosphere", "--pose-b", "1", "0",      "0",  "0",       "1", "0", "0",
     "0",     "1",       "0.5",           "-0.0",     "0", "--unit", "mm", "--scale", "3"},
    {"check", "gen:box", "bow.off", "--poses", "poses.txt", "--solid", "none"},
    {"check", "bow.off", "--self", "--faces"},
    {"distance", "gen:box", "bow.off"},
    {"distance", "gen:box", "gen:icosphere", "--poses", "poses.txt"},
    {"ray", "gen:box", "bow.off", "--from", "0", "0", "9", "--to", "0", "0", "-9"},
    {"faces", "gen:box", "--box", "0", "0", "0", "1", "1", "1"},
    {"nearest", "gen:box", "bow.off", "--point", "0", "0", "9", "--k", "3", "--signed"},
    {"inspect", "gen:box", "bow.off", "--faults"},
    {"inspect", "gen:box", "bow.off", "--hierarchy"},
    {"decompose", "gen:gear", "--parts", "3", "--concavity", "0.25"},
    {"minkowski", "gen:box", "bow.off", "--hull", "--difference", "--point", "0.5", "-0.0", "9"}};

/// Whether lines of values are a form of the answer, as for all questions but these three.
bool has_lines(const Words& question) {
  return question[0] != "inspect" && question[0] != "decompose" && question[0] != "minkowski";
}

/// What was told without the last line where that says that coordinates were rounded: those of a case are.
std::string without_note_of_rounding(const std::string& told) {
  return told.substr(0, told.find("Coordinates were multiplied by "));
}

TEST(ReplayCommand, EveryQuestionIsAnsweredAgainFromTheFileAlone) {
  for (const Words& question : questions) {
    SCOPED_TRACE(question[0] + " " + question[1] + " " + question[2]);
    const TemporaryFolder folder, elsewhere;
    write_inputs(folder);
    for (const std::string format : {"", "--csv"}) {
      if (!has_lines(question) && !format.empty()) continue;
      const Words told = format.empty() ? Words{} : Words{format};
      const auto asked = run_command(with(with(question, {"--save-case", "case.json"}), told), folder.path());
      ASSERT_NE(asked.exit_code, 2) << asked.err;
      std::filesystem::copy_file(folder.path() / "case.json", elsewhere.path() / "case.json",
                                 std::filesystem::copy_options::overwrite_existing);
      const auto again = run_command(with({"replay", "case.json"}, told), elsewhere.path());
      EXPECT_EQ(again.exit_code, 0) << again.err;
      EXPECT_TRUE(again.out.starts_with(without_note_of_rounding(asked.out))) << asked.out << "\n" << again.out;
      EXPECT_NE((again.out + again.err).find("The same answer as recorded, bit for bit"), std::string::npos);
      EXPECT_EQ(again.out == asked.out, !format.empty());
    }
  }
}

TEST(ReplayCommand, TellsAnotherAnswerAndKeepsIt) {
  const TemporaryFolder folder;
  const auto asked = run_command(
      {"faces", "gen:box", "--box", "0", "0", "0", "1", "1", "1", "--save-case", "case.json"}, folder.path());
  ASSERT_EQ(asked.exit_code, 1) << asked.err;
  std::string text = text_of(folder.path() / "case.json");
  const std::string was = "\"face\":5";
  ASSERT_NE(text.find(was), std::string::npos) << text;
  folder.write("case.json", text.replace(text.find(was), was.size(), "\"face\":4"));
  const auto other = run_command({"replay", "case.json", "--save-case", "new.json"}, folder.path());
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.out.find("recorded 4, now 5"), std::string::npos) << other.out;
  EXPECT_EQ(run_command({"replay", "new.json"}, folder.path()).exit_code, 0);
}

TEST(ReplayCommand, AnErrorIsKeptAsTheAnswer) {
  const TemporaryFolder folder;
  folder.write("ball.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "a", "shape": {"type": "sphere", "radius": 1}, "pose": {"scale": [1, 1, 2]}},
    {"name": "b", "shape": {"type": "sphere", "radius": 1}}]})");
  EXPECT_EQ(run_command({"distance", "ball.json", "--save-case", "case.json"}, folder.path()).exit_code, 2);
  const auto again = run_command({"replay", "case.json"}, folder.path());
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_NE(again.out.find("deforms it"), std::string::npos) << again.out;
}

/// `check` answers what any case asks, and so does the subcommand of its question.
TEST(ReplayCommand, CheckAnswersEveryCase) {
  for (const Words& question : questions) {
    SCOPED_TRACE(question[0] + " " + question[1] + " " + question[2]);
    const TemporaryFolder folder;
    write_inputs(folder);
    const auto asked = run_command(with(question, {"--save-case", "case.json"}), folder.path());
    for (const std::string& subcommand : {std::string("check"), question[0]}) {
      if (question.back() == "--hierarchy" && subcommand == "inspect") continue;  // it asks for the objects
      const auto again = run_command({subcommand, "case.json"}, folder.path());
      EXPECT_EQ(again.out, without_note_of_rounding(asked.out)) << again.err;
      EXPECT_EQ(again.exit_code, asked.exit_code);
    }
  }
}

TEST(ReplayCommand, CheckSaysWhereACaseHasAnotherAnswer) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_command({"nearest", "gen:box", "--point", "0", "0", "9", "--save-case", "case.json"}, folder.path())
                .exit_code,
            0);
  std::string text = text_of(folder.path() / "case.json");
  const std::string was = "\"upper\":8.5";
  ASSERT_NE(text.find(was), std::string::npos) << text;
  folder.write("case.json", text.replace(text.find(was), was.size(), "\"upper\":8.0"));
  const auto other = run_command({"check", "case.json"}, folder.path());
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.err.find("/points/0/nearest/0/upper: recorded 8.0"), std::string::npos) << other.err;
}

TEST(ReplayCommand, ACaseIsASceneToTheOtherSubcommands) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_command({"distance", "gen:box", "gen:icosphere", "--save-case", "case.json"}, folder.path()).exit_code,
            1);
  const auto checked = run_command({"check", "case.json", "--faces"}, folder.path());
  EXPECT_NE(checked.out.find("1 pair in contact"), std::string::npos) << checked.err;
  EXPECT_NE(checked.err.find("case.json holds a question, distance, which is not asked here"), std::string::npos);
  const auto inspected = run_command({"inspect", "case.json"}, folder.path());
  EXPECT_NE(inspected.out.find("icosphere"), std::string::npos);
  EXPECT_NE(inspected.err.find("check case.json` answers it"), std::string::npos) << inspected.err;
  const auto own = run_command({"distance", "case.json", "--scale", "2"}, folder.path());
  EXPECT_NE(own.err.find("distance case.json` answers it"), std::string::npos) << own.err;
  const auto ray = run_command({"ray", "case.json"}, folder.path());
  EXPECT_EQ(ray.exit_code, 2);
  EXPECT_NE(ray.err.find("check case.json` answers it; to ask another"), std::string::npos) << ray.err;
  EXPECT_EQ(run_command({"ray", "case.json", "--from", "0", "0", "9", "--to", "0", "0", "-9"}, folder.path()).exit_code,
            1);
}

TEST(ReplayCommand, ViewShowsDistancesAndDepthsThatACaseAsksFor) {
  const TemporaryFolder folder;
  const Words far = {"distance", "gen:box", "gen:box", "--pose-b", "1", "0", "0", "0",
                     "1",        "0",       "0",       "0",        "1", "9", "0", "0"};
  ASSERT_EQ(run_command(with(far, {"--save-case", "far.json"}), folder.path()).exit_code, 0);
  const auto apart = run_command({"view", "far.json", "-o", "far.html"}, folder.path());
  EXPECT_NE(apart.out.find("2 objects and 1 pair"), std::string::npos) << apart.out << apart.err;
  EXPECT_NE(test::page_text(folder.path() / "far.html").find("\"role\":\"distance\""), std::string::npos);
  ASSERT_EQ(
      run_command({"check", "gen:box", "gen:icosphere", "--penetration", "--save-case", "deep.json"}, folder.path())
          .exit_code,
      1);
  ASSERT_EQ(run_command({"view", "deep.json", "-o", "deep.html"}, folder.path()).exit_code, 0);
  EXPECT_NE(test::page_text(folder.path() / "deep.html").find("\"role\":\"depth\""), std::string::npos);
}

/// Whether it is drawn or not, a case is what was asked.
TEST(ReplayCommand, ACaseIsTheSameBesideAPage) {
  const TemporaryFolder folder;
  write_inputs(folder);
  for (const Words& question : {Words{"check", "gen:box", "bow.off"},
                                {"check", "gen:box", "bow.off", "--faces"},
                                {"check", "bow.off", "--self"},
                                {"check", "bow.off", "--self", "--faces"}}) {
    SCOPED_TRACE(question.back());
    EXPECT_EQ(run_command(with(question, {"--save-case", "c1.json"}), folder.path()).exit_code, 1);
    EXPECT_EQ(run_command(with(question, {"--save-case", "c2.json", "--html", "x.html"}), folder.path()).exit_code, 1);
    EXPECT_EQ(text_of(folder.path() / "c1.json"), text_of(folder.path() / "c2.json"));
    EXPECT_NE(test::page_text(folder.path() / "x.html").find("\"face_pairs\":"), std::string::npos);
    EXPECT_EQ(run_command({"view", "c1.json", "-o", "x.html", "--save-case", "c2.json"}, folder.path()).exit_code, 0);
    EXPECT_EQ(text_of(folder.path() / "c1.json"), text_of(folder.path() / "c2.json"));
  }
}

TEST(ReplayCommand, ViewSaysWhenOptionsAskAnotherQuestion) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_command({"distance", "gen:box", "gen:box", "--save-case", "case.json"}, folder.path()).exit_code, 1);
  EXPECT_EQ(run_command({"view", "case.json", "-o", "x.html"}, folder.path()).err, "");
  const auto run = run_command({"view", "case.json", "--penetration", "-o", "x.html"}, folder.path());
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("case.json holds a question, distance, which is not asked"), std::string::npos) << run.err;
}

/// That meshes are open matters for `check`; for how far apart they are it tells nothing.
TEST(ReplayCommand, ViewWarnsOfOpenMeshesWhereTheyMatter) {
  const TemporaryFolder folder;
  write_inputs(folder);
  const auto told = [&](const std::string& question) {
    EXPECT_EQ(run_command({question, "gen:box", "bow.off", "--save-case", "case.json"}, folder.path()).exit_code, 1);
    return run_command({"view", "case.json", "-o", "x.html"}, folder.path()).err;
  };
  EXPECT_NE(told("check").find("open and taken as surface"), std::string::npos);
  std::filesystem::remove(folder.path() / "case.json");
  EXPECT_EQ(told("distance"), "");
}

TEST(ReplayCommand, NestedTooDeepItIsRefused) {
  const TemporaryFolder folder;
  folder.write("deep.json", std::string(100'000, '[') + std::string(100'000, ']'));
  for (const Words& words : {Words{"replay", "deep.json"}, {"view", "deep.json", "-o", "x.html"}}) {
    const auto run = run_command(words, folder.path());
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("deep.json:1: arrays and objects are nested"), std::string::npos) << run.err;
  }
}

TEST(ReplayCommand, NothingThatIsReadOrWrittenIsReplacedByACase) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_command({"distance", "gen:box", "gen:box", "--save-case", "case.json"}, folder.path()).exit_code, 1);
  const std::string before = text_of(folder.path() / "case.json");
  for (const Words& words : {Words{"check", "case.json", "--save-case", "case.json"},
                             {"view", "case.json", "-o", "a.html", "--save-case", "./case.json"},
                             {"view", "case.json", "-o", "same", "--save-case", "same"},
                             {"check", "case.json", "--html", "same", "--save-case", "same"}}) {
    const auto run = run_command(words, folder.path());
    EXPECT_EQ(run.exit_code, 2) << words[0] << run.out;
    EXPECT_NE(run.err.find("give them different names"), std::string::npos) << run.err;
  }
  EXPECT_EQ(text_of(folder.path() / "case.json"), before);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "same"));
  folder.write("theirs.json", "{}");
  const auto run = run_command({"replay", "case.json", "--save-case", "theirs.json"}, folder.path());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(text_of(folder.path() / "theirs.json"), "{}");
}

TEST(ReplayCommand, NamesThatTurnTheLineAreSpelledOut) {
  const TemporaryFolder folder;
  folder.write("scene.json",
               R"({"format": "toccata-scene", "version": 1, "objects": [)"
               R"({"generate": "box", "name": "a\u202Eb"}, {"generate": "box", "name": "\u0085\u2066c"}]})");
  const auto run = run_command({"check", "scene.json"}, folder.path());
  EXPECT_NE(run.out.find("a\\u202eb"), std::string::npos) << run.out << run.err;
  EXPECT_NE(run.out.find("\\u0085\\u2066c"), std::string::npos) << run.out;
}

TEST(ReplayCommand, WhatIsNoCaseIsToldSo) {
  const TemporaryFolder folder;
  folder.write("scene.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "a", "shape": {"type": "sphere", "radius": 1}}]})");
  const auto plain = run_command({"replay", "scene.json"}, folder.path());
  EXPECT_EQ(plain.exit_code, 2);
  EXPECT_NE(plain.err.find("holds no question"), std::string::npos) << plain.err;
  EXPECT_EQ(run_command({"replay", "none.json"}, folder.path()).exit_code, 2);
  folder.write("mesh.obj", "v 0 0 0\n");
  const auto refused = run_command({"check", "gen:box", "gen:box", "--save-case", "mesh.obj"}, folder.path());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("is not a case of Toccata"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace toccata
