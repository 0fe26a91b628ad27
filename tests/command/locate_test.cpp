#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

constexpr const char* tetrahedron = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
/// Inside, outside, a vertex, on an edge, on a face, and beyond that face in its plane.
constexpr const char* six_points = "0.1 0.1 0.1\n1 1 1\n0 0 0\n0.5 0 0\n0.25 0.25 0\n2 2 0\n";

bool tells(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class LocateCommand : public ::testing::Test {
 protected:
  LocateCommand() {
    folder_.write("solid.off", tetrahedron);
    folder_.write("points.txt", six_points);
  }

  [[nodiscard]] test::CommandResult located(std::vector<std::string> words) const {
    words.insert(words.begin(), "locate");
    return run_command(words, folder_.path());
  }

  [[nodiscard]] Json report(std::vector<std::string> words) const {
    words.emplace_back("--json");
    const auto run = located(std::move(words));
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return Json::parse(run.out);
  }

  void expect_trouble(const std::vector<std::string>& words, const std::string& part) const {
    const auto run = located(words);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(tells(run.err, part)) << run.err;
    EXPECT_EQ(run.out, "");
  }

  TemporaryFolder folder_;
};

TEST_F(LocateCommand, EveryWayTellsTheSame) {
  for (const char* by : {"mesh", "bsp", "msp"}) {
    SCOPED_TRACE(by);
    const Json json = report({"solid.off", "--points", "points.txt", "--by", by});
    EXPECT_EQ(json["schema"], "toccata/locate/1");
    EXPECT_EQ(json["by"], by);
    std::vector<std::string> sides;
    for (const Json& point : json["points"]) sides.push_back(point["side"]);
    EXPECT_EQ(sides, (std::vector<std::string>{"inside", "outside", "boundary", "boundary", "boundary", "outside"}));
    EXPECT_EQ(json["points"][0]["winding_number"], 1);
    for (const std::size_t on : {2U, 3U, 4U}) EXPECT_EQ(json["points"][on]["triangle"], 0);
  }
}

TEST_F(LocateCommand, AnMspTreeTellsTheVertexEdgeOrFace) {
  const Json points = report({"solid.off", "--points", "points.txt", "--by", "msp"})["points"];
  EXPECT_EQ(points[2]["feature"], "vertex");
  EXPECT_EQ(points[2]["vertices"], Json::parse("[0]"));
  EXPECT_EQ(points[3]["feature"], "edge");
  EXPECT_EQ(points[3]["vertices"], Json::parse("[1, 0]"));
  EXPECT_EQ(points[4]["feature"], "face");
  EXPECT_EQ(points[4]["vertices"], Json::array());
  const std::string text = located({"solid.off", "--points", "points.txt", "--by", "msp"}).out;
  EXPECT_TRUE(tells(text, "point 2  on it    vertex 0, of triangle 0, face 0\n")) << text;
  EXPECT_TRUE(tells(text, "point 3  on it    edge from vertex 1 to 0, of triangle 0, face 0\n")) << text;
  EXPECT_TRUE(tells(text, "point 4  on it    within triangle 0, face 0\n")) << text;
  EXPECT_TRUE(tells(text, "point 5  outside\n")) << text;
}

TEST_F(LocateCommand, ATreeIsToldHowLargeItIs) {
  const Json bsp = report({"gen:torus-knot", "--by", "bsp"});
  EXPECT_EQ(bsp["triangles"], 5760);
  EXPECT_EQ(bsp["points"], Json::array());
  EXPECT_EQ(bsp["tree"]["cells"], bsp["tree"]["planes"].get<int>() + 1);
  EXPECT_EQ(bsp["tree"]["growth"], bsp["tree"]["fragments"].get<double>() / 5760);
  EXPECT_GT(bsp["tree"]["depth"], 12);
  EXPECT_GT(bsp["tree"]["bytes"], 5760);
  const Json msp = report({"solid.off", "--by", "msp"});
  EXPECT_EQ(msp["tree"]["regions_on_vertices"], 4);
  EXPECT_TRUE(report({"solid.off", "--point", "0", "0", "0"})["tree"].is_null());
  const std::string text = located({"gen:torus-knot", "--by", "bsp"}).out;
  EXPECT_TRUE(tells(text, "torus-knot: 5,760 triangles, by a BSP tree of ")) << text;
}

TEST_F(LocateCommand, WhatIsNoSolidIsRefusedWithWhereAndHowMuch) {
  folder_.write("open.off", "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n");
  for (const char* by : {"bsp", "msp"}) {
    expect_trouble({"open.off", "--by", by}, "open.off: ");
    expect_trouble({"open.off", "--by", by}, "open: 3 edges are used unequally often");
    expect_trouble({"open.off", "--by", by}, " inspect FILE --faults` ");
  }
  expect_trouble({"open.off", "--point", "0", "0", "0"}, "the mesh is open (3 edges");
  expect_trouble({"open.off", "--point", "0", "0", "0"}, " inspect FILE --faults` ");
  folder_.write("crossing.off",
                "OFF\n8 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0.1 0.1 -0.5\n1.1 0.1 -0.5\n0.1 1.1 -0.5\n0.1 0.1 0.5\n"
                "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 4 6 5\n3 4 5 7\n3 4 7 6\n3 5 6 7\n");
  expect_trouble({"crossing.off", "--by", "bsp"}, "pairs of triangles, first triangles ");
  expect_trouble({"crossing.off", "--by", "bsp"}, "--by mesh answers about this mesh");
  const Json twice = report({"crossing.off", "--point", "0.15", "0.15", "0.15"});
  EXPECT_EQ(twice["points"][0]["winding_number"], 2);
}

TEST_F(LocateCommand, ATreeThatGrowsTooMuchIsGivenUpAndTheMeshAnswersStill) {
  expect_trouble({"gen:torus-knot", "--by", "bsp", "--max-growth", "1.2"}, "more than 1.2 times as many");
  expect_trouble({"gen:torus-knot", "--by", "bsp", "--max-growth", "1.2"}, "--by mesh answers about this mesh");
  expect_trouble({"gen:torus-knot", "--by", "msp", "--max-growth", "nan"},
                 "--max-growth: give a finite number of 1 or more, not 'nan'");
  expect_trouble({"gen:torus-knot", "--by", "bsp", "--max-growth", "0"},
                 "--max-growth: give a finite number of 1 or more, not '0'");
  expect_trouble({"gen:torus-knot", "--point", "9", "0", "0", "--max-growth", "2"}, "say --by bsp or --by msp");
  EXPECT_EQ(report({"gen:torus-knot", "--point", "9", "0", "0"})["points"][0]["side"], "outside");
}

TEST_F(LocateCommand, APosedMeshIsAskedInTheWorldByItsOwnTree) {
  folder_.write("posed.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "solid", "file": "solid.off", "pose": {"translation": [10, 0, 0]}}]})");
  EXPECT_EQ(report({"posed.json", "--point", "10.1", "0.1", "0.1"})["points"][0]["side"], "inside");
  EXPECT_EQ(report({"posed.json", "--point", "10.5", "0", "0"})["points"][0]["side"], "boundary");
  expect_trouble({"posed.json", "--by", "bsp"}, "--by mesh answers about this mesh");
}

TEST_F(LocateCommand, APosedOpenMeshIsRefusedForBeingOpen) {
  folder_.write("open.off", "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n");
  folder_.write("posed.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "open", "file": "open.off", "pose": {"translation": [10, 0, 0]}}]})");
  for (const char* by : {"bsp", "msp"}) {
    expect_trouble({"posed.json", "--by", by}, "open: 3 edges are used unequally often");
    expect_trouble({"posed.json", "--by", by}, " inspect FILE --faults` ");
  }
}

TEST_F(LocateCommand, WhatIsMissingOrWrongIsSaid) {
  folder_.write("ball.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "ball", "shape": {"type": "sphere", "radius": 1}}]})");
  expect_trouble({"solid.off"}, "--point X Y Z");
  expect_trouble({"ball.json", "--point", "0", "0", "0"}, "name a file with one mesh");
  expect_trouble({"solid.off", "--point", "0", "0", "0", "--points", "points.txt"}, "--point");
  expect_trouble({"solid.off", "--by", "octree"}, "--by");
  expect_trouble({"none.off", "--by", "bsp"}, "none.off");
}

}  // namespace
}  // namespace toccata
