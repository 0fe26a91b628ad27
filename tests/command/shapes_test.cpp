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
  EXPECT_EQ(report["pairs"][0]["lower"], 1);
  EXPECT_EQ(report["pairs"][0]["upper"], 1);
  EXPECT_EQ(report["pairs"][0]["on_b"], Json({0, 2, 0}));
  EXPECT_EQ(report["pairs"][1]["upper"], 0);
}

TEST_F(ShapeCommands, DistanceRefusesMeshesWithTheReason) {
  const auto run = run_command({"distance", "gen:box", "gen:icosphere"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("convex shapes and half-spaces"), std::string::npos) << run.err;
}

TEST_F(ShapeCommands, CheckTakesShapes) {
  const auto run = run_command({"check", folder.write("scene.json", scene).string(), "--json", "--faces"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const Json report = Json::parse(run.out);
  ASSERT_EQ(report["pairs"].size(), 2U);
  EXPECT_EQ(report["pairs"][0]["relation"], "touching");
  EXPECT_TRUE(report["pairs"][0]["faces"][0]["meetings"].empty());
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
