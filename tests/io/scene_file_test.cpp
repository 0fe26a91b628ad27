#include "toccata/io/scene_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "support/error_message.hpp"
#include "support/temporary_folder.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

using test::message_of;

namespace fs = std::filesystem;

/// Every test has a folder of its own, gone afterwards.
class SceneFile : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "parts");
    write("parts/plate.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  [[nodiscard]] Scene read(const std::string& text, const ReadOptions& options = {}) const {
    write("scene.json", text);
    return read_scene(folder_ / "scene.json", options);
  }

  /// A scene with these members beside the format.
  [[nodiscard]] Scene read_members(const std::string& members) const {
    return read(R"({"format": "toccata-scene", "version": 1, )" + members + "}");
  }

  void expect_error(const std::string& members, const std::string& part) const {
    const std::string message = message_of([&] { (void)read_members(members); });
    EXPECT_NE(message.find(part), std::string::npos) << members << "\n" << message;
    EXPECT_NE(message.find("scene.json"), std::string::npos) << message;
  }

  test::TemporaryFolder folder_;
};

TEST_F(SceneFile, ObjectsWithFilesAndGenerators) {
  const Scene scene = read_members(R"("comment": "two", "objects": [
    {"name": "plate", "file": "parts/plate.obj", "solid": "none", "group": "g"},
    {"name": "plate again", "file": "parts/../parts/plate.obj"},
    {"name": "ball", "generate": "icosphere", "parameters": {"radius": 2, "subdivisions": 1}},
    {"name": "same ball", "generate": "icosphere", "parameters": {"subdivisions": 1, "radius": 2}}])");
  ASSERT_EQ(scene.objects.size(), 4U);
  EXPECT_EQ(scene.unit, "m");
  EXPECT_EQ(scene.objects[0].solid, Solid::none);
  EXPECT_EQ(scene.objects[0].group, "g");
  EXPECT_EQ(scene.objects[0].pose, Pose{});
  EXPECT_EQ(scene.objects[0].mesh(), scene.objects[1].mesh());
  EXPECT_EQ(scene.objects[2].mesh(), scene.objects[3].mesh());
  EXPECT_EQ(scene.objects[2].mesh()->triangle_count(), 80U);
  EXPECT_NE(scene.objects[2].source.find("icosphere"), std::string::npos);
}

TEST_F(SceneFile, PosesAndParentsAreComposedFromTheRoot) {
  const Scene scene = read_members(R"("unit": "mm",
    "frames": [{"name": "elbow", "parent": "shoulder", "pose": [1,0,0, 0,1,0, 0,0,1, 0.1,0,0]},
               {"name": "shoulder", "pose": {"translation": [1, 2, 3],
                "rotation": {"axis": [0, 0, 1], "degrees": 30}, "scale": 2}}],
    "objects": [{"name": "hand", "generate": "box", "parent": "elbow", "unit": "in",
                 "pose": {"rotation": {"quaternion": [0, 0, 1, 1]}, "scale": [1, 2, 3]}}])");
  const Pose shoulder = pose_of({1, 2, 3}, rotation_about({0, 0, 1}, 30), {2, 2, 2});
  const Pose elbow = Pose::translation(0.1, 0, 0);
  const Pose hand = pose_of({}, rotation_of({0, 0, 1, 1}), {1, 2, 3});
  ASSERT_EQ(scene.nodes.size(), 3U);
  EXPECT_EQ(scene.nodes[0].name, "shoulder");
  EXPECT_EQ(scene.nodes[1].parent, 0U);
  EXPECT_EQ(scene.objects[0].node, 2U);
  EXPECT_EQ(scene.objects[0].pose, scaled(shoulder * elbow * hand, 0.0254 / 0.001));
}

