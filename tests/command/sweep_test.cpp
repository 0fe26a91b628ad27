// Something that moves and turns, past what stands, as a person or a script asks about it.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "support/base64.hpp"
#include "support/command.hpp"
#include "support/page.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

constexpr const char* key_scene = R"({"format": "toccata-scene", "version": 1, "objects": [
  {"name": "key", "shape": {"type": "box", "half_extents": [0.1, 1, 0.1]}}]})";
constexpr const char* others_scene = R"({"format": "toccata-scene", "version": 1, "objects": [
  {"name": "wall", "shape": {"type": "box", "half_extents": [1, 0.5, 1]}, "pose": {"translation": [0, 2, 0]}},
  {"name": "pin", "shape": {"type": "sphere", "radius": 0.25, "centre": [0.8, 0, 0]}}]})";

class SweepCommand : public testing::Test {
 protected:
  SweepCommand() {
    folder.write("key.json", key_scene);
    folder.write("others.json", others_scene);
  }
  TemporaryFolder folder;
};

TEST_F(SweepCommand, ToldFirstIsWhatIsMetFirst) {
  const auto run =
      run_command({"sweep", "key.json", "others.json", "--to", "axis=0,0,1 degrees=-90", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const Json report = Json::parse(run.out);
  EXPECT_EQ(report["schema"], "toccata/sweep/1");
  EXPECT_EQ(report["meeting"], 1);
  ASSERT_EQ(report["pairs"].size(), 2U);
  const Json& met = report["pairs"][0];
  EXPECT_EQ(met["b"], "pin");
  EXPECT_TRUE(met["hit"]);
  // The key's side is at 0.1 + 0.25 from the ball's centre: at an angle of acos(0.35 / 0.8) from it, of a quarter turn.
  const double exact = std::acos(0.35 / 0.8) / (std::numbers::pi / 2);
  EXPECT_LE(met["lower"].get<double>(), exact + 1e-12);
  EXPECT_GE(met["upper"].get<double>(), exact - 1e-12);
  EXPECT_NEAR(met["upper"].get<double>(), exact, 1e-9);
  EXPECT_FALSE(report["pairs"][1]["hit"]);
}

/// A node "hook" that an animation takes 5 m up, and a node "lamp" that rests unless `lamp_moves`.
std::string animated(const std::string& lamp_moves) {
  const float numbers[] = {0, 2, 0, 0, 0, 0, 0, 5};
  const std::string bytes(reinterpret_cast<const char*>(numbers), sizeof numbers);
  return R"({"asset": {"version": "2.0"}, "nodes": [{"name": "hook"}, {"name": "lamp"}], "animations": [{
    "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}})" +
         lamp_moves + R"(],
    "samplers": [{"input": 0, "output": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR"},
                  {"bufferView": 0, "byteOffset": 8, "componentType": 5126, "count": 2, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 32}],
    "buffers": [{"byteLength": 32, "uri": "data:;base64,)" +
         test::base64(bytes) + "\"}]}";
}

TEST_F(SweepCommand, AnAnimationOfAGltfFileIsAMotion) {
  folder.write("up.gltf", animated(""));
  folder.write("both.gltf", animated(R"(, {"sampler": 0, "target": {"node": 1, "path": "translation"}})"));
  // In metres: a box of 2 mm, of which the scene tells the unit, 1 m below a ball of 1 m.
  folder.write("box.json", R"({"format": "toccata-scene", "version": 1, "unit": "mm", "objects": [
    {"name": "box", "shape": {"type": "box", "half_extents": [1, 1, 1]}}]})");
  folder.write("ball.json", R"({"format": "toccata-scene", "version": 1, "unit": "mm", "objects": [
    {"name": "ball", "shape": {"type": "sphere", "radius": 500}, "pose": {"translation": [0, 0, 1501]}}]})");
  const auto run = run_command({"sweep", "box.json", "ball.json", "--motion", "up.gltf", "--json"}, folder.path());
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_NEAR(Json::parse(run.out)["pairs"][0]["upper"].get<double>(), 0.2, 1e-12);
  const auto several = run_command({"sweep", "box.json", "ball.json", "--motion", "both.gltf"}, folder.path());
  EXPECT_EQ(several.exit_code, 2);
  EXPECT_NE(several.err.find("name one of 'hook', 'lamp'"), std::string::npos) << several.err;
  const auto named =
      run_command({"sweep", "box.json", "ball.json", "--motion", "both.gltf", "--node", "lamp"}, folder.path());
  EXPECT_EQ(named.exit_code, 1) << named.err;
}

TEST_F(SweepCommand, FreeIsExitCodeZero) {
  const auto run = run_command({"sweep", "key.json", "others.json", "--to", "0 0 -9"}, folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("0 of 2 pairs meet on the way, decided exactly."), std::string::npos) << run.out;
}

TEST_F(SweepCommand, WhatIsApartAtBothEndsMayMeetInBetween) {
  const auto run = run_command({"sweep", "gen:box", "gen:icosphere", "--from", "9 0 0", "--to", "-9 0 0", "--json"});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const Json met = Json::parse(run.out)["pairs"][0];
  EXPECT_EQ(met["status"], "exact");
  EXPECT_NEAR(met["upper"].get<double>() * 18, 9 - 0.5 - 1, 0.1);
}

TEST_F(SweepCommand, AMotionFileGoesRoundACorner) {
  folder.write("around.txt", "0 0 0 0\n1 0 0 3\n2 4 0 3\n");
  folder.write("straight.txt", "0 0 0 0\n2 4 0 0\n");
  const auto around = run_command({"sweep", "gen:box", "gen:box", "--pose-b", "1", "0", "0", "0", "1", "0", "0", "0",
                                   "1", "2", "0", "0", "--motion", "around.txt"},
                                  folder.path());
  EXPECT_EQ(around.exit_code, 0) << around.out << around.err;
  const auto straight = run_command({"sweep", "gen:box", "gen:box", "--pose-b", "1", "0", "0", "0", "1", "0", "0", "0",
                                     "1", "2", "0", "0", "--motion", "straight.txt"},
                                    folder.path());
  EXPECT_EQ(straight.exit_code, 1) << straight.err;
}

TEST_F(SweepCommand, AScrewGoesThroughItsThread) {
  const auto run = run_command(
      {"sweep", "key.json", "others.json", "--to", "translation=0,0,-9 axis=0,0,1 degrees=90", "--screw", "--csv"},
      folder.path());
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.out.substr(0, run.out.find('\n')),
            "a,b,hit,status,lower,upper,x,y,z,normal_x,normal_y,normal_z,face_a,face_b");
}

