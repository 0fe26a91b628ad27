// How `toccata check` comes to its files: folders, patterns, lists, standard input, and parts of files.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

/// Two boxes in one file that overlap by half.
const char* const two_boxes =
    "o left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
    "o right\nv 0.5 0 0\nv 1.5 0 0\nv 0.5 1 0\nv 1.5 1 0\nv 0.5 0 1\nv 1.5 0 1\nv 0.5 1 1\nv 1.5 1 1\n"
    "f 9 11 12 10\nf 13 14 16 15\nf 9 10 14 13\nf 11 15 16 12\nf 9 13 15 11\nf 10 12 16 14\n";

class CheckFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(folder.path() / "parts");
    for (const char* name : {"parts/b 2.obj", "parts/a.OBJ", "parts/c[1].obj"}) folder.write(name, two_boxes);
    folder.write("parts/notes.txt", "no mesh");
    folder.write("two.obj", two_boxes);
    folder.write("list.txt", "# the parts\r\nparts/a.OBJ\r\n\nparts/b 2.obj\n");
  }

  test::CommandResult run(const Words& words) { return run_command(words, folder.path()); }

  Words names_in(Words words) {
    words.insert(words.begin(), "check");
    words.emplace_back("--json");
    const auto result = run(words);
    if (result.exit_code > 1) return {result.err};
    Words names;
    const Json report = Json::parse(result.out);
    for (const Json& object : report["objects"]) names.push_back(object["name"]);
    return names;
  }

  std::string trouble(Words words) {
    words.insert(words.begin(), "check");
    const auto result = run(words);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    return result.err;
  }

  TemporaryFolder folder;
};

TEST_F(CheckFiles, AFolderStandsForTheMeshFilesInIt) {
  EXPECT_EQ(names_in({"parts"}), (Words{"a", "b 2", "c[1]"}));
  EXPECT_EQ(names_in({"two.obj", "parts/"}), (Words{"two", "a", "b 2", "c[1]"}));
  std::filesystem::create_directory(folder.path() / "empty");
  EXPECT_NE(trouble({"empty"}).find("no mesh file is in this folder"), std::string::npos);
}

TEST_F(CheckFiles, AFolderTellsWhatItLeavesOut) {
  EXPECT_EQ(run({"check", "parts"}).err.find("not read are"), std::string::npos);
  folder.write("parts/readme.txt", "no part");
  folder.write("parts/scene.json", "{}");
  folder.write("parts/pump.FBX", "");
  std::filesystem::create_directory(folder.path() / "parts/valves");
  EXPECT_NE(run({"check", "parts"}).err.find("parts: not read are pump.FBX, scene.json, valves/: "), std::string::npos);
}

TEST_F(CheckFiles, APatternStandsForWhatMatchesUnlessAFileIsCalledSo) {
  EXPECT_EQ(names_in({"parts/?*.obj"}), (Words{"b 2", "c[1]"}));
  EXPECT_EQ(names_in({"parts/c[1].obj", "two.obj"}), (Words{"c[1]", "two"}));
  EXPECT_NE(trouble({"parts/*.stl"}).find("parts/*.stl: no file has a name like this"), std::string::npos);
}

TEST_F(CheckFiles, AListNamesFilesOneOnEachLine) {
  EXPECT_EQ(names_in({"--names", "list.txt"}), (Words{"a", "b 2"}));
  EXPECT_EQ(names_in({"two.obj", "--names", "list.txt"}), (Words{"a", "b 2", "two"}));
  folder.write("none.txt", "# nothing\n");
  EXPECT_NE(trouble({"--names", "none.txt"}).find("no file is named in it"), std::string::npos);
  EXPECT_NE(trouble({"--names", "gone.txt"}).find("gone.txt: the file cannot be opened"), std::string::npos);
}