TEST_F(SceneFile, UnitsScaleTheShapeOnly) {
  const Scene scene = read_members(R"("unit": "m", "objects": [
    {"name": "a", "file": "parts/plate.obj", "unit": "mm", "pose": [1,0,0, 0,1,0, 0,0,1, 5,6,7]},
    {"name": "b", "file": "parts/plate.obj", "unit": 0.5},
    {"name": "c", "file": "parts/plate.obj"}])");
  EXPECT_EQ(scene.objects[0].pose.linear, scaled(Pose{}, 0.001).linear);
  EXPECT_EQ(scene.objects[0].pose.offset, (Vec3{5, 6, 7}));
  EXPECT_EQ(scene.objects[1].pose, scaled(Pose{}, 0.5));
  EXPECT_EQ(scene.objects[2].pose, Pose{});
}

TEST_F(SceneFile, ErrorsSayWhere) {
  expect_error(R"("objects": [])", "no objects");
  expect_error(R"("objekts": [])", "\"objekts\" is not known; did you mean 'objects'?");
  expect_error(R"("objects": [{"name": "a", "fil": "x"}])",
               "/objects/0: the key \"fil\" is not known; did you mean 'file'?");
  expect_error(R"("objects": [{"file": "parts/plate.obj"}])", "/objects/0: the key \"name\" is missing");
  expect_error(R"("objects": [{"name": "", "generate": "box"}])", "/objects/0/name: the name is empty");
  expect_error(R"("objects": [{"name": "a"}])", "needs one shape");
  expect_error(R"("objects": [{"name": "a", "generate": "box", "file": "x"}])", "needs one shape");
  expect_error(R"("objects": [{"name": "a", "file": "parts/plate.obj", "parameters": {}}])", "takes no parameters");
  expect_error(R"("objects": [{"name": "a", "generate": "box"}, {"name": "a", "generate": "box"}])",
               "/objects/1/name: the name 'a' is taken");
  expect_error(R"("objects": [{"name": "a", "generate": "box", "parent": "b"}])", "no frame or object named 'b'");
  expect_error(
      R"("objects": [{"name": "ab", "generate": "box", "parent": "cc"}, {"name": "cd", "generate": "box", "parent": "ab"}])",
      "did you mean 'cd'?");
  expect_error(R"("frames": [{"name": "p", "parent": "q"}, {"name": "q", "parent": "p"}],
                  "objects": [{"name": "a", "generate": "box"}])",
               "circle");
  expect_error(R"("objects": [{"name": "a", "file": "no.obj"}])", "no.obj: there is no such file");
  expect_error(R"("objects": [{"name": "a", "file": "scene.json"}])", "cannot hold another");
  expect_error(R"("objects": [{"name": "a", "generate": "bux"}])", "did you mean 'box'?");
  expect_error(R"("objects": [{"name": "a", "generate": "box", "parameters": {"half-w": 1}}])",
               "no parameter 'half-w'");
  expect_error(R"("objects": [{"name": "a", "generate": "box", "pose": [1, 2]}])",
               "/objects/0/pose: here are 2 numbers, not 12");
  expect_error(R"("objects": [{"name": "a", "generate": "box", "pose": {"translation": [1, 2, "3"]}}])",
               "/objects/0/pose/translation/2: this is not a number");
  expect_error(
      R"("objects": [{"name": "a", "generate": "box", "pose": {"rotation": {"axis": [0,0,0], "degrees": 1}}}])",
      "/objects/0/pose/rotation: a rotation's axis");
  expect_error(R"("objects": [{"name": "a", "generate": "box", "pose": {"rotation": {"axis": [0,0,1]}}}])",
               "the key \"degrees\" is missing");
  expect_error(R"("objects": [{"name": "a", "generate": "box", "pose": {"scale": 1e308}, "unit": 1e10}])",
               "not finite");
  expect_error(R"("objects": [{"name": "a", "generate": "box", "solid": "maybe"}])", "/objects/0/solid");
  expect_error(R"("objects": [{"name": "a", "generate": "box", "unit": "parsec"}])", "'parsec' is not a unit");
  expect_error(R"("objects": [{"name": "a", "generate": "box", "unit": -1}])", "must be positive");
  expect_error(R"("objects": [{"name": "a", "name": "b", "generate": "box"}])", "\"name\" appears twice");
  expect_error("\"unit\": NaN", ":1: this is not valid JSON");
  expect_error("\n\n\"unit\": 1e400", ":3: at /unit: the number \"1e400\" is too large for a double");
  expect_error(R"("objects": [{"generate": "box"}, {"pose": [1, -2e999], "name": "late"}])",
               ": at /objects/1/pose/1: the");
  expect_error("\n\n\"unit\": 1,, ", ":3: this is not valid JSON");
}

