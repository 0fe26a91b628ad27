// A report that was kept is drawn: its question is asked again about the same files, or it is said why not.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/command.hpp"
#include "support/page.hpp"

namespace toccata {
namespace {

namespace fs = std::filesystem;
using test::run_command;
using test::TemporaryFolder;
using test::text_of;
using Asking = std::vector<std::string>;

constexpr const char* bow = "OFF\n5 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 1\n1 1 -1\n3 0 1 2\n3 0 3 4\n";

/// Asks in `folder`, and keeps the report in another.
fs::path report_of(const TemporaryFolder& folder, const TemporaryFolder& elsewhere, Asking words) {
  folder.write("bow.off", bow);
  words.emplace_back("--json");
  const auto asked = run_command(words, folder.path());
  EXPECT_NE(asked.exit_code, 2) << asked.err;
  return elsewhere.write("report.json", asked.out);
}

test::CommandResult drawn(const fs::path& report, Asking more = {}) {
  Asking words = {"view", report.string(), "-o", "page.html"};
  words.insert(words.end(), more.begin(), more.end());
  return run_command(words, report.parent_path());
}

TEST(SavedReportCommand, EveryReportIsDrawnFromAnotherFolder) {
  const TemporaryFolder folder;
  folder.write("poses.txt", "1 0 0 0 1 0 0 0 1 0.1 0 0\n1 0 0 0 1 0 0 0 1 9 0 0\n");
  const std::vector<std::pair<Asking, std::string>> questions = {
      {{"check", "gen:box", "bow.off", "--solid", "none"}, "2 objects and 1 pair"},
      {{"check", "gen:box", "bow.off", "--poses", "poses.txt"}, "2 objects and 2 poses"},
      {{"check", "bow.off", "--self"}, "1 object and 1 object self-intersecting"},
      {{"distance", "gen:box", "bow.off", "--scale", "3", "--unit", "mm"}, "2 objects and 1 pair"},
      {{"distance", "gen:box", "bow.off", "--poses", "poses.txt"}, "2 objects and 2 poses"},
      {{"ray", "bow.off", "--from", "1", "1", "9", "--to", "1", "1", "-9"}, "1 object and 1 ray"},
      {{"faces", "bow.off", "--ball", "0", "0", "0", "1"}, "1 object and 1 object in the region"},
      {{"nearest", "gen:box", "bow.off", "--point", "0", "0", "9"}, "2 objects and 1 point"},
      {{"inspect", "bow.off", "gen:box", "--partitions"}, "2 objects and 1 fault"},
      {{"inspect", "bow.off", "gen:box", "--hierarchy"}, "2 objects and 2 levels of nodes"},
      {{"cost", "bow.off", "gen:box", "--quick"}, "2 objects and "},
      {{"crowd", "--count", "30", "--frames", "4"}, "30 boxes in 4 frames"},
      {{"crowd", "--count", "30", "--frames", "4", "--bounds", "balls"}, "30 balls in 4 frames"},
      {{"crowd", "--world", "--count", "30", "--frames", "4"}, "30 bodies that fly in 4 steps"},
      {{"decompose", "gen:gear", "--parts", "3"}, "1 object and 3 convex parts"},
      {{"minkowski", "gen:box", "bow.off", "--hull", "--difference"}, "2 objects and their A − B"}};
  for (const auto& [words, told] : questions) {
    SCOPED_TRACE(words[0] + " " + words.back());
    const TemporaryFolder elsewhere;
    const auto result = drawn(report_of(folder, elsewhere, words));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find(told), std::string::npos) << result.out;
    EXPECT_NE(test::page_text(elsewhere.path() / "page.html").find("toccata/view/4"), std::string::npos);
  }
}

TEST(SavedReportCommand, AFileThatIsGoneOrChangedIsNamed) {
  const TemporaryFolder folder, elsewhere;
  const fs::path report = report_of(folder, elsewhere, {"check", "gen:box", "bow.off", "--faces"});
  const std::string file = (folder.path() / "bow.off").string();
  folder.write("bow.off", "OFF\n3 1 0\n0 0 0\n4 0 0\n0 4 0\n3 0 1 2\n");
  const auto changed = drawn(report);
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_NE(changed.err.find(file + " holds something else"), std::string::npos) << changed.err;
  fs::remove(file);
  const auto gone = drawn(report);
  EXPECT_EQ(gone.exit_code, 2);
  EXPECT_NE(gone.err.find(file + " is gone"), std::string::npos) << gone.err;
  EXPECT_FALSE(fs::exists(elsewhere.path() / "page.html"));
  elsewhere.write("bow.off", "OFF\n3 1 0\n0 0 0\n4 0 0\n0 4 0\n3 0 1 2\n");
  const auto another = drawn(report);
  EXPECT_NE(another.err.find((elsewhere.path() / "bow.off").string() + " holds something else"), std::string::npos)
      << another.err;
  elsewhere.write("bow.off", bow);  // beside the report it is looked for, too
  EXPECT_EQ(drawn(report).exit_code, 0);
}

TEST(SavedReportCommand, TheUnitOfASceneMayNotChange) {
  const TemporaryFolder folder, elsewhere;
  const auto write_scene = [&](const std::string& name, const std::string& unit) {
    folder.write(name, R"({"format": "toccata-scene", "version": 1, "unit": ")" + unit + R"(", "objects": [
    {"name": ")" + name + R"(", "shape": {"type": "sphere", "radius": 1}}]})");
  };
  write_scene("a.json", "mm");
  write_scene("b.json", "mm");
  const fs::path report = report_of(folder, elsewhere, {"distance", "a.json", "b.json"});
  EXPECT_EQ(drawn(report).exit_code, 0) << drawn(report).err;
  for (const std::string name : {"a.json", "b.json"}) {
    write_scene(name, "cm");
    const auto changed = drawn(report);
    EXPECT_EQ(changed.exit_code, 2);
    // Where the units differ, the numbers of both become metres: the first is named.
    EXPECT_NE(changed.err.find("a.json holds something else"), std::string::npos) << changed.err;
    write_scene(name, "mm");
  }
}

