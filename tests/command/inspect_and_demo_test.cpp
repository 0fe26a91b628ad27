#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/command.hpp"
#include "toccata/core/version.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

TEST(Command, TellsItsVersion) {
  const auto result = run_command({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, std::string("toccata ") + version + "\n");
}

TEST(Command, EveryHelpHasAnExample) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--help"}, {"check", "--help"}, {"inspect", "--help"}, {"demo", "--help"}}) {
    const auto result = run_command(words);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.out.find("Example:"), std::string::npos) << result.out;
  }
}

TEST(Command, WithoutWordsSaysWhatToDo) {
  const auto result = run_command({});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("--help"), std::string::npos);
}

TEST(Inspect, OpenMeshIsToldAsOpen) {
  const TemporaryFolder folder;
  folder.write("open.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n7 7 7\n2 0 0\n3 0 1 2\n3 0 1 4\n");
  const auto result = run_command({"inspect", "open.off"}, folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("taken as a surface"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("degenerate triangles"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("unused vertices"), std::string::npos) << result.out;
  const Json json = Json::parse(run_command({"inspect", "open.off", "--json"}, folder.path()).out);
  EXPECT_EQ(json["schema"], "toccata/inspect/1");
  EXPECT_EQ(json["objects"][0]["closed"], false);
  EXPECT_EQ(json["objects"][0]["degenerate_triangles"], 1);
  EXPECT_EQ(json["objects"][0]["unused_vertices"], 1);
  EXPECT_EQ(json["objects"][0]["box"]["upper"], Json::parse("[2, 1, 0]"));
}

TEST(Inspect, OnlyMeshesAreDivided) {
  const TemporaryFolder folder;
  folder.write("scene.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "ball", "shape": {"type": "sphere", "radius": 1}}, {"name": "box", "generate": "box"}]})");
  const auto divided = run_command({"inspect", "scene.json", "--partitions"}, folder.path());
  EXPECT_EQ(divided.exit_code, 0);
  EXPECT_NE(divided.err.find("ball is no mesh: --partitions is about meshes"), std::string::npos) << divided.err;
  EXPECT_EQ(divided.err.find("box is no mesh"), std::string::npos) << divided.err;
  EXPECT_EQ(run_command({"inspect", "scene.json"}, folder.path()).err, "");
  folder.write("cross.off", "OFF\n6 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 1\n1 1 -1\n2 1 -1\n3 0 1 2\n3 3 4 5\n");
  const auto cross = run_command({"inspect", "cross.off", "--partitions"}, folder.path());
  EXPECT_NE(cross.out.find("; 1 pair of triangles meets\n"), std::string::npos) << cross.out;
}

TEST(Inspect, UnitsComposeIntoThePose) {
  const TemporaryFolder folder;
  folder.write("part.off", "OFF\n3 1 0\n0 0 0\n1000 0 0\n0 1000 0\n3 0 1 2\n");
  const Json json = Json::parse(run_command({"inspect", "part.off", "--json", "--unit", "mm"}, folder.path()).out);
  EXPECT_EQ(json["objects"][0]["pose"][0], 0.001);
  EXPECT_EQ(json["unit"], "m");
}

TEST(Demo, FindsCollisionsInAllScenesButOne) {
  const auto result = run_command({"demo"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("in contact, decided exactly"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("toccata demo --write scenes"), std::string::npos);
  const Json json = Json::parse(run_command({"demo", "--json"}).out);
  for (const auto& [name, report] : json.items()) EXPECT_EQ(report["pairs"].empty(), name == "helices") << name;
}

TEST(Demo, WritesFilesThatCheckAsItSays) {
  const TemporaryFolder folder;
  const auto written = run_command({"demo", "--write", "scenes"}, folder.path());
  ASSERT_EQ(written.exit_code, 0) << written.err;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "scenes/README.md"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "scenes.partial"));
  EXPECT_EQ(run_command({"check", "scenes/a.obj", "scenes/b.stl"}, folder.path()).exit_code, 1);

  // A written scene gives the answer of the generated one.
  const Json direct = Json::parse(run_command({"demo", "--json"}).out);
  for (const auto& [name, report] : direct.items()) {
    const auto again = run_command({"check", "scenes/" + name + "/scene.json", "--json"}, folder.path());
    EXPECT_EQ(Json::parse(again.out)["pairs"], report["pairs"]) << name;
  }
}

/// A thin slice: it has reached the ball after some forty steps.
TEST(Demo, NoFrameOfTheClothMeetsAnything) {
  const TemporaryFolder folder;
  const auto result = run_command({"demo", "cloth", "--steps", "60", "--json", "--write", "lies"}, folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["steps"], 60);
  EXPECT_EQ(json["frames_that_meet"], 0);
  EXPECT_GT(json["near_pairs"], 0);
  const auto written = run_command({"check", "lies/cloth.obj", "lies/obstacles.obj"}, folder.path());
  EXPECT_EQ(written.exit_code, 0) << written.out << written.err;
  EXPECT_EQ(run_command({"demo", "cloth", "--steps", "0"}).exit_code, 2);
  EXPECT_EQ(run_command({"demo", "--steps", "10"}).exit_code, 2);  // of what stands
  EXPECT_EQ(run_command({"demo", "mould", "--steps", "10"}).exit_code, 2);
  EXPECT_EQ(run_command({"demo", "cloth", "--factor", "0.5"}).exit_code, 2);
  EXPECT_EQ(run_command({"demo", "silk"}).exit_code, 2);
}

/// A ring is not star-shaped: its tube cuts the hole that it is too small for.
TEST(Demo, AnyMeshStandsInTheHoleThatItLeavesInAWall) {
  const TemporaryFolder folder;
  const auto relation_in = [&](const std::string& mesh, const std::string& factor) {
    const auto result = run_command({"demo", "mould", "--mesh", mesh, "--factor", factor, "--json"}, folder.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const Json pairs = Json::parse(result.out)["pairs"];
    return pairs.empty() ? std::string("apart") : pairs[0]["relation"].get<std::string>();
  };
  EXPECT_EQ(relation_in("gen:icosphere?subdivisions=2", "1"), "touching");
  EXPECT_EQ(relation_in("gen:icosphere?subdivisions=2", "0.999"), "apart");
  EXPECT_EQ(relation_in("gen:torus", "0.999"), "overlapping");
  const auto written = run_command({"demo", "mould", "--factor", "0.999", "--write", "wall"}, folder.path());
  EXPECT_EQ(written.exit_code, 0) << written.err;
  EXPECT_EQ(run_command({"check", "wall/scene.json"}, folder.path()).exit_code, 0);
  EXPECT_EQ(run_command({"demo", "mould", "--factor", "0"}).exit_code, 2);
  EXPECT_EQ(run_command({"demo", "mould", "--mesh", "none.obj"}, folder.path()).exit_code, 2);
}

TEST(Demo, LeavesAFolderNamedPartialAlone) {
  const TemporaryFolder folder;
  folder.write("scenes.partial/mine.txt", "precious");
  const auto result = run_command({"demo", "--write", "scenes"}, folder.path());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("scenes.partial"), std::string::npos) << result.err;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "scenes.partial/mine.txt"));
}

TEST(Demo, WritingAgainUsesWhatIsThere) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_command({"demo", "--write", "scenes"}, folder.path()).exit_code, 0);
  const auto again = run_command({"demo", "--write", "scenes"}, folder.path());
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.out.find("left as it is"), std::string::npos) << again.out;
}

TEST(Demo, DoesNotOverwrite) {
  const TemporaryFolder folder;
  folder.write("scenes/mine.txt", "precious");
  const auto result = run_command({"demo", "--write", "scenes"}, folder.path());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "scenes/mine.txt"));
}

}  // namespace
}  // namespace toccata