TEST_F(SceneFile, FormatAndVersionMustFit) {
  EXPECT_NE(message_of([&] { (void)read("[]"); }).find("not an object"), std::string::npos);
  EXPECT_NE(message_of([&] { (void)read("{}"); }).find("\"format\" is missing"), std::string::npos);
  EXPECT_NE(message_of([&] { (void)read(R"({"format": "toccata-scene", "version": 2})"); }).find("version"),
            std::string::npos);
  EXPECT_NE(message_of([&] { (void)read(""); }).find("empty"), std::string::npos);
  EXPECT_NE(message_of([&] { (void)read_scene(folder_ / "none.json"); }).find("no such file"), std::string::npos);
  EXPECT_THROW((void)read(R"({"format": "toccata-scene", "version": 1})", {.metres_per_unit = 1}), Error);
}

TEST_F(SceneFile, LongChainsAndManyNamesAreQuick) {
  std::string members = R"("objects": [)";
  for (int i = 0; i < 5000; ++i)
    members += R"({"generate": "box", "name": "o)" + std::to_string(i) + "\"" +
               (i + 1 < 5000 ? ", \"parent\": \"o" + std::to_string(i + 1) + "\"}," : std::string("}]"));
  EXPECT_EQ(read_members(members).objects.size(), 5000U);
}

// A quadratic reader would be noticed: it takes minutes.
TEST_F(SceneFile, ManyFramesAreRead) {
  std::string members = R"("objects": [{"generate": "box", "name": "o"}], "frames": [{"name": "f"})";
  for (int i = 0; i < 100000; ++i) members += R"(,{"name":"f)" + std::to_string(i) + "\"}";
  EXPECT_EQ(read_members(members + "]").nodes.size(), 100002U);
  expect_error(members + R"(,{"name": "g", "name": "h"}])", "the key \"name\" appears twice in one object");
}

TEST_F(SceneFile, FactorsThatLeaveNoShapeAreRefused) {
  const auto message = [&](const ReadOptions& options) {
    return message_of([&] { (void)read_scene(folder_ / "parts/plate.obj", options); });
  };
  for (const double factor : {1e-200, 1e-155, 1e200})
    EXPECT_NE(message({.metres_per_unit = factor, .scale = factor}).find("change the options unit or scale"),
              std::string::npos)
        << factor;
  EXPECT_EQ(message({.metres_per_unit = 1e-200, .scale = 1e200}), "");
  EXPECT_EQ(message({.metres_per_unit = 1e-150, .scale = 1e-150}), "");
  const std::string plate = R"("objects": [{"name": "p", "file": "parts/plate.obj", )";
  expect_error(R"("unit": 1e300, )" + plate + R"("unit": 1e-300}])", R"(at /objects/0: its "unit" of 1e-300 m over)");
  expect_error(R"("unit": 1e-300, )" + plate + R"("unit": 1e300}])",
               R"(over the "unit" of the scene, 1e-300 m, is inf)");
  expect_error(plate + R"("unit": 1e-200, "pose": {"scale": 1e-200}}])", R"(change "pose" or "unit")");
  write("tiny.json", R"({"format": "toccata-scene", "version": 1, )" + plate + R"("unit": 1e-200}]})");
  EXPECT_NE(message_of([&] { (void)read_scene(folder_ / "tiny.json", {.scale = 1e-200}); }).find("shrinks to nothing"),
            std::string::npos);
  EXPECT_EQ(read_members(plate + R"("unit": 1e-200, "pose": {"scale": 0}}])").objects.size(), 1U);
}