/// What a scene names counts as what it holds.
TEST(SavedReportCommand, AMeshThatASceneNamesMayNotChange) {
  const TemporaryFolder folder, elsewhere;
  folder.write("scene.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "bow", "file": "bow.off"}, {"name": "ball", "shape": {"type": "sphere", "radius": 1}}]})");
  const fs::path report = report_of(folder, elsewhere, {"distance", "scene.json"});
  EXPECT_EQ(drawn(report).exit_code, 0);
  folder.write("bow.off", "OFF\n3 1 0\n0 0 0\n4 0 0\n0 4 0\n3 0 1 2\n");
  const auto changed = drawn(report);
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_NE(changed.err.find("scene.json holds something else"), std::string::npos) << changed.err;
}

TEST(SavedReportCommand, ANameInCapitalsIsAReportOrACaseToo) {
  const TemporaryFolder folder, elsewhere;
  const fs::path report = report_of(folder, elsewhere, {"distance", "gen:box", "bow.off"});
  fs::rename(report, elsewhere.path() / "REPORT.JSON");
  const auto result = drawn(elsewhere.path() / "REPORT.JSON");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("2 objects and 1 pair"), std::string::npos) << result.out;
  const Asking ray = {"ray", "bow.off", "--from", "1", "1", "9", "--to", "1", "1", "-9", "--save-case", "CASE.JSON"};
  EXPECT_EQ(run_command(ray, folder.path()).exit_code, 1);
  const auto viewed = drawn(folder.path() / "CASE.JSON");
  EXPECT_NE(viewed.out.find("1 object and 1 ray"), std::string::npos) << viewed.out << viewed.err;
}

/// What lies beside the report and is no mesh does not end the search.
TEST(SavedReportCommand, JunkBesideTheReportIsPassedOver) {
  const TemporaryFolder folder, elsewhere;
  const fs::path report = report_of(folder, elsewhere, {"distance", "gen:box", "bow.off"});
  elsewhere.write("bow.off", "junk");
  const auto result = drawn(report);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  fs::remove(folder.path() / "bow.off");
  const auto gone = drawn(report);
  EXPECT_EQ(gone.exit_code, 2);
  EXPECT_NE(gone.err.find(report.string() + ": " + (elsewhere.path() / "bow.off").string()), std::string::npos)
      << gone.err;
}

TEST(SavedReportCommand, AFileOfTooLongANameIsGone) {
  const TemporaryFolder folder, elsewhere;
  const fs::path report = report_of(folder, elsewhere, {"distance", "gen:box", "bow.off"});
  std::string text = text_of(report);
  const std::string was = "{\"name\":\"bow.off\"";
  ASSERT_NE(text.find(was), std::string::npos) << text;
  elsewhere.write("report.json",
                  text.replace(text.find(was), was.size(), R"({"name":")" + std::string(5000, 'a') + '"'));
  const auto result = drawn(report);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find(report.string()), std::string::npos) << result.err;
  EXPECT_NE(result.err.find(" is gone; put it back"), std::string::npos) << result.err;
}

