// Walks that are recorded: asked of a scene, and by a program that walks a character itself.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/command.hpp"
#include "support/error_message.hpp"
#include "support/page.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/scene_index.hpp"
#include "toccata/reports/case_file.hpp"
#include "toccata/reports/pages.hpp"

namespace toccata {
namespace {

using Json = nlohmann::json;

/// A floor of two triangles, and a box upon it.
Scene walk_scene() {
  const auto floor =
      std::make_shared<const TriangleMesh>(std::vector<Vec3>{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}},
                                           std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 2, 3}});
  Scene scene;
  scene.objects.resize(2);
  scene.objects[0].name = "floor";
  scene.objects[0].shape = floor;
  scene.objects[1].name = "block";
  scene.objects[1].shape = Box({1, 1, 1});
  scene.objects[1].pose = Pose::translation(3, 0, 1);
  return scene;
}

WalkReport walked(const Scene& scene, const WalkQuestion& question) {
  return std::get<WalkReport>(ask(scene_models(scene), question));
}

WalkQuestion walk_to(const Vec3& to) {
  WalkQuestion question;
  question.to = to;
  return question;
}

std::string walk_error(const WalkQuestion& question) {
  try {
    (void)walked(walk_scene(), question);
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(Walk, EveryStepIsOneOfTheMover) {
  const Scene scene = walk_scene();
  const std::vector<SceneInstance> models = scene_models(scene);
  const SceneIndex level(models);
  const WalkReport report = walked(scene, walk_to({4, 1, 0}));
  ASSERT_GT(report.steps.size(), 10U);
  MoverState<Index> state{Pose::translation(0, 0, 0), {}};
  for (const WalkedStep& step : report.steps) {
    const MoverStep<Index> again = move_character(level, Model(report.question.walker), state, step.motion);
    ASSERT_EQ(again, step.step);
    state = again.state;
  }
}

TEST(Walk, ItSaysHowItEnds) {
  const Scene scene = walk_scene();
  EXPECT_EQ(walked(scene, walk_to({-3, 2, 0})).end, WalkOutcome::arrived);
  EXPECT_EQ(walked(scene, walk_to({4.5, 0, 0})).end, WalkOutcome::hindered);
  EXPECT_EQ(walked(scene, walk_to({-3, 2, 2})).end, WalkOutcome::hindered);  // it stands below the place
  EXPECT_EQ(walked(scene, walk_to({-30, 0, 0})).end, WalkOutcome::fallen);
  WalkQuestion question = walk_to({-3, 2, 0});
  question.most_steps = 3;
  EXPECT_EQ(walked(scene, question).end, WalkOutcome::unfinished);
  EXPECT_EQ(walked(scene, question).steps.size(), 3U);
  question.motions = {{0, 0, -1}, {1, 0, 0}};
  question.fall = 0;
  const WalkReport done = walked(scene, question);
  EXPECT_EQ(done.end, WalkOutcome::done);
  EXPECT_NEAR(place_after(done, 2).x, 1, 1e-9);
  EXPECT_EQ(place_after(done, 0), Vec3{});
}

TEST(Walk, InTheAirItFallsFasterFromStepToStep) {
  WalkQuestion question = walk_to({0, 0, 0});
  question.from = {0, 0, 3};
  const WalkReport report = walked(walk_scene(), question);
  EXPECT_EQ(report.end, WalkOutcome::arrived);
  ASSERT_GT(report.steps.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_NEAR(report.steps[i].motion.z, -0.01 * static_cast<double>(i + 1), 1e-12) << i;
}

TEST(Walk, ACaseKeepsItToTheBit) {
  WalkQuestion to_a_place = walk_to({4, 1, 0});
  to_a_place.walker = Box({0.3, 0.3, 0.8});
  to_a_place.from = {0.1, 0.2, 0.9};
  to_a_place.options.up = {0, 0, 3};
  to_a_place.options.max_slope_degrees = 30;
  WalkQuestion by_motions;
  by_motions.motions = {{0, 0, -0.1}, {0.1, 0.3, 0}, {5, 0, 0}};
  const Scene scene = walk_scene();
  const std::vector<SceneInstance> models = scene_models(scene);
  for (const WalkQuestion& question : {to_a_place, by_motions}) {
    const SceneAnswer answer = ask(models, question);
    const std::string report = report_json(scene, models, answer);
    const test::TemporaryFolder folder;
    write_case({scene, question, report}, folder.path() / "walk.json");
    EXPECT_EQ(replay(read_case(folder.path() / "walk.json"), {1, {}}).difference, "");
  }
}

TEST(Walk, AProgramThatWalksACharacterItselfRecordsItsSteps) {
  const Scene scene = walk_scene();
  const std::vector<SceneInstance> models = scene_models(scene);
  const SceneIndex level(models);
  WalkReport report;
  report.question.from = {0, 0, 0.01};
  MoverState<Index> state{Pose::translation(0, 0, 0.01), {}};
  for (int i = 0; i < 30; ++i) {
    const Vec3 motion{0.1, 0, state.ground ? 0 : -0.05};
    report.steps.push_back({motion, move_character(level, Model(report.question.walker), state, motion)});
    report.question.motions.push_back(motion);
    state = report.steps.back().step.state;
  }
  const Json json = Json::parse(report_json(scene, models, SceneAnswer(report)));
  EXPECT_EQ(json["steps"].size(), 30U);
  EXPECT_EQ(json["steps"][29]["ground"]["object"], "floor");
  EXPECT_EQ(json["steps"][29]["contacts"][0]["object"], "block");
  EXPECT_TRUE(json["steps"][29]["met_wall"]);

  const WorldRecording recording = record_walk(models, report);
  ASSERT_EQ(recording.frames().size(), 31U);
  ASSERT_EQ(recording.paths().size(), 1U);
  ASSERT_EQ(recording.paths()[0].points.size(), 31U);
  for (std::size_t i = 0; i <= 30; ++i) EXPECT_EQ(recording.paths()[0].points[i], place_after(report, i));
  const auto& last = report.steps.back().step;
  ASSERT_EQ(recording.frames()[30].touched.size(), 1 + last.contacts.size());
  EXPECT_EQ(recording.frames()[30].touched[0].point, last.state.ground->point);
  EXPECT_EQ(recording.frames()[30].touched[1].normal, last.contacts[0].normal);
  EXPECT_EQ(recording.frames()[30].label, "step 30: on floor, meets block");
  EXPECT_EQ(recording.frames()[30].pairs.size(), 2U);  // with the floor, and with the block
  EXPECT_EQ(recording.objects()[2].name, "walker");
  EXPECT_NE(test::Page(world_page(recording)).header.dump().find("\"Path\""), std::string::npos);
  EXPECT_NE(recording_glb(recording).find("\"paths\""), std::string::npos);
}

TEST(Walk, OfALongWalkAPageShowsSomeStepsAndTheWholePath) {
  WalkReport report;
  for (int i = 1; i <= 2500; ++i) {
    WalkedStep step{{0.001, 0, 0}, {}};
    step.step.state.pose = Pose::translation(0.001 * i, 0, 5);
    report.steps.push_back(step);
  }
  const Scene scene = walk_scene();
  const WorldRecording recording = record_walk(scene_models(scene), report);
  EXPECT_EQ(recording.paths()[0].points.size(), 2501U);
  EXPECT_LE(recording.frames().size(), 1300U);
  EXPECT_EQ(recording.frames().back().label, "step 2500: in the air");
}

TEST(Walk, ShowsEveryStepOfTwoThousandAndTellsWhatWentWrong) {
  WalkReport report;
  for (int i = 1; i <= 2001; ++i) {
    WalkedStep step{{0.001, 0, 0}, {}};
    step.step.state.pose = Pose::translation(0.001 * i, 0, 5);
    step.step.tight = step.step.stuck = step.step.crushed = step.step.cut_short = i == 2000;
    report.steps.push_back(step);
  }
  const Scene scene = walk_scene();
  const std::vector<SceneInstance> models = scene_models(scene);
  EXPECT_EQ(record_walk(models, report).frames().size(), 1002U);
  report.steps.pop_back();
  const WorldRecording recording = record_walk(models, report);
  ASSERT_EQ(recording.frames().size(), 2001U);
  EXPECT_EQ(recording.frames().back().label, "step 2000: in the air, nearer than its skin, stuck, crushed, cut short");
  const Json steps = Json::parse(report_json(scene, models, SceneAnswer(report)))["steps"];
  EXPECT_FALSE(steps[1998]["cut_short"]);
  EXPECT_TRUE(steps[1999]["cut_short"]);
  const std::string csv = report_csv(scene, SceneAnswer(report));
  EXPECT_TRUE(csv.ends_with(",0,0,0,1,1,1,1\n")) << csv.substr(csv.size() - 60);
}

TEST(Walk, BadQuestionsAreRefused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  WalkQuestion question = walk_to({1, 0, 0});
  question.stride = 0;
  EXPECT_EQ(walk_error(question), "a walk: its stride is 0; it has to be a length above 0");
  question = walk_to({1, 0, 0});
  question.fall = -1;
  EXPECT_EQ(walk_error(question), "a walk: its fall is -1; it has to be a length of 0 or more");
  EXPECT_NE(walk_error(walk_to({nan, 0, 0})).find("not finite"), std::string::npos);
  question = walk_to({1, 0, 0});
  question.walker = walk_scene().objects[0].shape;
  EXPECT_NE(walk_error(question).find("has to be one bounded convex shape"), std::string::npos);
  question = walk_to({1, 0, 0});
  question.options.up = {};
  EXPECT_NE(walk_error(question).find("`up` has no direction"), std::string::npos);
}

}  // namespace
}  // namespace toccata