TEST_F(SceneFile, NamesAreUtf8) {
  std::set<std::string> names;
  for (const char* stem : {"inv\xff", "inv\xfe", "\xc3\xa4", "\xc3", "\xed\xa0\x80"}) {
    write(std::string("parts/") + stem + ".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    names.insert(read_scene(folder_ / (std::string("parts/") + stem + ".obj")).objects[0].name);
  }
  EXPECT_EQ(names, (std::set<std::string>{"inv\\xff", "inv\\xfe", "\xc3\xa4", "\\xc3", "\\xed\\xa0\\x80"}));
  Scene scene = gear_train();
  scene.objects[1].name = "gear\xff";
  const auto message = [&] { return message_of([&] { write_scene(scene, folder_ / "written"); }); };
  EXPECT_NE(message().find("the name of the object 'gear\\xff' is not UTF-8"), std::string::npos) << message();
  scene.objects[1].name = "gear";
  scene.objects[1].group = "\x80";
  EXPECT_NE(message().find("the group of the object 'gear' is not UTF-8"), std::string::npos) << message();
  EXPECT_FALSE(fs::exists(folder_ / "written"));
}

TEST_F(SceneFile, MeshFileIsAnObjectNamedAfterIt) {
  const Scene plain = read_scene(folder_ / "parts/plate.obj");
  ASSERT_EQ(plain.objects.size(), 1U);
  EXPECT_EQ(plain.objects[0].name, "plate");
  EXPECT_EQ(plain.objects[0].pose, Pose{});
  const Scene metres = read_scene(folder_ / "parts/plate.obj", {.metres_per_unit = 0.001, .scale = 2});
  EXPECT_EQ(metres.objects[0].pose, scaled(Pose{}, 0.002));
  EXPECT_EQ(metres.unit, "m");
  EXPECT_THROW((void)read_scene(folder_ / "parts/plate.obj", {.scale = -1}), Error);
  EXPECT_EQ(read_scene("gen:torus?sides=8").objects[0].name, "torus");
}

TEST_F(SceneFile, WrittenSceneIsReadBackTheSame) {
  for (Scene scene : {robot_arm(), shelf_of_parts(), interleaved_helices(1e-6, {1e-3, 1e6})}) {
    scene.objects[0].solid = Solid::all;
    scene.unit = "mm";
    const fs::path target = folder_ / "written";
    write_scene(scene, target);
    const Scene back = read_scene(target / "scene.json");
    ASSERT_EQ(back.objects.size(), scene.objects.size());
    EXPECT_EQ(back.unit, "mm");
    std::set<const TriangleMesh*> before, after;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const SceneObject &a = scene.objects[i], &b = back.objects[i];
      EXPECT_EQ(a.name, b.name);
      EXPECT_EQ(a.pose, b.pose);
      EXPECT_EQ(a.solid, b.solid);
      EXPECT_EQ(a.group, b.group);
      EXPECT_TRUE(std::ranges::equal(a.mesh()->vertices(), b.mesh()->vertices())) << a.name;
      EXPECT_TRUE(std::ranges::equal(a.mesh()->triangles(), b.mesh()->triangles())) << a.name;
      before.insert(a.mesh().get());
      after.insert(b.mesh().get());
    }
    EXPECT_EQ(before.size(), after.size());
    fs::remove_all(target);
  }
}

