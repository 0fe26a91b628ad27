// Shapes of a few numbers as a person or a script meets them: distances, checks and the table of pairs.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

const char* const scene = R"({"format": "toccata-scene", "version": 1, "objects": [
  {"name": "ball", "shape": {"type": "sphere", "radius": 1}},
  {"name": "crate", "shape": {"type": "box", "half_extents": [1, 1, 1]}, "pose": {"translation": [0, 3, 0]}},
  {"name": "ground", "shape": {"type": "half-space", "normal": [0, 0, 1]}, "pose": {"translation": [0, 0, -1]}}]})";

class ShapeCommands : public testing::Test {
 protected:
  TemporaryFolder folder;
};

TEST_F(ShapeCommands, DistanceTellsAllPairsOfAScene) {
  const auto run = run_command({"distance", folder.write("scene.json", scene).string(), "--json"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const Json report = Json::parse(run.out);
  EXPECT_EQ(report["schema"], "toccata/distance/1");
  ASSERT_EQ(report["pairs"].size(), 3U);
  const double lower = report["pairs"][0]["lower"], upper = report["pairs"][0]["upper"];
  EXPECT_LE(lower, 1);
  EXPECT_GE(upper, 1);
  EXPECT_LE(upper - lower, 1e-12);
  EXPECT_NEAR(report["pairs"][0]["on_b"][1], 2, 1e-12);
  EXPECT_EQ(report["pairs"][1]["upper"], 0);
}

TEST_F(ShapeCommands, ADistanceThatIsNotNarrowIsToldByBothEnds) {
  const auto run =
      run_command({"distance", folder
                                   .write("needle.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "needle", "shape": {"type": "ellipsoid", "half_axes": [1e-200, 1e200, 1]}, "pose": {"translation": [0, 0, 3]}},
    {"name": "floor", "shape": {"type": "half-space", "normal": [0, 0, 1]}}]})")
                                   .string()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("  0 to "), std::string::npos) << run.out;
}

TEST_F(ShapeCommands, DistanceOfMeshes) {
  const auto run = run_command({"distance", "gen:box", "gen:icosphere", "--pose-b", "1", "0", "0", "0", "1", "0", "0",
                                "0", "1", "5", "0", "0", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const Json pair = Json::parse(run.out)["pairs"][0];
  EXPECT_GT(pair["lower"], 3);
  EXPECT_LT(pair["upper"], 5);
  EXPECT_NEAR(pair["on_a"][0], 0.5, 1e-12);
  EXPECT_EQ(pair["face_a"], 1);
  EXPECT_EQ(run_command({"distance", "gen:box", "gen:icosphere"}).exit_code, 1);
  const auto surfaces = run_command({"distance", "gen:box", "gen:icosphere", "--solid=none"});
  EXPECT_EQ(surfaces.exit_code, 0) << surfaces.out << surfaces.err;
}

TEST_F(ShapeCommands, RayTellsWhatIsMetFirst) {
  const std::string file = folder.write("scene.json", scene).string();
  const auto one = run_command({"ray", file, "--from", "0", "9", "0.25", "--to", "0", "-9", "0.25", "--json"});
  EXPECT_EQ(one.exit_code, 1) << one.err;
  const Json hit = Json::parse(one.out)["rays"][0];
  EXPECT_EQ(hit["object"], "crate");
  EXPECT_NEAR(hit["point"][1], 4, 1e-12);
  EXPECT_EQ(hit["normal"][1], 1);
  const std::string rays = folder.write("rays.txt", "0 0 9, 0 0 -9  # down\n9 9 9  9 9 10\n").string();
  const auto many = run_command({"ray", "gen:icosphere", "--rays", rays, "--csv"});
  EXPECT_EQ(many.exit_code, 1) << many.err;
  EXPECT_NE(many.out.find("\n0,1,icosphere,"), std::string::npos) << many.out;
  EXPECT_NE(many.out.find("\n1,0,,,,,,,,,,,exact\n"), std::string::npos) << many.out;
  EXPECT_EQ(run_command({"ray", file, "--from", "50", "50", "50", "--to", "51", "50", "50"}).exit_code, 0);
}

TEST_F(ShapeCommands, BadRaysAreRefused) {
  const auto refused = [&](const std::vector<std::string>& words, const std::string& told) {
    const auto run = run_command(words);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(run.out.empty());
    EXPECT_NE(run.err.find(told), std::string::npos) << run.err;
  };
  const std::string rays = folder.write("rays.txt", "0 0 9  0 0 -9\n1 2 3 4\n").string();
  refused({"ray", "gen:box"}, "no ray is given");
  refused({"ray", "gen:box", "--from", "0", "0", "1"}, "--to is missing");
  const std::string far = folder.write("far.txt", "1e308 0 0  -1e308 0 0\n").string();
  refused({"ray", "gen:box", "--rays", far}, "far.txt:1: the ray is longer than doubles can tell");
  refused({"ray", "gen:box", "--from", "1e308", "0", "0", "--to", "-1e308", "0", "0"}, "--from and --to");
  refused({"ray", "gen:box", "--rays", rays}, "rays.txt:2: a line of 6 numbers has 4");
  refused({"ray", "gen:box", "--from", "0", "0", "1", "--to", "0", "0", "1"}, "one point");
  refused({"ray", "gen:box", "--from", "0", "0", "x", "--to", "0", "0", "1"}, "--from: 'x' is not a finite number");
}

TEST_F(ShapeCommands, NearestTellsThePointOfASurface) {
  const auto one = run_command({"nearest", "gen:box", "--point", "3", "0.25", "0.125", "--json"});
  EXPECT_EQ(one.exit_code, 0) << one.err;
  const Json nearest = Json::parse(one.out)["points"][0]["nearest"];
  ASSERT_EQ(nearest.size(), 1U);
  EXPECT_NEAR(nearest[0]["upper"], 2.5, 1e-11);
  EXPECT_EQ(nearest[0]["at"], Json({0.5, 0.25, 0.125}));
  const std::string points = folder.write("points.txt", "3 0 0.125  # off\n9,9,9\n").string();
  const auto many =
      run_command({"nearest", "gen:box", "gen:icosphere", "--points", points, "--k=2", "--within=3", "--csv"});
  EXPECT_EQ(many.exit_code, 0) << many.err;
  EXPECT_NE(many.out.find("\n0,1,icosphere,"), std::string::npos) << many.out;
  EXPECT_NE(many.out.find("\n0,2,icosphere,"), std::string::npos) << many.out;
  EXPECT_NE(many.out.find("\n1,0,,,,,,,,,\n"), std::string::npos) << many.out;
}

TEST_F(ShapeCommands, BadQuestionsForTheNearestPointAreRefused) {
  const auto refused = [&](const std::vector<std::string>& words, const std::string& told) {
    const auto run = run_command(words);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(run.out.empty());
    EXPECT_NE(run.err.find(told), std::string::npos) << run.err;
  };
  refused({"nearest", "gen:box"}, "no point is given");
  refused({"nearest", "gen:box", "--points", folder.write("points.txt", "0 0 1\n0 1\n").string()},
          "points.txt:2: a line of 3 numbers has 2");
  refused({"nearest", "gen:box", "--points", folder.write("none.txt", "# none\n").string()}, "holds no point");
  refused({"nearest", "gen:box", "--point", "0", "0", "x"}, "--point: 'x' is not a finite number");
  refused({"nearest", "gen:box", "--point", "0", "0", "1", "--within=-1"},
          "--within -1: write LENGTH, where a length is 0 or more");
  refused({"nearest", "gen:box", "--point", "0", "0", "1", "--k=0"}, "--k");
}

TEST_F(ShapeCommands, CheckTakesShapes) {
  const auto run = run_command({"check", folder.write("scene.json", scene).string(), "--json", "--faces"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const Json report = Json::parse(run.out);
  ASSERT_EQ(report["pairs"].size(), 2U);
  EXPECT_EQ(report["pairs"][0]["relation"], "touching");
  EXPECT_TRUE(report["pairs"][0]["faces"][0]["intersections"].empty());
}

TEST_F(ShapeCommands, InspectTellsTheNumbersOfShapes) {
  const std::string text = R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "ball", "shape": {"type": "sphere", "radius": 0.5, "centre": [1, 0, 0]}, "pose": {"translation": [0, 0, 2]}},
    {"name": "wedge", "shape": {"type": "convex-hull", "points": [[0,0,0],[2,0,0],[0,2,0],[0,0,2],[0.1,0.1,0.1]]}},
    {"name": "ground", "shape": {"type": "half-space", "normal": [0, 0, 1]}},
    {"name": "pair", "shape": {"type": "compound", "parts": [{"shape": {"type": "box", "half_extents": [1, 1, 1]}},
      {"shape": {"type": "rounded", "radius": 0.25, "core": {"type": "point", "position": [3, 0, 0]}}}]}},
    {"name": "egg", "shape": {"type": "sphere", "radius": 1}, "pose": {"scale": [1, 1, 2]}}]})";
  const std::string file = folder.write("scene.json", text).string();
  const auto table = run_command({"inspect", file});
  EXPECT_EQ(table.exit_code, 0) << table.err;
  for (const char* const line :
       {"sphere of radius 0.5 around (1, 0, 0)", "(0.5, -0.5, 1.5) to (1.5, 0.5, 2.5) m", "without end",
        "convex hull with 4 vertices, 6 edges and 4 faces: (0, 0, 0), (2, 0, 0)", "half-space behind (0, 0, 0)",
        "compound of 2 parts: box of half extents (1, 1, 1) around (0, 0, 0); rounded by 0.25: point (3, 0, 0)",
        "ellipsoid"})
    EXPECT_NE(table.out.find(line), std::string::npos) << line << "\n" << table.out;
  const Json objects = Json::parse(run_command({"inspect", file, "--json"}).out)["objects"];
  EXPECT_EQ(objects[0]["numbers"], Json::parse(R"({"radius": 0.5, "centre": [1, 0, 0]})"));
  EXPECT_EQ(objects[0]["solid"], true);
  EXPECT_LE(objects[0]["world_box"]["lower"][0], 0.5);
  EXPECT_EQ(objects[1]["hull"], Json::parse(R"({"vertices": 4, "edges": 6, "faces": 4, "dimension": 3})"));
  EXPECT_EQ(objects[1]["numbers"]["points"].size(), 4U);
  EXPECT_EQ(objects[1]["world_box"]["upper"], Json({2, 2, 2}));
  EXPECT_TRUE(objects[2]["world_box"].is_null());
  EXPECT_EQ(objects[3]["parts"][1]["numbers"]["radius"], 0.25);
  EXPECT_NE(objects[4]["refusal"].get<std::string>().find("ellipsoid"), std::string::npos);
}

TEST_F(ShapeCommands, DistanceAsCsv) {
  const auto run = run_command({"distance", folder.write("scene.json", scene).string(), "--csv"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_TRUE(run.out.starts_with(
      "a,b,lower,upper,on_a_x,on_a_y,on_a_z,on_b_x,on_b_y,on_b_z,face_a,face_b,status\nball,crate,"))
      << run.out;
  EXPECT_NE(run.out.find("\nball,ground,0,0,"), std::string::npos) << run.out;
}

/// A ball and a crate, each in a file, for --poses and --pose-b.
class TwoShapes : public ShapeCommands {
 protected:
  void SetUp() override {
    write("ball.json", R"({"type": "sphere", "radius": 1})");
    write("crate.json", R"({"type": "box", "half_extents": [1, 1, 1]})");
    folder.write("poses.txt", rows + "0 3 0\n" + rows + "0 1.5 0\n" + rows + "1 0 0 " + rows + "1 2 0\n");
  }

  void write(const std::string& file, const std::string& shape) {
    folder.write(file, R"({"format": "toccata-scene", "version": 1, "objects": [{"name": ")" + file.substr(0, 4) +
                           R"(", "shape": )" + shape + "}]}");
  }

  test::CommandResult run(const std::vector<std::string>& words) { return run_command(words, folder.path()); }

  const std::string rows = "1 0 0 0 1 0 0 0 1 ";
};

