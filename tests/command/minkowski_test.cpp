#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;

bool sum_says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

constexpr const char* boxes_to_add = R"({"format": "toccata-scene", "version": 1, "objects": [
  {"name": "left", "shape": {"type": "box", "half_extents": [1, 2, 3]}},
  {"name": "right", "shape": {"type": "box", "half_extents": [1, 1, 1]}, "pose": [1,0,0, 0,1,0, 0,0,1, 2,0,0]}]})";

TEST(MinkowskiCommand, WritesWhatItComputes) {
  const TemporaryFolder folder;
  folder.write("boxes.json", boxes_to_add);
  const auto sum = run_command({"minkowski", "boxes.json", "-o", "sum.obj", "--html", "sum.html"}, folder.path());
  EXPECT_EQ(sum.exit_code, 0) << sum.err;
  EXPECT_TRUE(sum_says(sum.out, "8 vertices and 6 faces: 0 of A, 0 of B, 6 of both, 0 of edges")) << sum.out;
  const auto measured = run_command({"inspect", "sum.obj", "--json"}, folder.path());
  EXPECT_TRUE(sum_says(measured.out, "192")) << measured.out;  // 4 × 6 × 8
  const auto glb = run_command({"minkowski", "boxes.json", "--difference", "-o", "sum.glb"}, folder.path());
  EXPECT_EQ(glb.exit_code, 0) << glb.err;
  EXPECT_EQ(run_command({"inspect", "sum.glb"}, folder.path()).exit_code, 0);
}

TEST(MinkowskiCommand, WritesOverNoMeshAndNothingWhereItFails) {
  const TemporaryFolder folder;
  folder.write("boxes.json", boxes_to_add);
  folder.write("mine.obj", "mine\n");
  const auto refused = run_command({"minkowski", "boxes.json", "-o", "mine.obj"}, folder.path());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_TRUE(sum_says(refused.err, "mine.obj: the file exists")) << refused.err;
  EXPECT_EQ(test::text_of(folder.path() / "mine.obj"), "mine\n");
  folder.write("points.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "a", "shape": {"type": "point", "position": [0, 0, 0]}}, {"name": "b", "shape": {"type": "point", "position": [1, 0, 0]}}]})");
  const auto point = run_command({"minkowski", "points.json", "--html", "p.html", "-o", "p.obj"}, folder.path());
  EXPECT_EQ(point.exit_code, 2);
  EXPECT_TRUE(sum_says(point.err, "no faces")) << point.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "p.html"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "p.obj"));
}

TEST(MinkowskiCommand, TellsBallsCapsulesAndPointsAsWhatTheyAre) {
  const TemporaryFolder folder;
  const auto told = [&](const std::string& a, const std::string& b) {
    folder.write("two.json", R"({"format": "toccata-scene", "version": 1, "objects": [
      {"name": "a", "shape": )" + a +
                                 R"(}, {"name": "b", "shape": )" + b + "}]}");
    const auto result = run_command({"minkowski", "two.json"}, folder.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  };
  const std::string ball = R"({"type": "sphere", "radius": 0.5})",
                    point = R"({"type": "point", "position": [1, 0, 0]})";
  EXPECT_EQ(told(ball, ball), "A + B of A = a and B = b: a ball of radius 1 around (0, 0, 0)\n");
  EXPECT_EQ(told(point, point), "A + B of A = a and B = b: the point (2, 0, 0)\n");
  EXPECT_EQ(told(point, R"({"type": "capsule", "start": [0, 0, 0], "end": [0, 0, 2], "radius": 0.25})"),
            "A + B of A = a and B = b: a capsule of radius 0.25 from (1, 0, 0) to (1, 0, 2)\n");
  const std::string box = told(R"({"type": "box", "half_extents": [1, 1, 1]})", ball);
  EXPECT_TRUE(sum_says(
      box, "a solid of 8 vertices and 6 faces: 6 of A, 0 of B, 0 of both, 0 of edges; grown by a ball of radius 0.5"))
      << box;
  const auto mesh = run_command({"minkowski", "two.json", "-o", "box.obj"}, folder.path());
  EXPECT_TRUE(sum_says(mesh.out, "box.obj: A + B with 6 faces, without the ball of radius 0.5 that grows it."))
      << mesh.out;
}

TEST(MinkowskiCommand, TellsWhereAPointLies) {
  const TemporaryFolder folder;
  folder.write("boxes.json", boxes_to_add);
  const auto side = [&](const std::string& x, int exit_code) {
    const auto result =
        run_command({"minkowski", "boxes.json", "--difference", "--json", "--point", x, "0", "0"}, folder.path());
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    return nlohmann::json::parse(result.out)["point"]["side"].get<std::string>();
  };
  EXPECT_EQ(side("0", 0), "boundary");
  EXPECT_EQ(side("-0.5", 0), "inside");
  EXPECT_EQ(side("0.5", 1), "outside");
}

TEST(MinkowskiCommand, RefusesWhatItCannotDo) {
  const TemporaryFolder folder;
  const auto trouble = [&](const std::vector<std::string>& words, const std::string& part) {
    const auto result = run_command(words, folder.path());
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(sum_says(result.err, part)) << result.err;
    EXPECT_EQ(result.out, "");
  };
  trouble({"minkowski", "gen:torus", "gen:box"}, "--hull takes its convex hull");
  trouble({"minkowski", "gen:box"}, "two objects");
  trouble({"minkowski", "gen:box", "gen:box", "-o", "sum.xyz"},
          "sum.xyz: the extension names no format that is written (use .obj, .off, .ply, .stl or .glb)");
  folder.write("plane.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "floor", "shape": {"type": "half-space", "normal": [0, 0, 1]}}]})");
  trouble({"minkowski", "gen:box", "plane.json"}, "bounded convex shapes");
  trouble({"minkowski", "gen:box",  "gen:box", "--difference",
           "--pose-a",  "1",        "0",       "0",
           "0",         "1",        "0",       "0",
           "0",         "1",        "1.7e308", "0",
           "0",         "--pose-b", "1",       "0",
           "0",         "0",        "1",       "0",
           "0",         "0",        "1",       "-1.7e308",
           "0",         "0"},
          "the difference of vertex 0 of A and vertex 6 of B is not finite");
  EXPECT_EQ(run_command({"minkowski", "gen:torus", "gen:box", "--hull"}, folder.path()).exit_code, 0);
}

}  // namespace
}  // namespace toccata