/// One of every type, and one within another.
constexpr const char* every_shape = R"("objects": [
    {"name": "point", "shape": {"type": "point", "position": [1, 2, 3]}},
    {"name": "segment", "shape": {"type": "segment", "start": [0, 0, 0], "end": [1, 0, 0]}},
    {"name": "triangle", "shape": {"type": "triangle", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}},
    {"name": "floor", "shape": {"type": "half-space", "normal": [0, 0, 2]}},
    {"name": "ball", "shape": {"type": "sphere", "radius": 0.1, "centre": [0.1, 0.2, 0.3]}},
    {"name": "box", "shape": {"type": "box", "half_extents": [1, 2, 3]}},
    {"name": "capsule", "shape": {"type": "capsule", "start": [0, 0, 0], "end": [0, 0, 1], "radius": 0.3}},
    {"name": "hull", "shape": {"type": "convex-hull", "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}},
    {"name": "of file", "shape": {"type": "convex-hull", "file": "parts/plate.obj"}},
    {"name": "rounded", "shape": {"type": "rounded", "core": {"type": "box", "half_extents": [1, 1, 1]}, "radius": 0.7}},
    {"name": "drum", "shape": {"type": "cylinder", "radius": 0.5, "half_height": 0.25}},
    {"name": "tip", "shape": {"type": "cone", "radius": 0.1, "half_height": 3}},
    {"name": "egg", "shape": {"type": "ellipsoid", "half_axes": [1, 0.1, 3]}},
    {"name": "ground", "shape": {"type": "height-field", "columns": 2, "rows": 3, "spacing": [0.1, 3],
                                 "heights": [0, 1, 2, 3, 4, 5]}},
    {"name": "several", "shape": {"type": "compound", "parts": [
        {"shape": {"type": "sphere", "radius": 2}, "pose": [1, 0, 0, 0, 1, 0, 0, 0, 1, 5, 6, 7]},
        {"file": "parts/plate.obj"}]}}])";

TEST_F(SceneFile, EveryShapeIsReadWrittenAndReadBackTheSame) {
  const Scene scene = read_members(every_shape);
  ASSERT_EQ(scene.objects.size(), std::variant_size_v<Shape>);
  EXPECT_EQ(std::get<Point>(scene.objects[0].shape).position(), (Vec3{1, 2, 3}));
  EXPECT_EQ(std::get<HalfSpace>(scene.objects[3].shape).normal(), (Vec3{0, 0, 2}));
  EXPECT_EQ(std::get<Sphere>(scene.objects[4].shape).radius(), 0.1);
  EXPECT_EQ(std::get<Box>(scene.objects[5].shape).half_extents(), (Vec3{1, 2, 3}));
  EXPECT_EQ(std::get<ConvexHull>(scene.objects[8].shape).vertex_count(), 3U);
  EXPECT_EQ(std::get<Rounded>(scene.objects[9].shape).radius(), 0.7);
  EXPECT_EQ(std::get<Cylinder>(scene.objects[10].shape).half_height(), 0.25);
  EXPECT_EQ(std::get<Cone>(scene.objects[11].shape).radius(), 0.1);
  EXPECT_EQ(std::get<Ellipsoid>(scene.objects[12].shape).half_axes(), (Vec3{1, 0.1, 3}));
  EXPECT_EQ(std::get<HeightField>(scene.objects[13].shape).vertex(1, 2), (Vec3{0.1, 6, 5}));
  const auto parts = std::get<Compound>(scene.objects[14].shape).parts();
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].pose, Pose::translation(5, 6, 7));
  EXPECT_EQ(mesh_of(parts[1].shape)->triangle_count(), 1U);

  write_scene(scene, folder_ / "first");
  write_scene(read_scene(folder_ / "first" / "scene.json"), folder_ / "second");
  const auto text_of = [this](const char* folder) {
    std::ifstream file(folder_ / folder / "scene.json");
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_EQ(text_of("first"), text_of("second"));
  EXPECT_NE(text_of("first").find("height-field"), std::string::npos);
}