TEST_F(CheckFiles, StandardInputHasAFormat) {
  const std::string command = test::command_file();
  const auto piped = [&](const std::string& words) {
    return std::system(("cd '" + folder.path().string() + "' && " + command + " check " + words).c_str()) / 256;
  };
  EXPECT_EQ(piped("- two.obj --format obj < two.obj > out"), 1);
  EXPECT_NE(test::text_of(folder.path() / "out").find("standard input  equals  two"), std::string::npos);
  EXPECT_EQ(piped("--names - < list.txt > out"), 1);
  EXPECT_NE(test::text_of(folder.path() / "out").find("a  equals  b 2"), std::string::npos);
  EXPECT_EQ(piped("- two.obj --format obj < /dev/null 2> err"), 2);
  EXPECT_NE(test::text_of(folder.path() / "err").find("standard input: there is nothing in it"), std::string::npos);
  EXPECT_NE(trouble({"-", "two.obj"}).find("add --format"), std::string::npos);
  EXPECT_NE(trouble({"-", "-", "--format", "obj"}).find("once"), std::string::npos);
  EXPECT_NE(trouble({"two.obj", "--format", "obj"}).find("no file is -"), std::string::npos);
  const std::string unknown = trouble({"-", "two.obj", "--format", "xyz"});
  EXPECT_NE(unknown.find("--format: 'xyz' is none that is read; there are obj, stl, ply, off"), std::string::npos)
      << unknown;
}

TEST_F(CheckFiles, StandardInputThatAnotherProgramReadsIsNamedSo) {
  folder.write("bad.step", "ISO-10303-21;");
  for (const char* format : {"step", "stp", "ifc"}) {
    const std::string words = std::string(" check - two.obj --format ") + format + " < bad.step > out 2> err";
    const int code = std::system(("cd '" + folder.path().string() + "' && " + test::command_file() + words).c_str());
    EXPECT_EQ(code / 256, 2);
    const std::string said = test::text_of(folder.path() / "err");
    EXPECT_EQ(said.rfind("toccata: error: standard input: ", 0), 0U) << said;
    EXPECT_EQ(said.find("/input."), std::string::npos) << "the temporary file is told: " << said;
  }
}

TEST_F(CheckFiles, HelpAndErrorsNameEveryFormat) {
  const std::string help = run({"check", "--help"}).out, error = trouble({"-", "two.obj"});
  for (const char* format : {"OBJ", "STL", "PLY", "OFF", "glTF", "GLB", "3MF", "STEP", "IFC", "JSON"})
    EXPECT_NE(help.substr(0, help.find("--names")).find(format), std::string::npos) << format;
  for (const char* format : {"obj", "stl", "ply", "off", "gltf", "glb", "3mf", "step", "ifc", "json"})
    EXPECT_NE(error.find(format), std::string::npos) << format;
}

TEST_F(CheckFiles, AUnitIsOfTheFilesThatStateNone) {
  folder.write("inches.json", R"({"format": "toccata-scene", "version": 1, "unit": "in", "objects": [
      {"name": "part", "generate": "box", "parameters": {"half-x": 1, "half-y": 1, "half-z": 1}}]})");
  const auto result = run({"check", "two.obj", "inches.json", "--unit", "mm", "--clearance", "all", "--json"});
  const Json report = Json::parse(result.out);
  EXPECT_EQ(report["unit"], "m");
  EXPECT_EQ(report["objects"][1]["pose"][0], 0.0254);
  EXPECT_EQ(report["objects"][0]["pose"][0], 0.001);
  ASSERT_EQ(report["warnings"].size(), 1U) << report["warnings"];
  EXPECT_NE(report["warnings"][0].get<std::string>().find(
                "inches.json: its unit is in; for the sake of --unit its numbers are made metres"),
            std::string::npos);
  EXPECT_NE(trouble({"inches.json", "inches.json", "--unit", "mm"}).find("states its unit itself: leave out --unit"),
            std::string::npos);
  folder.write("none.json", R"({"format": "toccata-scene", "version": 1, "unit": "unit", "objects": [
      {"name": "part", "generate": "box"}]})");
  EXPECT_NE(trouble({"two.obj", "none.json", "--unit", "mm"}).find("none.json: its unit is \"unit\""),
            std::string::npos);
}

