// `toccata cost A B` and `toccata inspect --volumes`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

const std::string straight = "1 0 0 0 1 0 0 0 1 ";

class Cost : public testing::Test {
 protected:
  TemporaryFolder folder;

  void SetUp() override {
    const char* box =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
        "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    folder.write("a.obj", box);
    folder.write("b.obj", box);
    folder.write("poses.txt", straight + "5 0 0\n" + straight + "0.5 0.5 0.5\n");
  }

  test::CommandResult cost(std::vector<std::string> words) {
    words.insert(words.begin(), {"cost", "a.obj", "b.obj"});
    return run_command(words, folder.path());
  }
};

TEST_F(Cost, TableIsSortedAndTellsTheWinner) {
  const auto result = cost({"--poses", "poses.txt", "--quick", "--rows", "3"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* text :
       {"rigid: the meshes move as they are", "refit: every vertex", "rebuild: every vertex", "volume  ", "N_bv",
        "as it ran", "- the cheapest is ", "of one query, in nanoseconds", "dearer rows (--rows 0 shows all)"})
    EXPECT_NE(result.out.find(text), std::string::npos) << text << " is missing in\n" << result.out;
  EXPECT_LT(std::count(result.out.begin(), result.out.end(), '\n'), 40);
}

TEST_F(Cost, IsDrawnAtOnceAndFromAReportThatWasKept) {
  const auto measured = cost({"--quick", "--volumes", "aabb,obb", "--json", "--svg", "cost.svg"});
  EXPECT_EQ(measured.exit_code, 0) << measured.err;
  folder.write("cost.json", measured.out);
  const auto drawing = [&](const char* file) { return test::text_of(folder.path() / file); };
  const auto drawn = run_command({"plot", "cost.json", "-o", "again.svg"}, folder.path());
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_EQ(drawn.out, "again.svg: a plot of cost.json.\n");
  EXPECT_FALSE(drawing("cost.svg").empty());
  EXPECT_EQ(drawing("cost.svg"), drawing("again.svg"));
}

/// What is drawn is the answer of now; a difference is told by the row's own key, as times put rows anywhere.
TEST_F(Cost, ACaseIsDrawnAndItsRowsAreNamed) {
  ASSERT_EQ(cost({"--quick", "--volumes", "aabb,obb", "--save-case", "case.json"}).exit_code, 0);
  const auto drawn = run_command({"cost", "case.json", "--svg", "case.svg"}, folder.path());
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_TRUE(test::text_of(folder.path() / "case.svg").starts_with("<!-- Plot of Toccata -->"));
  std::string text = test::text_of(folder.path() / "case.json");
  const std::size_t place = text.rfind("\"N_bv\":") + 7;
  folder.write("case.json", text.insert(place, "1"));
  const auto other = run_command({"replay", "case.json"}, folder.path());
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_TRUE(other.out.find("/rows/rigid ") != std::string::npos || other.out.find("/rows/re") != std::string::npos)
      << other.out;
  EXPECT_NE(other.out.find("/N_bv: recorded 1"), std::string::npos) << other.out;
}

TEST_F(Cost, PlotsThatCannotBeAreRefused) {
  const auto refused = [&](const std::vector<std::string>& words, const std::string& message) {
    const auto result = run_command(words, folder.path());
    EXPECT_EQ(result.exit_code, 2) << result.out;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  };
  folder.write("report.json", "{}");
  refused({"plot", "report.json", "-o", "a.svg"}, "report.json");
  refused({"plot", "report.json", "-o", "report.json"}, "which is a file that is read too");
  refused({"plot", "missing.json", "-o", "a.svg"}, "missing.json");
  refused({"plot", "report.json", "-o", "a.obj"}, "is not a plot of Toccata");
  refused({"plot", "report.json"}, "--output is required");
  refused({"cost", "a.obj", "b.obj", "--svg", "b.obj"}, "which is a file that is read too");
  refused({"cost", "a.obj", "b.obj", "--svg", "nowhere/a.svg"}, "nowhere/a.svg: the file cannot be written");
}

TEST_F(Cost, JsonHasEveryTermAndFIsTheirSum) {
  const auto result = cost({"--poses", "poses.txt", "--json", "--volumes", "aabb,obb,wide", "--builders", "median",
                            "--arities", "2,3", "--task", "contacts", "--leaf-size", "1"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["schema"], "toccata/cost/1");
  EXPECT_EQ(json["task"], "contacts");
  EXPECT_EQ(json["left_out"], Json::array());
  EXPECT_EQ(json["objects"][1]["name"], "b");
  ASSERT_EQ(json["answers"].size(), 2U);
  EXPECT_EQ(json["answers"][0], 0);
  EXPECT_GT(json["answers"][1], 0);
  EXPECT_EQ(json["winners"].size(), 3U);
  EXPECT_EQ(json["rows"].size(), 3U * (2 * 2 + 1));
  for (const Json& row : json["rows"]) {
    const auto number = [&](const char* name) { return row[name].get<double>(); };
    const double sum =
        number("N_u") * number("C_u_ns") + number("N_bv") * number("C_bv_ns") + number("N_p") * number("C_p_ns");
    EXPECT_NEAR(number("F_ns"), sum / number("queries"), 1e-9 * (1 + sum)) << row;
    if (row["volume"] == "wide") continue;
    EXPECT_EQ(row["builder"], "median");
    EXPECT_EQ(row["leaf_size"], 1);
  }
}

TEST_F(Cost, CsvHasALinePerRow) {
  const auto result = cost({"--csv", "--volumes", "ball", "--workloads", "rigid", "--builders", "heuristic,morton"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1 + 2 * 3);
  EXPECT_EQ(result.out.find("workload,volume,arity,builder,leaf_size,queries,N_u,C_u_ns,N_bv,C_bv_ns,N_p,C_p_ns,F_ns,"),
            0U);
}

TEST_F(Cost, WhatIsNamedTwiceIsMeasuredOnce) {
  const auto result = cost({"--csv", "--volumes", "aabb,aabb", "--workloads", "rigid,rigid", "--builders",
                            "median,median", "--arities", "2,2,2"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1 + 1) << result.out;
}

TEST_F(Cost, TheLibrarysOwnTreeHasItsOwnBuilder) {
  const std::string remark = "wide, the library's own tree, has eight children a node and its own builder";
  const auto says = [&](const char* builder, const char* arity) {
    const auto result = cost({"--volumes", "wide,aabb", "--builders", builder, "--arities", arity});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out.find(remark) != std::string::npos;
  };
  EXPECT_TRUE(says("median", "8"));
  EXPECT_TRUE(says("heuristic", "2"));
  EXPECT_FALSE(says("heuristic,median", "2,8"));
  EXPECT_EQ(cost({"--volumes", "wide", "--builders", "heuristic", "--arities", "8"}).exit_code, 0);
}

TEST_F(Cost, TroubleIsToldInWords) {
  const auto expect_trouble = [&](const test::CommandResult& result, const std::string& message) {
    EXPECT_EQ(result.exit_code, 2) << result.out;
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
  };
  const auto unknown = cost({"--volumes", "sausages-and-mash"});
  expect_trouble(unknown, "there is no volume 'sausages-and-mash' (known: aabb, ball, ");
  EXPECT_EQ(unknown.err.find("aabb"), unknown.err.rfind("aabb")) << "the list is there once: " << unknown.err;
  expect_trouble(cost({"--volumes", "obbb"}), "there is no volume 'obbb'; did you mean 'obb'? (known: aabb, ball, ");
  expect_trouble(cost({"--builders", "sah"}), "there is no builder 'sah'");
  expect_trouble(cost({"--task", "touch"}), "(known: overlap, contacts, distance)");
  expect_trouble(cost({"--arities", "1"}), "2 to 8 children a node, not 1");
  expect_trouble(cost({"--arities", ""}), "give a whole number from 0 to 1024, not ''");
  expect_trouble(cost({"--rows", "-1"}), "--rows");
  expect_trouble(cost({"--rows", "99999999999999999999"}), "--rows");
  expect_trouble(cost({"--rows", "18446744073709551615"}), "--rows");
  expect_trouble(cost({"--volumes", "wide", "--builders", "median"}), "has eight children a node and its own builder");
  expect_trouble(cost({"--volumes", "wide", "--arities", "2"}), "name another volume as well");
  expect_trouble(cost({"--quick", "--all"}), "excludes");
  expect_trouble(run_command({"cost", "a.obj"}, folder.path()), "two meshes; here is 1");
  folder.write("empty.obj", "v 0 0 0\n");
  expect_trouble(run_command({"cost", "a.obj", "empty.obj"}, folder.path()), "empty.obj");
  folder.write("ball.json",
               R"({"format": "toccata-scene", "version": 1, "objects": [
                 {"name": "ball", "shape": {"type": "sphere", "radius": 1}}]})");
  expect_trouble(run_command({"cost", "a.obj", "ball.json"}, folder.path()), "'ball' is a sphere");
}

TEST_F(Cost, InspectTellsTheVolumesOfAMesh) {
  const auto table = run_command({"inspect", "a.obj", "--volumes"}, folder.path());
  EXPECT_EQ(table.exit_code, 0) << table.err;
  for (const char* text : {"filled", "memory", "ellipsoid", "26-dop", "agglomeration"})
    EXPECT_NE(table.out.find(text), std::string::npos) << text;
  const Json json = Json::parse(run_command({"inspect", "a.obj", "--volumes", "--json"}, folder.path()).out);
  const Json& volumes = json["objects"][0]["volumes"];
  EXPECT_EQ(volumes.size(), 13U * 3 * 7);
  std::set<std::string> names;
  for (const Json& volume : volumes) {
    names.insert(volume["volume"]);
    if (volume["volume"] == "aabb") {
      EXPECT_EQ(volume["root_volume"], 1);
      EXPECT_EQ(volume["root_surface"], 6);
      EXPECT_EQ(volume["fill"], 1);
    }
  }
  EXPECT_EQ(names.size(), 13U);
  EXPECT_FALSE(
      Json::parse(run_command({"inspect", "a.obj", "--json"}, folder.path()).out)["objects"][0].contains("volumes"));
}

}  // namespace
}  // namespace toccata