TEST_F(TwoShapes, DistanceAtManyPoses) {
  const auto table = run({"distance", "ball.json", "crate.json", "--poses", "poses.txt"});
  EXPECT_EQ(table.exit_code, 1) << table.err;
  EXPECT_NE(table.out.find("  query 0  ball  crat  1 apart  (0, 1, 0) to (0, 2, 0)\n"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("2 of 3 queries meet.\n"), std::string::npos) << table.out;
  const Json report = Json::parse(run({"distance", "ball.json", "crate.json", "--poses", "poses.txt", "--json"}).out);
  EXPECT_EQ(report["schema"], "toccata/distance-poses/2");
  EXPECT_EQ(report["intersecting"], 2);
  ASSERT_EQ(report["queries"].size(), 3U);
  EXPECT_NEAR(report["queries"][0]["on_b"][1], 2, 1e-12);
  EXPECT_EQ(report["queries"][2]["pose_a"], Json::parse("[1,0,0,0,1,0,0,0,1,1,0,0]"));
  EXPECT_EQ(report["queries"][2]["upper"], 0);
  const auto csv = run({"distance", "ball.json", "crate.json", "--poses", "poses.txt", "--csv"});
  EXPECT_TRUE(csv.out.starts_with("query,lower,upper,")) << csv.out;
  EXPECT_NE(csv.out.find("\n1,0,0,"), std::string::npos) << csv.out;
}

TEST_F(TwoShapes, DistanceIsTheSameOnAnyNumberOfThreads) {
  std::vector<std::string> words = {"distance",  "ball.json", "crate.json", "--poses",
                                    "poses.txt", "--json",    "--threads"};
  words.push_back("1");
  const auto one = run(words);
  words.back() = "3";
  EXPECT_EQ(one.out, run(words).out);
  const std::string file = folder.write("scene.json", scene).string();
  EXPECT_EQ(run({"distance", file, "--json", "--threads", "1"}).out,
            run({"distance", file, "--json", "--threads", "3"}).out);
}

TEST_F(TwoShapes, DistanceAtOnePose) {
  const auto far = run({"distance", "ball.json", "crate.json", "--pose-b", "1", "0", "0", "0", "1", "0", "0", "0", "1",
                        "0", "5", "0", "--json"});
  EXPECT_EQ(far.exit_code, 0) << far.err;
  EXPECT_NEAR(Json::parse(far.out)["pairs"][0]["on_b"][1], 4, 1e-12);
}

TEST_F(TwoShapes, TroubleWithPosesIsToldWithTheQuery) {
  folder.write("poses.txt", rows + "0 0 0\n2 0 0 0 1 0 0 0 1 0 0 0 " + rows + "0 0 0\n");
  for (const char* const question : {"distance", "check"}) {
    const auto result = run({question, "ball.json", "crate.json", "--poses", "poses.txt"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("query 1: model a"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("ellipsoid"), std::string::npos) << result.err;
  }
  EXPECT_NE(run({"distance", "ball.json", "--poses", "poses.txt"}).err.find("two objects"), std::string::npos);
}

TEST_F(TwoShapes, PenetrationAtManyPoses) {
  const auto result = run({"check", "ball.json", "crate.json", "--poses", "poses.txt", "--penetration"});
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_NE(result.out.find("0.5 deep along (0, 1, 0)"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("0 deep"), std::string::npos) << result.out;
  const Json json =
      Json::parse(run({"check", "ball.json", "crate.json", "--poses", "poses.txt", "--penetration", "--json"}).out);
  EXPECT_EQ(json["queries"][0]["penetration"]["upper"], 0);
  EXPECT_LE(json["queries"][1]["penetration"]["lower"], 0.5);
  EXPECT_GE(json["queries"][1]["penetration"]["upper"], 0.5);
  const auto csv = run({"check", "ball.json", "crate.json", "--poses", "poses.txt", "--penetration", "--csv"});
  EXPECT_NE(csv.out.find(",contact,depth_lower,depth_upper,direction_x,direction_y,direction_z,depth_ended\n0,apart"),
            std::string::npos)
      << csv.out;
}

TEST_F(ShapeCommands, CheckTellsHowDeepAndWhere) {
  const std::string deep = R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "crate", "shape": {"type": "box", "half_extents": [1, 1, 1]}, "pose": {"translation": [0, 0, 0.875]}},
    {"name": "needle", "shape": {"type": "segment", "start": [0, 0, 0], "end": [0, 0, 9]}},
    {"name": "ground", "shape": {"type": "half-space", "normal": [0, 0, 1]}}]})";
  const std::string file = folder.write("scene.json", deep).string();
  const auto table = run_command({"check", file, "--penetration"});
  EXPECT_EQ(table.exit_code, 1) << table.err;
  EXPECT_NE(table.out.find("      0.125 deep along (0, 0, -1), moving ground\n      contact at "), std::string::npos)
      << table.out;
  EXPECT_NE(table.out.find("      no depth: a surface has no interior"), std::string::npos) << table.out;
  const Json report = Json::parse(run_command({"check", file, "--penetration", "--json"}).out);
  ASSERT_EQ(report["pairs"].size(), 3U);
  const Json& on_ground = report["pairs"][1];
  EXPECT_EQ(on_ground["b"], "ground");
  EXPECT_EQ(on_ground["penetration"]["direction"], Json({0, 0, -1}));
  EXPECT_LE(on_ground["penetration"]["lower"], 0.125);
  EXPECT_GE(on_ground["penetration"]["upper"], 0.125);
  EXPECT_EQ(on_ground["manifold"]["points"].size(), 4U);
  EXPECT_EQ(on_ground["manifold"]["points"][0]["on_b"]["kind"], "face");
  EXPECT_TRUE(report["pairs"][0]["penetration"].is_null());
  EXPECT_FALSE(report["pairs"][0]["manifold"].is_null());
  const auto csv = run_command({"check", file, "--penetration", "--csv"});
  EXPECT_NE(csv.out.find("\ncrate,needle,crossing,none,false,exact,,,,,,\n"), std::string::npos) << csv.out;
  EXPECT_EQ(run_command({"check", file, "--penetration", "--self"}).exit_code, 2);
}

