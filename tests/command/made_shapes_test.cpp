// What `decompose` and `minkowski` make is kept with what was asked, drawn from that, and compared.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
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
using Json = nlohmann::json;
using MadeBy = std::vector<std::string>;

Json highest_corner(const Json& points) {
  Json highest = points[0];
  for (const Json& point : points)
    for (std::size_t i = 0; i < 3; ++i) highest[i] = std::max(highest[i].get<double>(), point[i].get<double>());
  return highest;
}

/// A tetrahedron with that height.
std::string spike(const std::string& height) {
  return "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 " + height + "\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
}

const std::vector<MadeBy> made_by = {{"decompose", "spike.off"},
                                     {"minkowski", "spike.off", "gen:box", "--point", "9", "9", "9"}};

MadeBy and_also(MadeBy words, const MadeBy& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// The last time that it is there: in front of the answer a case has what was asked about.
void replace_last(const TemporaryFolder& folder, const std::string& file, const std::string& was,
                  const std::string& is) {
  std::string text = text_of(folder.path() / file);
  ASSERT_NE(text.rfind(was), std::string::npos) << text;
  folder.write(file, text.replace(text.rfind(was), was.size(), is));
}

TEST(MadeShapesCommand, AChangedFileIsRefused) {
  for (const MadeBy& words : made_by) {
    SCOPED_TRACE(words[0]);
    const TemporaryFolder folder;
    folder.write("spike.off", spike("1"));
    const auto asked = run_command(and_also(words, {"--json"}), folder.path());
    ASSERT_NE(asked.exit_code, 2) << asked.err;
    folder.write("report.json", asked.out);
    const MadeBy view = {"view", "report.json", "-o", "page.html", "--glb", "page.glb"};
    EXPECT_EQ(run_command(view, folder.path()).exit_code, 0) << run_command(view, folder.path()).err;
    folder.write("spike.off", spike("2"));
    fs::remove(folder.path() / "page.html");
    const auto changed = run_command(view, folder.path());
    EXPECT_EQ(changed.exit_code, 2);
    EXPECT_NE(changed.err.find("spike.off holds something else"), std::string::npos) << changed.err;
    EXPECT_FALSE(fs::exists(folder.path() / "page.html"));
  }
}

/// The last bit of one coordinate of one vertex counts.
TEST(MadeShapesCommand, AnotherBitIsAnotherAnswer) {
  const std::vector<std::string> places = {"/parts/0/vertices/3/2: recorded 1.0000000000000002, now 1.0",
                                           "/vertices/0/position/2: recorded -0.5000000000000001, now -0.5"};
  const std::vector<std::pair<std::string, std::string>> changes = {
      {"[0.0,0.0,1.0]", "[0.0,0.0,1.0000000000000002]"}, {"[-0.5,-0.5,-0.5]", "[-0.5,-0.5,-0.5000000000000001]"}};
  for (std::size_t i = 0; i < made_by.size(); ++i) {
    SCOPED_TRACE(made_by[i][0]);
    const TemporaryFolder folder;
    folder.write("spike.off", spike("1"));
    folder.write("report.json", run_command(and_also(made_by[i], {"--json"}), folder.path()).out);
    ASSERT_NE(run_command(and_also(made_by[i], {"--save-case", "case.json"}), folder.path()).exit_code, 2);
    replace_last(folder, "report.json", changes[i].first, changes[i].second);
    replace_last(folder, "case.json", changes[i].first, changes[i].second);
    for (const MadeBy& again : {MadeBy{"view", "report.json", "-o", "page.html"},
                                {"view", "case.json", "-o", "page.html"},
                                {"check", "case.json"},
                                {made_by[i][0], "case.json"}}) {
      const auto other = run_command(again, folder.path());
      EXPECT_EQ(other.exit_code, 1) << other.err;
      EXPECT_NE(other.err.find(places[i]), std::string::npos) << other.err;
    }
  }
}

/// All numbers of a GLB file; the text in front of them has its title.
std::string numbers_of(const std::string& glb) { return glb.substr(glb.find("BIN")); }

/// Parts are drawn instead of what was cut, a sum beside what was added; as --html draws them beside the answer.
TEST(MadeShapesCommand, WhatWasMadeIsDrawn) {
  for (const auto& [words, drawn] :
       {std::pair<MadeBy, MadeBy>{{"decompose", "gen:gear", "--parts", "2"}, {"gear-01", "gear-02"}},
        {{"minkowski", "gen:box", "gen:gear", "--hull"}, {"box", "gear", "A + B"}}}) {
    SCOPED_TRACE(words[0]);
    const TemporaryFolder folder;
    const auto asked =
        run_command(and_also(words, {"--json", "--html", "page.html", "--glb", "page.glb", "--save-case", "case.json"}),
                    folder.path());
    ASSERT_EQ(asked.exit_code, 0) << asked.err;
    folder.write("report.json", asked.out);
    const std::string glb = text_of(folder.path() / "page.glb");
    for (const std::string& name : drawn) {
      EXPECT_NE(test::page_text(folder.path() / "page.html").find("\"name\": \"" + name + "\""), std::string::npos);
      EXPECT_NE(glb.find("\"name\":\"" + name + "\""), std::string::npos) << name;
    }
    EXPECT_EQ(glb.find("parts in colour 1") != std::string::npos, words[0] == "decompose");
    folder.write("replayed.json", run_command({"replay", "case.json", "--json"}, folder.path()).out);
    for (const std::string kept : {"report.json", "case.json", "replayed.json"}) {
      ASSERT_EQ(run_command({"view", kept, "--glb", "again.glb"}, folder.path()).exit_code, 0);
      EXPECT_TRUE(numbers_of(text_of(folder.path() / "again.glb")) == numbers_of(glb)) << kept;
    }
  }
}

/// The table, the report and what is drawn are in the scale and unit that are given.
TEST(MadeShapesCommand, PartsAreToldWhereTheyAreDrawn) {
  const TemporaryFolder folder;
  folder.write("spike.off", spike("1"));
  const auto asked = run_command({"decompose", "spike.off", "--scale", "4", "-o", "parts.glb"}, folder.path());
  ASSERT_EQ(asked.exit_code, 0) << asked.err;
  EXPECT_NE(asked.out.find("1 convex part with 10.6667 in all around a solid of 10.6667"), std::string::npos);
  EXPECT_NE(asked.out.find("parts.glb: 1 convex part, "), std::string::npos) << asked.out;
  const auto told = run_command({"inspect", "parts.glb", "--json"}, folder.path());
  EXPECT_NE(told.out.find("4.0"), std::string::npos) << told.out;
  const auto json = run_command({"decompose", "spike.off", "--scale", "4", "--json"}, folder.path());
  EXPECT_NE(json.out.find("[0.0,0.0,4.0]"), std::string::npos) << json.out;
  const auto with_unit =
      run_command({"decompose", "spike.off", "--unit", "mm", "--concavity", "1mm", "--json"}, folder.path());
  EXPECT_NE(with_unit.out.find("\"concavity\":0.001"), std::string::npos) << with_unit.out << with_unit.err;
}

/// Read again they are what the report tells: names, corners and volume.
TEST(MadeShapesCommand, PartsAreWrittenAsMeshes) {
  const TemporaryFolder folder;
  const MadeBy words = {"decompose", "gen:gear", "--parts", "3", "--scale", "0.3"};
  const Json report = Json::parse(run_command(and_also(words, {"--json"}), folder.path()).out);
  for (const std::string extension : {"obj", "stl", "ply", "off"}) {
    SCOPED_TRACE(extension);
    const std::string file = "parts." + extension;
    const auto asked = run_command(and_also(words, {"-o", file}), folder.path());
    ASSERT_EQ(asked.exit_code, 0) << asked.err;
    EXPECT_NE(asked.out.find(file + ": 3 convex parts.\n"), std::string::npos) << asked.out;
    const Json objects = Json::parse(run_command({"inspect", file, "--split", "--json"}, folder.path()).out)["objects"];
    const bool has_names = extension == "obj" || extension == "stl";
    ASSERT_EQ(objects.size(), has_names ? 3U : 1U);
    double volume = 0;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      volume += objects[i]["signed_volume"].get<double>();
      if (!has_names) continue;
      const Json& part = report["parts"][i];
      EXPECT_EQ(objects[i]["name"], part["name"]);
      EXPECT_EQ(objects[i]["distinct_vertices"], part["vertices"].size());
      EXPECT_NEAR(objects[i]["signed_volume"], part["volume"], 1e-12);
      EXPECT_EQ(objects[i]["world_box"]["upper"], highest_corner(part["vertices"]));
    }
    EXPECT_NEAR(volume, report["hull_volume"], 1e-12);
  }
  const auto none = run_command(and_also(words, {"-o", "parts.obj"}), folder.path());
  EXPECT_EQ(none.exit_code, 2) << "it is there already";
}