TEST(SavedReportCommand, AnotherAnswerIsDrawnAndSaid) {
  const TemporaryFolder folder, elsewhere;
  const fs::path report =
      report_of(folder, elsewhere, {"ray", "bow.off", "--from", "1", "1", "9", "--to", "1", "1", "-9"});
  std::string text = text_of(report);
  const std::string was = "\"hit\":true";
  ASSERT_NE(text.find(was), std::string::npos) << text;
  elsewhere.write("report.json", text.replace(text.find(was), was.size(), "\"hit\":false"));
  const auto result = drawn(report);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("/rays/0/hit: recorded false, now true"), std::string::npos) << result.err;
  EXPECT_TRUE(fs::exists(elsewhere.path() / "page.html"));
}

TEST(SavedReportCommand, WhatCannotBeAskedAgainIsRefused) {
  const TemporaryFolder folder, elsewhere;
  const fs::path report = report_of(folder, elsewhere, {"distance", "gen:box", "bow.off"});
  const auto refused = [&](const test::CommandResult& result, const std::string& words) {
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
  };
  refused(drawn(report, {"--penetration"}), "a report is drawn as it was asked");
  std::string text = text_of(report);
  text.erase(text.find(",\n  \"asked\""));
  refused(drawn(elsewhere.write("old.json", text + "\n}\n")), "does not say what was asked");
  const fs::path crowd = report_of(folder, elsewhere, {"crowd", "--count", "30", "--frames", "4"});
  for (const std::string option : {"--hierarchy=obb", "--partition=octree", "--voronoi"})
    refused(drawn(crowd, {option}), "a crowd has none: leave it out");
  folder.write("poses.txt", "1 0 0 0 1 0 0 0 1 0.1 0 0\n");
  const fs::path poses = report_of(folder, elsewhere, {"distance", "gen:box", "bow.off", "--poses", "poses.txt"});
  refused(drawn(poses, {"--glb", "a.glb", "--hierarchy", "obb"}), "a page shows them: view_page, or -o FILE.html");
}

TEST(SavedReportCommand, AReportIsNoScene) {
  const TemporaryFolder folder;
  const fs::path report = report_of(folder, folder, {"distance", "gen:box", "bow.off"});
  const auto result = run_command({"check", report.string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("this is a report of Toccata, not a scene; name it alone to view"), std::string::npos)
      << result.err;
}

TEST(SavedReportCommand, EverySubcommandWritesItsPageBesideItsAnswer) {
  const TemporaryFolder folder;
  folder.write("poses.txt", "1 0 0 0 1 0 0 0 1 0.1 0 0\n");
  folder.write("bow.off", bow);
  for (const Asking& question : {Asking{"check", "bow.off", "--self"},
                                 {"check", "gen:box", "bow.off", "--poses", "poses.txt"},
                                 {"distance", "gen:box", "bow.off"},
                                 {"distance", "gen:box", "bow.off", "--poses", "poses.txt"},
                                 {"ray", "bow.off", "--from", "0", "0", "9", "--to", "0", "0", "-9"},
                                 {"faces", "bow.off", "--box", "0", "0", "0", "1", "1", "1"},
                                 {"nearest", "bow.off", "--point", "0", "0", "9"},
                                 {"inspect", "bow.off"},
                                 {"inspect", "bow.off", "--hierarchy"},
                                 {"minkowski", "bow.off", "gen:box", "--hull"}}) {
    SCOPED_TRACE(question[0] + " " + question.back());
    Asking words = question;
    words.insert(words.end(), {"--html", "page.html"});
    const auto plain = run_command(question, folder.path()), both = run_command(words, folder.path());
    EXPECT_EQ(both.exit_code, plain.exit_code) << both.err;
    EXPECT_EQ(both.out, plain.out);
    EXPECT_TRUE(fs::remove(folder.path() / "page.html"));
    words.back() = "bow.off";  // it is read
    EXPECT_EQ(run_command(words, folder.path()).exit_code, 2);
    EXPECT_EQ(text_of(folder.path() / "bow.off"), bow);
  }
}

}  // namespace
}  // namespace toccata
