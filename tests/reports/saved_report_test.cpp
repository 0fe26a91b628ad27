// A report says what was asked, and is read back with it; digests tell apart what files hold.
#include "toccata/reports/scene_question.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "io/text_file.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/reports/case_file.hpp"

namespace toccata {
namespace {

using test::message_of;
using test::TemporaryFolder;

SceneObject box_object() {
  SceneObject object;
  object.name = "box";
  object.shape = std::make_shared<const TriangleMesh>(generate_mesh("box"));
  return object;
}

std::string digest_of(const SceneObject& object) { return content_digest(std::array{object}, "m"); }

TEST(ContentDigest, TellsApartEverythingThatIsAskedAbout) {
  const SceneObject object = box_object();
  const std::string digest = digest_of(object);
  EXPECT_EQ(digest.size(), 16U);
  EXPECT_EQ(digest_of(box_object()), digest);
  SceneObject elsewhere = object;
  elsewhere.source = "another file";
  EXPECT_EQ(digest_of(elsewhere), digest);

  std::vector<SceneObject> others(6, object);
  others[0].name = "b";
  others[1].pose.offset.x = 5e-324;
  others[2].solid = Solid::none;
  others[3].group = "g";
  others[4].shape = Sphere(1);
  std::vector<Index> faces;  // of the same triangles, each a face of its own
  for (Index i = 0; i < object.mesh()->triangle_count(); ++i) faces.push_back(i);
  const auto vertices = object.mesh()->vertices();
  const auto triangles = object.mesh()->triangles();
  others[5].shape = std::make_shared<const TriangleMesh>(
      std::vector<Vec3>(vertices.begin(), vertices.end()),
      std::vector<std::array<Index, 3>>(triangles.begin(), triangles.end()), faces);
  for (const SceneObject& other : others) EXPECT_NE(digest_of(other), digest);
  EXPECT_NE(content_digest(std::array{object, object}, "m"), digest);
  EXPECT_NE(content_digest(std::array{object}, "mm"), digest);
}

/// Of a mesh with numbers that no decimal fraction is, shapes with an end and without, and names that are no UTF-8.
TEST(ObjectSummaries, MakeTheReportAndTheDigestWhereTheShapesAreNot) {
  Scene scene{{box_object(), box_object(), SceneObject{}, SceneObject{}}, {}, "mm"};
  scene.objects[1].pose = {rotation_about({1, 2, 3}, 30), {0.1, 1.0 / 3, -0.0}};
  scene.objects[1].solid = Solid::none;
  scene.objects[2].shape = HalfSpace({0, 0, 1}, {0, 0, 0.5});
  scene.objects[2].group = "frame";
  scene.objects[3].shape = Sphere(0.7);
  scene.objects[3].pose = Pose::translation(1, 0, 0);
  scene.objects[3].source = "a.json";
  const std::vector<SceneInstance> models = scene_models(scene);
  const std::vector<std::string> summaries = object_summaries(scene, models);

  Scene named{{4, SceneObject{}}, {}, "mm"};
  for (std::size_t i = 0; i < 4; ++i)
    named.objects[i].name = scene.objects[i].name = i == 2 ? "\xff" : "part " + std::to_string(i);
  const std::vector<std::string> warnings{"of something"};
  const CheckReport report = std::get<CheckReport>(ask(models, CheckQuestion{}));
  EXPECT_FALSE(report.pairs.empty());
  EXPECT_EQ(check_report_json(named, summaries, report, warnings), report_json(scene, models, report, warnings));
  EXPECT_EQ(content_digest(named.objects, summaries, "mm"), content_digest(scene.objects, "mm"));
}

Asked everything_asked() {
  Asked asked{.folder = "/somewhere", .files = {{"a.stl", "0123456789abcdef"}, {"gen:box", "fedcba9876543210"}}};
  asked.unit = "mm";
  asked.scale = 0.1;
  asked.pose_a = Pose::translation(0.1, -0.0, 5e-324);
  asked.pose_b = Pose::translation(1, 2, 3);
  asked.solid = Solid::none;
  asked.question = DistanceQuestion{1};
  return asked;
}

std::string report_of(const Asked& asked) {
  const Scene scene{{box_object()}, {}, "mm"};
  const std::vector<SceneInstance> models = scene_models(scene);
  return with_asked(report_json(scene, models, ask(models, DistanceQuestion{})), asked);
}

TEST(SavedReport, SaysWhatWasAskedToTheBit) {
  const TemporaryFolder folder;
  const Asked asked = everything_asked();
  const SavedReport saved = read_report(folder.write("report.json", report_of(asked)));
  EXPECT_EQ(saved.asked.folder, asked.folder);
  ASSERT_EQ(saved.asked.files.size(), 2U);
  EXPECT_EQ(saved.asked.files[0].name, "a.stl");
  EXPECT_EQ(saved.asked.files[1].digest, "fedcba9876543210");
  EXPECT_EQ(saved.asked.unit, "mm");
  EXPECT_EQ(saved.asked.scale, 0.1);
  EXPECT_EQ(saved.asked.pose_a->numbers(), asked.pose_a->numbers());
  EXPECT_TRUE(std::signbit(saved.asked.pose_a->offset.y));
  EXPECT_EQ(saved.asked.pose_b->numbers(), asked.pose_b->numbers());
  EXPECT_EQ(saved.asked.solid, Solid::none);
  EXPECT_EQ(std::get<DistanceQuestion>(saved.asked.question).first_objects, 1U);
  EXPECT_EQ(saved.sources, std::vector<std::string>{""});
  EXPECT_EQ(answer_difference(saved.answer, report_of({.folder = "/", .files = {{"b", "c"}}})), "");
}

TEST(SavedReport, WhatIsNoneIsRefused) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& text) {
    return message_of([&] { (void)read_report(folder.write("report.json", text)); });
  };
  const std::string whole = report_of(everything_asked());
  const std::string older = whole.substr(0, whole.find(",\n  \"asked\"")) + "\n}\n";
  EXPECT_NE(refusal(older).find("does not say what was asked"), std::string::npos) << refusal(older);
  EXPECT_NE(refusal("{\"schema\": 1}").find("no report of Toccata"), std::string::npos);
  EXPECT_NE(refusal("[]").find("no report of Toccata"), std::string::npos);
  const auto replaced = [&](const std::string& was, const std::string& is) {
    std::string text = whole;
    EXPECT_NE(text.find(was), std::string::npos) << was;
    return refusal(text.replace(text.find(was), was.size(), is));
  };
  EXPECT_NE(replaced("toccata/distance/1", "toccata/ray/1").find("/schema"), std::string::npos);
  EXPECT_NE(replaced("\"scale\":0.1", "\"scale\":0").find("/asked/scale"), std::string::npos);
  EXPECT_NE(replaced("\"solid\":\"none\"", "\"solid\":\"no\"").find("/asked/solid"), std::string::npos);
  EXPECT_NE(replaced("\"first_objects\"", "\"objects\"").find("/asked/query"), std::string::npos);
  EXPECT_NE(replaced("\"folder\"", "\"floder\"").find("floder"), std::string::npos);
  EXPECT_TRUE(is_report(folder.write("report.json", whole)));
  EXPECT_FALSE(is_report(folder.write("scene.json", "{\"format\": \"toccata-scene\"}")));
}

}  // namespace
}  // namespace toccata