TEST_F(ShapeCommands, PenetrationTellsThePointsOfEachTriangleThatAShapeMeets) {
  const auto on_floor = [](const std::string& shape) {
    return R"({"format": "toccata-scene", "version": 1, "objects": [
      {"name": "floor", "shape": {"type": "height-field", "columns": 2, "rows": 2, "spacing": [4, 4], "heights": [0, 0, 0, 0]}},
      {"name": "part", "pose": {"translation": [2, 2, 0.9375]}, "shape": )" +
           shape + "}]}";
  };
  for (const std::string& shape : {std::string(R"({"type": "cylinder", "radius": 0.5, "half_height": 1})"),
                                   std::string(R"({"type": "box", "half_extents": [0.5, 0.5, 1]})")}) {
    const std::string file = folder.write("scene.json", on_floor(shape)).string();
    const auto table = run_command({"check", file, "--penetration"});
    EXPECT_NE(table.out.find("      faces 0 and 0 in contact at "), std::string::npos) << table.out;
    const Json pair = Json::parse(run_command({"check", file, "--penetration", "--json"}).out)["pairs"][0];
    EXPECT_TRUE(pair["manifold"].is_null());
    ASSERT_EQ(pair["manifolds"].size(), 2U) << pair;
    for (std::size_t i = 0; i < 2; ++i) {
      const Json& one = pair["manifolds"][i];
      EXPECT_EQ(one["element_a"], i);
      EXPECT_GE(one["points"].size(), 3U);
      EXPECT_NEAR(one["normal"][2].get<double>(), 1, 1e-12);
      for (const Json& point : one["points"]) EXPECT_NEAR(point["depth"].get<double>(), 0.0625, 1e-12) << shape;
    }
  }
}

TEST_F(ShapeCommands, TheTableOfPairsIsTheOneOfTheDocs) {
  const auto run = run_command({"pairs"});
  EXPECT_EQ(run.exit_code, 0);
  std::ifstream file(TOCCATA_DOCS "/reference/pairs.md");
  std::stringstream page;
  page << file.rdbuf();
  EXPECT_NE(page.str().find(run.out), std::string::npos) << "docs/reference/pairs.md must hold\n" << run.out;
}

}  // namespace
}  // namespace toccata