TEST_F(SweepCommand, ACaseIsAskedAgain) {
  const auto saved =
      run_command({"sweep", "key.json", "others.json", "--to", "axis=0,0,1 degrees=-90", "--save-case", "case.json"},
                  folder.path());
  EXPECT_EQ(saved.exit_code, 1) << saved.err;
  const auto again = run_command({"replay", "case.json"}, folder.path());
  EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
}

TEST_F(SweepCommand, APageAndAnAnimationAreWritten) {
  const auto run = run_command(
      {"sweep", "key.json", "others.json", "--to", "axis=0,0,1 degrees=-90", "--html", "s.html", "--glb", "s.glb"},
      folder.path());
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_NE(test::page_text(folder.path() / "s.html").find("first contact"), std::string::npos);
  EXPECT_NE(test::page_text(folder.path() / "s.html").find("Swept volume"), std::string::npos);
  EXPECT_EQ(test::text_of(folder.path() / "s.glb").substr(0, 4), "glTF");
}

TEST_F(SweepCommand, ATurnOfMoreThanHalfACircleIsNotTakenTheOtherWay) {
  for (const char* to : {"axis=0,0,1 degrees=360", "axis=0,0,1 degrees=-270"}) {
    const auto run = run_command({"sweep", "key.json", "others.json", "--to", to}, folder.path());
    EXPECT_EQ(run.exit_code, 2) << to;
    EXPECT_NE(run.err.find("more than half a circle"), std::string::npos) << run.err;
  }
}

TEST_F(SweepCommand, WhatIsOfOneGroupIsNotAPairOnThePageEither) {
  folder.write("group.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "m1", "group": "g", "shape": {"type": "sphere", "radius": 1}},
    {"name": "m2", "group": "g", "shape": {"type": "sphere", "radius": 1}, "pose": {"translation": [4, 0, 0]}},
    {"name": "m3", "shape": {"type": "sphere", "radius": 1}, "pose": {"translation": [0, 9, 0]}}]})");
  const auto run = run_command({"sweep", "group.json", "--to", "8 0 0", "--html", "g.html"}, folder.path());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("0 of 1 pair meet"), std::string::npos) << run.out;
  EXPECT_NE(test::page_text(folder.path() / "g.html").find("1 pair,"), std::string::npos);
  EXPECT_EQ(test::page_text(folder.path() / "g.html").find("2 pairs,"), std::string::npos);
}

TEST_F(SweepCommand, ErrorsSayWhatToDo) {
  const auto error_of = [&](const std::vector<std::string>& words) {
    const auto run = run_command(words, folder.path());
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.out, "");
    return run.err;
  };
  EXPECT_NE(error_of({"sweep", "key.json", "others.json"}).find("no motion is given"), std::string::npos);
  EXPECT_NE(error_of({"sweep", "key.json", "--to", "1 0 0"}).find("name another file"), std::string::npos);
  EXPECT_NE(error_of({"sweep", "key.json", "others.json", "--to", "1 0"}).find("--to: the pose \"1 0\""),
            std::string::npos);
  EXPECT_NE(
      error_of({"sweep", "key.json", "others.json", "--to", "1 0 0", "--stop-before", "-1"}).find("--stop-before"),
      std::string::npos);
  EXPECT_NE(error_of({"sweep", "key.json", "others.json", "--to", "2 0 0 0 1 0 0 0 1 0 0 0"}).find("turn"),
            std::string::npos);
  EXPECT_NE(error_of({"sweep", "key.json", "others.json", "--motion", "none.txt"}).find("none.txt"), std::string::npos);
  EXPECT_NE(error_of({"sweep", "key.json", "others.json", "--motion", "x", "--to", "1 0 0"}).find("--motion"),
            std::string::npos);
}

}  // namespace
}  // namespace toccata