TEST(MadeShapesCommand, PartsOfACaseAreWrittenAndOddNamesKeptToTheirLine) {
  const TemporaryFolder folder;
  folder.write("odd.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "a\nv 9 9 9", "generate": "box"}]})");
  ASSERT_EQ(run_command({"decompose", "odd.json", "--save-case", "case.json"}, folder.path()).exit_code, 0);
  const auto asked = run_command({"decompose", "case.json", "-o", "parts.obj"}, folder.path());
  EXPECT_NE(asked.out.find("parts.obj: 1 convex part.\n"), std::string::npos) << asked.out << asked.err;
  EXPECT_TRUE(text_of(folder.path() / "parts.obj").starts_with("o a_v 9 9 9-01\nv "))
      << text_of(folder.path() / "parts.obj");
}

TEST(MadeShapesCommand, DecomposeRefusesInWords) {
  const TemporaryFolder folder;
  const auto refused = [&](const MadeBy& words, const std::string& complaint) {
    const auto run = run_command(words, folder.path());
    EXPECT_EQ(run.exit_code, 2) << run.out;
    EXPECT_NE(run.err.find(complaint), std::string::npos) << run.err;
  };
  refused({"decompose", "gen:box", "gen:box"}, "here are 2 objects: name one file, of one mesh");
  refused({"decompose", "gen:box", "--concavity", "-1"}, "--concavity -1: write LENGTH, where a length is 0 or more");
  for (const char* text : {"all", "x"})
    refused({"decompose", "gen:box", "--concavity", text}, "with its own (2mm, 0.1in)\n");
  refused({"decompose", "gen:box", "--concavity", "2mm"}, "add --unit, or leave the unit out");
  refused({"decompose", "gen:box", "-o", "a", "--html", "a"}, "--html would write a, which is that of -o too");
  folder.write("open.off", "OFF\n3 1 0\n0 0 0\n4 0 0\n0 4 0\n3 0 1 2\n");
  refused({"decompose", "gen:box", "--glb", "parts.obj"},
          "parts.obj: what is written here is GLB; give the file a name that ends in .glb");
  refused({"decompose", "gen:box", "-o", "parts.html"},
          "parts.html: the extension names no format that is written (use .obj, .off, .ply, .stl or .glb)");
  refused({"decompose", "gen:box", "-o", "a.glb", "--glb", "b.glb"}, "-o and --glb both name a GLB file");
  folder.write("there.obj", "v 0 0 0\n");
  refused({"decompose", "gen:box", "-o", "there.obj"}, "there.obj: the file exists: choose another name");
  refused({"view", "gen:box", "-o", "box.glb"},
          "box.glb: what is written here is a page (HTML); give the file a name that ends in .html");
  refused({"decompose", "open.off"}, "'open'");
  refused({"decompose", "open.off"}, "close its holes");
}