TEST_F(SceneFile, UnitsAndUniformScalesGoIntoTheNumbersOfWhatMustKeepItsForm) {
  const Scene scene = read_members(R"("unit": "m",
    "frames": [{"name": "arm", "pose": {"translation": [1, 0, 0], "scale": 2,
                                        "rotation": {"axis": [0, 0, 1], "degrees": 90}}}],
    "objects": [
    {"name": "ball", "parent": "arm", "unit": "mm", "pose": {"translation": [0, 3, 0], "scale": 4},
     "shape": {"type": "sphere", "radius": 1000, "centre": [1000, 0, 0]}},
    {"name": "box", "parent": "arm", "unit": "mm", "shape": {"type": "box", "half_extents": [1000, 1000, 1000]}},
    {"name": "both", "unit": "mm", "shape": {"type": "compound", "parts": [
        {"shape": {"type": "sphere", "radius": 1000}, "pose": {"translation": [500, 0, 0], "scale": 3}},
        {"shape": {"type": "box", "half_extents": [1, 1, 1]}, "pose": {"scale": 5}}]}}])");
  const Mat3 turned = rotation_about({0, 0, 1}, 90);
  const Sphere ball = std::get<Sphere>(scene.objects[0].shape);
  EXPECT_EQ(ball.radius(), 8);
  EXPECT_EQ(ball.centre(), (Vec3{8, 0, 0}));
  EXPECT_EQ(scene.objects[0].pose, (Pose{turned, {-5, 0, 0}}));
  EXPECT_EQ(std::get<Box>(scene.objects[1].shape).half_extents(), (Vec3{1000, 1000, 1000}));
  EXPECT_EQ(scene.objects[1].pose, (Pose{scaled({turned, {}}, 2 * 0.001).linear, {1, 0, 0}}));
  const auto parts = std::get<Compound>(scene.objects[2].shape).parts();
  EXPECT_EQ(std::get<Sphere>(parts[0].shape).radius(), 3);
  EXPECT_EQ(parts[0].pose, Pose::translation(0.5, 0, 0));
  EXPECT_EQ(parts[1].pose.linear, scaled(Pose{}, 5 * 0.001).linear);
  EXPECT_EQ(scene.objects[2].pose, Pose{});

  write("ball.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "ball", "pose": {"translation": [1, 0, 0]}, "shape": {"type": "sphere", "radius": 1}}]})");
  const Scene larger = read_scene(folder_ / "ball.json", {.scale = 3});
  EXPECT_EQ(std::get<Sphere>(larger.objects[0].shape).radius(), 3);
  EXPECT_EQ(larger.objects[0].pose, Pose::translation(3, 0, 0));
}

TEST_F(SceneFile, WrongShapesAreSaidWhere) {
  const auto expect = [this](const std::string& shape, const std::string& part) {
    expect_error(R"("objects": [{"name": "a", "shape": )" + shape + "}]", part);
  };
  expect(R"({"type": "spere", "radius": 1})", "did you mean 'sphere'?");
  expect(R"({"type": "sphere", "radius": 0})", "/objects/0/shape");
  expect(R"({"type": "sphere", "radius": -2})", "the radius of a sphere is -2; give a positive finite number");
  expect(R"({"type": "sphere", "radius": 1e999})",
         "at /objects/0/shape/radius of \"a\": the number \"1e999\" is too large for a double; write numbers below");
  expect(R"({"type": "sphere", "radius": NaN})", "not valid JSON");
  expect(R"({"type": "capsule", "start": [0, 0, 0], "end": [1, 0, 0], "radius": 0})", "the radius of a capsule is 0");
  expect(R"({"type": "cylinder", "radius": 0, "half_height": 1})", "the radius of a cylinder is 0; give a positive");
  expect(R"({"type": "cylinder", "radius": 1, "height": 1})", "height");
  expect(R"({"type": "cone", "radius": 1, "half_height": -1})", "the half height of a cone is -1; give a positive");
  expect(R"({"type": "ellipsoid", "half_axes": [1, 0, 1]})", "the half axis along y of an ellipsoid is 0");
  expect(R"({"type": "rounded", "core": {"type": "cone", "radius": 1, "half_height": 1}, "radius": 1})",
         "a cone cannot be the core");
  expect(R"({"type": "rounded", "core": {"type": "point"}, "radius": -1})", "the radius of a rounded shape is -1");
  expect(R"({"type": "convex-hull", "file": "parts/none.obj"})", "/objects/0/shape/file");
  expect(R"({"type": "sphere"})", "radius");
  expect(R"({"type": "box", "half_extents": [1, -1, 1]})", "/objects/0/shape");
  expect(R"({"type": "triangle", "vertices": [[0, 0, 0]]})", "three vertices");
  expect(R"({"type": "half-space", "normal": [0, 0, 0]})", "/objects/0/shape");
  expect(R"({"type": "convex-hull", "points": []})", "/objects/0/shape");
  expect(R"({"type": "convex-hull"})", "\"points\" or \"file\"");
  expect(R"({"type": "rounded", "core": {"type": "sphere", "radius": 1}, "radius": 1})", "cannot be the core");
  expect(R"({"type": "height-field", "columns": 2, "rows": 2, "spacing": [1, 1], "heights": [0]})", "/objects/0/shape");
  expect(R"({"type": "compound", "parts": []})", "/objects/0/shape");
  std::string deep = R"({"type": "point"})";
  for (int i = 0; i < 40; ++i) deep.insert(0, R"({"type": "compound", "parts": [{"shape": )").append("}]}");
  expect(deep, "more than 32 deep");
  expect_error(R"("objects": [{"name": "a", "file": "parts/plate.obj", "shape": {"type": "point"}}])", "one shape");
}

