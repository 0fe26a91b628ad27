// `toccata check` as a person or a script meets it: exit codes, both streams, and the reports.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

/// A closed box with corners (x, 0, 0) and (x + 1, 1, 1), of six quads.
std::string box_obj(double x) {
  std::string text;
  for (int i = 0; i < 8; ++i)
    text +=
        "v " + std::to_string(x + (i & 1)) + " " + std::to_string((i >> 1) & 1) + " " + std::to_string(i >> 2) + "\n";
  return text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
}

const char* const triangle_off = "OFF\n3 1 0\n0.5 0.3 -1\n0.5 0.3 2\n0.6 0.4 0.5\n3 0 1 2\n";

class Check : public testing::Test {
 protected:
  TemporaryFolder folder;

  void SetUp() override {
    folder.write("a.obj", box_obj(0));
    folder.write("half.obj", box_obj(0.5));
    folder.write("face.obj", box_obj(1));
    folder.write("far.obj", box_obj(3));
    folder.write("open.off", triangle_off);
  }

  test::CommandResult check(std::vector<std::string> words) {
    words.insert(words.begin(), "check");
    return run_command(words, folder.path());
  }

  Json report(std::vector<std::string> words) {
    words.emplace_back("--json");
    return Json::parse(check(words).out);
  }
};

TEST_F(Check, ExitCodeTellsWhetherSomethingTouches) {
  EXPECT_EQ(check({"a.obj", "far.obj"}).exit_code, 0);
  EXPECT_EQ(check({"a.obj", "face.obj"}).exit_code, 1);
  EXPECT_EQ(check({"a.obj", "half.obj"}).exit_code, 1);
  EXPECT_EQ(check({"a.obj", "nowhere.obj"}).exit_code, 2);
}

TEST_F(Check, TableNamesTheRelationInWords) {
  EXPECT_NE(check({"a.obj", "half.obj"}).out.find("overlaps"), std::string::npos);
  EXPECT_NE(check({"a.obj", "face.obj"}).out.find("touches"), std::string::npos);
  EXPECT_NE(check({"a.obj", "open.off"}).out.find("intersects"), std::string::npos);
  EXPECT_NE(check({"a.obj", "a.obj"}).out.find("equals"), std::string::npos);
  EXPECT_NE(check({"a.obj", "far.obj"}).out.find("Nothing collides"), std::string::npos);
}

TEST_F(Check, JsonSaysWhatWasChecked) {
  const Json json = report({"a.obj", "half.obj"});
  EXPECT_EQ(json["schema"], "toccata/check/2");
  ASSERT_EQ(json["objects"].size(), 2U);
  EXPECT_EQ(json["objects"][0]["name"], "a");
  EXPECT_EQ(json["objects"][0]["faces"], 6);
  EXPECT_EQ(json["objects"][0]["triangles"], 12);
  EXPECT_EQ(json["objects"][0]["solid"], true);
  EXPECT_EQ(json["objects"][0]["pose"], Json::parse("[1,0,0,0,1,0,0,0,1,0,0,0]"));
  ASSERT_EQ(json["pairs"].size(), 1U);
  EXPECT_EQ(json["pairs"][0]["relation"], "overlapping");
  EXPECT_EQ(json["pairs"][0]["status"], "exact");
  EXPECT_FALSE(json["pairs"][0].contains("faces"));
}

TEST_F(Check, FacesAreTheFilesOwn) {
  const Json json = report({"a.obj", "face.obj", "--faces"});
  bool the_intersecting_faces = false;
  for (const Json& pair : json["pairs"][0]["faces"]) {
    EXPECT_LT(pair["face_a"].get<int>(), 6);
    EXPECT_LT(pair["face_b"].get<int>(), 6);
    EXPECT_FALSE(pair["crossing"].get<bool>());
    if (pair["face_a"] == 5 && pair["face_b"] == 4) the_intersecting_faces = true;
  }
  EXPECT_TRUE(the_intersecting_faces);
}

TEST_F(Check, CoordinatesOfIntersectionsAreGiven) {
  const Json json = report({"a.obj", "open.off", "--faces"});
  ASSERT_FALSE(json["pairs"][0]["faces"].empty());
  for (const Json& pair : json["pairs"][0]["faces"])
    for (const Json& intersection : pair["intersections"]) {
      EXPECT_EQ(intersection["kind"], "segment");
      ASSERT_EQ(intersection["points"].size(), 2U);
      EXPECT_TRUE(intersection["points"][0][2] == 0.0 || intersection["points"][0][2] == 1.0) << intersection;
    }
}

TEST_F(Check, SecondFileIsPosed) {
  const std::vector<std::string> shift = {"1", "0", "0", "0", "1", "0", "0", "0", "1", "-2.5", "0", "0"};
  std::vector<std::string> words = {"a.obj", "far.obj", "--pose-b"};
  words.insert(words.end(), shift.begin(), shift.end());
  const Json json = report(words);
  EXPECT_EQ(json["pairs"][0]["relation"], "overlapping");
  EXPECT_EQ(json["objects"][1]["pose"][9], -2.5);
}