TEST(MadeShapesCommand, DecomposeSaysWhichVolumesAreNoNumbers) {
  const TemporaryFolder folder;
  folder.write("spike.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  for (const auto& [scale, volume] : {std::pair{"1e150", "more than 1.8e308"}, {"1e-150", "less than 4.9e-324"}}) {
    const auto told = run_command({"decompose", "spike.off", "--scale", scale}, folder.path());
    EXPECT_EQ(told.exit_code, 0) << told.err;
    EXPECT_NE(told.out.find(std::string("solid of ") + volume + "; no"), std::string::npos) << told.out;
    const auto json = run_command({"decompose", "spike.off", "--scale", scale, "--json"}, folder.path());
    EXPECT_EQ(json.out.find("nan"), std::string::npos) << json.out;
    EXPECT_EQ(json.out.find("\"mesh_volume\": null") != std::string::npos, volume[0] == 'm') << json.out;
  }
}

TEST(MadeShapesCommand, OptionsAskAnotherQuestionOfACase) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_command({"minkowski", "gen:box", "gen:box", "--save-case", "case.json"}, folder.path()).exit_code, 0);
  const auto mesh = run_command({"minkowski", "case.json", "-o", "sum.obj"}, folder.path());
  EXPECT_NE(mesh.out.find("sum.obj: A + B with 6 faces."), std::string::npos) << mesh.out << mesh.err;
  EXPECT_TRUE(fs::exists(folder.path() / "sum.obj"));
  const auto other = run_command({"minkowski", "case.json", "--difference"}, folder.path());
  EXPECT_NE(other.out.find("A − B of"), std::string::npos) << other.out;
  EXPECT_NE(other.err.find("case.json holds a question, minkowski, which is not asked here"), std::string::npos);
}

}  // namespace
}  // namespace toccata
