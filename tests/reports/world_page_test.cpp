// The page of a World: where its bodies are at each step, and the pairs that it found.
#include "toccata/reports/pages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "support/page.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

using Json = nlohmann::json;

/// A ball that comes to a turning box, touches it, and goes; and a body that is taken away.
struct Intersection {
  World world{{.distance = true, .manifold = true}};
  BodyId ball, box, third;
  WorldRecording recording;

  Intersection() {
    ball = world.add(Body{Sphere(1), Pose::translation(0, 0, 5)});
    Body named{Box({2, 2, 1})};
    named.name = "</script>";
    box = world.add(named);
    third = world.add(Body{Sphere(0.5), Pose::translation(9, 0, 0)});
    for (const double height : {5.0, 1.75, 1.5, 4.0}) step(height);
  }
  void step(double height) {
    world.move(ball, Pose::translation(0, 0, height));
    if (!recording.frames().empty()) world.move(box, {rotation_about({0, 0, 1}, 10 * height), {}});
    if (recording.frames().size() == 2) world.remove(third);
    world.step();
    recording.add(world);
  }
};

TEST(WorldPage, TellsThePairsOfEveryStep) {
  const Intersection intersection;
  const test::Page page(world_page(intersection.recording, {.title = "meeting"}));
  EXPECT_EQ(page.header["summary"], "3 bodies · 4 steps");
  EXPECT_EQ(page.header["time"]["moments"][1]["note"], "1 pair, 1 begin, 0 persist; 0 end");
  EXPECT_EQ(page.report["schema"], "toccata/world/2");
  EXPECT_EQ(page.report["objects"][1]["name"], "</script>");
  const Json& steps = page.report["steps"];
  ASSERT_EQ(steps.size(), 4U);
  const char* changes[] = {"", "begin", "persist", "end"};
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_EQ(steps[i]["pairs"].size(), i == 0 ? 0U : 1U);
    if (i == 0) continue;
    const Json& pair = steps[i]["pairs"][0];
    EXPECT_EQ(pair["change"], changes[i]);
    EXPECT_EQ(pair["a_index"], 0);
    EXPECT_EQ(pair["b_index"], 1);
    EXPECT_EQ(pair["distance"]["upper"], 0);
    EXPECT_EQ(pair["points"], 1);  // of what has ended as it was
  }
  for (const Json& layer : page.header["layers"]) {
    if (layer["role"] == "contact") {
      EXPECT_EQ(layer["moments"], Json({{0, 0}, {0, 1}, {1, 1}, {2, 0}}));
    }
    const std::size_t at = layer["role"] == "begin"     ? 1
                           : layer["role"] == "persist" ? 2
                           : layer["role"] == "end"     ? 3
                                                        : 9;
    if (at == 9) continue;
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(layer["moments"][i][1], i == at ? 1 : 0) << layer["role"];
  }
}

TEST(WorldPage, PutsBodiesWhereTheyAre) {
  const Intersection intersection;
  const test::Page page(world_page(intersection.recording));
  const Json& motion = page.header["motion"];
  const auto objects = page.numbers<std::uint32_t>(motion["objects"]);
  const auto places = page.numbers<float>(motion["places"]);
  const auto turns = page.numbers<std::int16_t>(motion["turns"]);
  const double size = page.header["frame"]["size"].get<double>(),
               centre = page.header["frame"]["centre"][2].get<double>();
  const double heights[] = {5.0, 1.75, 1.5, 4.0};
  // All at first, then what moves; the third is told gone.
  const std::size_t counts[] = {3, 2, 3, 2};
  for (std::size_t moment = 0; moment < 4; ++moment) {
    const auto first = motion["moments"][moment][0].get<std::size_t>();
    ASSERT_EQ(motion["moments"][moment][1], counts[moment]);
    EXPECT_EQ(objects[first], 0U);
    EXPECT_NEAR(places[3 * first + 2] * size + centre, heights[moment], 1e-5);
    const std::size_t box = first + 1;
    ASSERT_EQ(objects[box], 1U);
    const double angle = moment == 0 ? 0 : 10 * heights[moment] * std::acos(-1.0) / 180;
    EXPECT_NEAR(turns[4 * box + 2] / 32767.0, std::sin(angle / 2), 1e-4);
    EXPECT_NEAR(turns[4 * box + 3] / 32767.0, std::cos(angle / 2), 1e-4);
    if (moment != 2) continue;
    EXPECT_EQ(objects[first + 2], 2U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(turns[4 * (first + 2) + i], 0);
  }
}

TEST(WorldPage, ASurfaceIsThereAtAllMoments) {
  Intersection intersection;
  intersection.recording.add(
      WorldRecording::Surface{"Swept volume", {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 1}, {4, 0, 1}, {0, 4, 1}}});
  const test::Page page(world_page(intersection.recording));
  const Json& layer = page.header["layers"].back();
  EXPECT_EQ(layer["kind"], "triangles");
  EXPECT_EQ(layer["name"], "Swept volume");
  EXPECT_EQ(layer["moments"], Json({{0, 2}, {0, 2}, {0, 2}, {0, 2}}));
  const auto numbers = page.numbers<float>(layer["data"]);
  ASSERT_EQ(numbers.size(), 18U);
  const double size = page.header["frame"]["size"].get<double>();
  EXPECT_NEAR((numbers[3] - numbers[0]) * size, 4, 1e-5);
  EXPECT_NE(recording_glb(intersection.recording).find("Swept volume"), std::string::npos);
}

TEST(WorldPage, RefusesWhatItCannotShow) {
  EXPECT_THROW(static_cast<void>(world_page(WorldRecording())), Error);
  World world;
  Body body{Box({1, 1, 1})};
  body.name = "crate";
  const BodyId crate = world.add(body);
  WorldRecording recording;
  world.step();
  recording.add(world);
  Pose stretched;
  stretched.linear = pose_of({}, {}, {2, 1, 1}).linear;
  world.move(crate, stretched);
  world.step();
  recording.add(world);
  try {
    static_cast<void>(world_page(recording));
    FAIL() << "a stretched box has no turn";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("body 0 (\"crate\") is stretched"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace toccata