TEST_F(SceneFile, WritingDoesNotTouchWhatIsThere) {
  EXPECT_NE(message_of([&] { write_scene(gear_train(), folder_.path()); }).find("something already"),
            std::string::npos);
  Scene twins = gear_train();
  twins.objects[1].name = twins.objects[0].name;
  EXPECT_THROW(write_scene(twins, folder_ / "twins"), Error);
  EXPECT_FALSE(fs::exists(folder_ / "twins"));
  write("blocked", "");
  EXPECT_THROW(write_scene(gear_train(), folder_ / "blocked" / "below"), Error);
  fs::create_directories(folder_ / "empty");
  write_scene(gear_train(), folder_ / "empty");
  EXPECT_TRUE(fs::exists(folder_ / "empty" / "scene.json"));
}

TEST(ScaleWarnings, NameTheObjectThatIsOff) {
  const Scene gears = gear_train();
  EXPECT_TRUE(scale_warnings(gears).empty());
  Scene scene = gears;
  scene.objects[2].pose = scaled(scene.objects[2].pose, 1e-6);
  const std::vector<std::string> warnings = scale_warnings(scene);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("'misassembled gear'"), std::string::npos);
  scene.objects.erase(scene.objects.begin());
  EXPECT_EQ(scale_warnings(scene).size(), 1U);
}

TEST(ScaleWarnings, TellWhatIsAbsurdlyLargeOrSmallAllTogether) {
  Scene scene = gear_train();
  const auto warning_at = [&](double scale, const std::string& unit) {
    Scene scaled_scene = scene;
    scaled_scene.unit = unit;
    for (SceneObject& object : scaled_scene.objects) object.pose = scaled(Pose{}, scale) * object.pose;
    const std::vector<std::string> warnings = scale_warnings(scaled_scene);
    return warnings.empty() ? "" : warnings[0];
  };
  EXPECT_EQ(warning_at(1, "m"), "");
  EXPECT_EQ(warning_at(1, "mm"), "");
  EXPECT_NE(warning_at(1000, "m").find(" km across"), std::string::npos) << warning_at(1000, "m");
  EXPECT_EQ(warning_at(1000, "mm"), "");
  EXPECT_EQ(warning_at(1e6, "unit"), "") << "nobody knows what it is";
  EXPECT_EQ(warning_at(1e6, "furlong"), "");
  EXPECT_NE(warning_at(1000, "1 m").find("--unit"), std::string::npos);
  EXPECT_NE(warning_at(1e-6, "m").find(" mm across"), std::string::npos) << warning_at(1e-6, "m");
}

TEST(Units, HaveTheirMetres) {
  EXPECT_EQ(metres_per_unit("mm"), 0.001);
  EXPECT_EQ(metres_per_unit("in"), 0.0254);
  EXPECT_EQ(metres_per_unit("0.25"), 0.25);
  for (const char* wrong : {"", "MM", "0", "-1", "1m", "1e400", "nan"})
    EXPECT_THROW((void)metres_per_unit(wrong), Error) << wrong;
}

}  // namespace
}  // namespace toccata