TEST_F(Check, TouchingCanBeIgnored) {
  const Json json = report({"a.obj", "face.obj", "--touching=ignore"});
  EXPECT_TRUE(json["pairs"].empty());
  EXPECT_EQ(json["ignored_touching"], 1);
  EXPECT_EQ(check({"a.obj", "face.obj", "--touching=ignore"}).exit_code, 0);
  EXPECT_EQ(check({"a.obj", "half.obj", "--touching=ignore"}).exit_code, 1);
}

TEST_F(Check, TouchingSurfacesCannotBeIgnoredWhenTheSideIsUnresolved) {
  const auto result = check({"a.obj", "face.obj", "--solid=none", "--touching=ignore"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("cannot tell"), std::string::npos) << result.out;
}

TEST_F(Check, SolidsAndSurfacesDiffer) {
  folder.write("small.off", "OFF\n4 4 0\n.4 .4 .4\n.6 .4 .4\n.4 .6 .4\n.4 .4 .6\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  EXPECT_EQ(report({"a.obj", "small.off"})["pairs"][0]["containment"], "b_in_a");
  EXPECT_EQ(check({"a.obj", "small.off", "--solid=none"}).exit_code, 0);
}

TEST_F(Check, ManyFilesAreCheckedPairwise) {
  const Json json = report({"a.obj", "half.obj", "face.obj", "far.obj"});
  ASSERT_EQ(json["pairs"].size(), 3U);
  EXPECT_EQ(json["pairs"][0]["relation"], "overlapping");
  EXPECT_EQ(json["pairs"][1]["relation"], "touching");
  EXPECT_EQ(json["pairs"][2]["a"], "half");
}

TEST_F(Check, CsvHasALinePerPair) {
  EXPECT_EQ(check({"a.obj", "half.obj", "far.obj", "--csv"}).out,
            "a,b,relation,containment,side_unresolved,status\na,half,overlapping,none,false,exact\n");
  EXPECT_EQ(check({"a.obj", "open.off", "--csv", "--faces"}).out.substr(0, 52),
            "a,b,relation,containment,face_a,face_b,crossing\na,op");
}

TEST_F(Check, SameFileTwiceIsTwoObjects) {
  const Json json = report({"a.obj", "a.obj"});
  EXPECT_EQ(json["objects"][0]["name"], "a");
  EXPECT_NE(json["objects"][1]["name"], "a");
  EXPECT_EQ(json["pairs"][0]["containment"], "equal");
}

TEST_F(Check, TheTableLeavesOutTheMiddleOfLongNamesAndTellsThemApart) {
  const std::string many(60, 'o'), umlauts = "ä" + many + "ü";
  const std::string left = "l" + many + "1" + many + "s", right = "l" + many + "2" + many + "s";
  for (const std::string& name : {umlauts, left, right}) folder.write(name + ".obj", box_obj(0));
  const auto run = check({umlauts + ".obj", left + ".obj", right + ".obj"});
  const std::string cut = "ä" + std::string(18, 'o') + "…" + std::string(19, 'o') + "ü";
  EXPECT_NE(run.out.find("  " + cut + "  "), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find(umlauts), std::string::npos) << run.out;
  for (const std::string& name : {left, right}) EXPECT_NE(run.out.find(name), std::string::npos) << run.out;
  EXPECT_EQ(report({umlauts + ".obj", left + ".obj"})["pairs"][0]["a"], umlauts);
}

TEST_F(Check, NamesThatAreNotUtf8AreToldApart) {
  folder.write("a\xff.obj", box_obj(0));
  folder.write("a\xfe.obj", box_obj(0));
  const Json report = Json::parse(check({"a\xff.obj", "a\xfe.obj", "a\xff.obj", "--json"}).out);
  std::set<std::string> names;
  for (const Json& object : report["objects"]) names.insert(object["name"].get<std::string>());
  EXPECT_EQ(names.size(), 3U);
  EXPECT_TRUE(names.contains("a\\xff") && names.contains("a\\xfe")) << report["objects"];
  for (const Json& pair : report["pairs"]) EXPECT_TRUE(names.contains(pair["a"].get<std::string>())) << pair;
}

TEST_F(Check, UnitAndScaleCannotLeaveNothing) {
  const auto result = check({"a.obj", "far.obj", "--unit", "1e-200", "--scale", "1e-200", "--solid=none"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("the unit 1e-200 times the scale 1e-200 is 0"), std::string::npos) << result.err;
}

TEST_F(Check, AnswerDoesNotDependOnThreads) {
  const auto one = check({"a.obj", "half.obj", "face.obj", "--json", "--faces", "--threads", "1"});
  const auto many = check({"a.obj", "half.obj", "face.obj", "--json", "--faces", "--threads", "4"});
  EXPECT_EQ(one.out, many.out);
}

}  // namespace
}  // namespace toccata