/// An inch is 25.4 mm: the two overlap by half a millimetre, which nobody sees who takes their numbers as they are.
TEST_F(CheckFiles, OfDifferentUnitsBecomeMetresInAnyOrder) {
  const auto write = [&](const char* name, const char* unit, double middle, double half) {
    folder.write(name, Json{{"format", "toccata-scene"},
                            {"version", 1},
                            {"unit", unit},
                            {"objects",
                             {{{"name", name},
                               {"shape", {{"type", "box"}, {"half_extents", {half, half, half}}}},
                               {"pose", {1, 0, 0, 0, 1, 0, 0, 0, 1, middle, 0, 0}}}}}}
                           .dump());
  };
  write("in.json", "in", 0, 0.5);
  write("mm.json", "mm", 17.2, 5);
  for (const Words& files : {Words{"in.json", "mm.json"}, Words{"mm.json", "in.json"}}) {
    const auto result = run({"check", files[0], files[1], "--penetration", "--json"});
    const Json report = Json::parse(result.out);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(report["unit"], "m");
    EXPECT_NEAR(report["pairs"][0]["penetration"]["upper"].get<double>(), 0.0005, 1e-12);
    ASSERT_EQ(report["warnings"].size(), 2U) << report["warnings"];
    EXPECT_NE(report["warnings"][0].get<std::string>().find(
                  files[0] + ": its unit is " + files[0].substr(0, 2) +
                  "; since in.json has the unit in and mm.json has the unit mm, its numbers are made metres"),
              std::string::npos)
        << report["warnings"];
    const auto told = run({"check", files[0], files[1], "--clearance", "1mm"});
    EXPECT_EQ(told.exit_code, 1);
    EXPECT_TRUE(told.out.ends_with("Lengths and places are in m.\n")) << told.out;
  }
  EXPECT_NE(trouble({"in.json", "two.obj", "mm.json"})
                .find("two.obj states no unit, and in.json has the unit in and mm.json has the unit mm: "
                      "say with --unit"),
            std::string::npos);
  for (const Words& files : {Words{"two.obj", "mm.json"}, Words{"mm.json", "two.obj"}}) {
    const Json report = Json::parse(run({"check", files[0], files[1], "--json"}).out);
    EXPECT_EQ(report["unit"], "mm");
    EXPECT_EQ(report["warnings"],
              Json::array({"two.obj states no unit, and mm.json has the unit mm: its numbers are taken for mm, too; "
                           "say with --unit what they are"}));
  }
}

TEST_F(CheckFiles, SplitMakesPartsObjectsAndAReportTellsSo) {
  EXPECT_NE(trouble({"two.obj"}).find("one object"), std::string::npos);
  EXPECT_EQ(names_in({"two.obj", "--split"}), (Words{"left", "right"}));
  EXPECT_EQ(names_in({"two.obj", "parts/a.OBJ", "--split"}),
            (Words{"left", "right", "parts/a.OBJ:left", "parts/a.OBJ:right"}));
  folder.write("report.json", run({"check", "two.obj", "--split", "--json"}).out);
  EXPECT_EQ(run({"view", "report.json", "-o", "page.html"}).exit_code, 0);
}

TEST_F(CheckFiles, EqualMeshesOfSeveralFilesAreOne) {
  EXPECT_EQ(run({"check", "parts", "gen:box", "--save-case", "case.json"}).exit_code, 1);
  EXPECT_EQ(Json::parse(test::text_of(folder.path() / "case.json"))["meshes"].size(), 2U);
}

TEST_F(CheckFiles, NumbersOfAPoseEndWhereFilesBegin) {
  const Words far{"1", "0", "0", "9", "0", "1", "0", "0", "0", "0", "1", "0", "0", "0", "0", "1"};
  Words words{"check", "--pose-b"};
  words.insert(words.end(), far.begin(), far.end());
  words.insert(words.end(), {"two.obj", "parts/a.OBJ"});
  EXPECT_EQ(run(words).exit_code, 0);
  EXPECT_EQ(run({"check", "two.obj", "--pose-b", "-9", "0", "0", "0", "0", "0", "1", "parts/a.OBJ"}).exit_code, 0);
  EXPECT_EQ(run({"check", "two.obj", "parts/a.OBJ", "--pose-b", "translation=9,0,0"}).exit_code, 0);
}

}  // namespace
}  // namespace toccata
