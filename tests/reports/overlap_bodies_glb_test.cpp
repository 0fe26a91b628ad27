// GLB files of what solids have in common: read back by our own reader, closed, in metres, and of the volume that is
// proved but for the rounding that the file tells of.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/command.hpp"
#include "support/temporary_folder.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/io/scene_file.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/reports/pages.hpp"

namespace toccata {
namespace {

using BodiesJson = nlohmann::json;

OverlapBodiesGlb bodies_of(const Scene& scene, const AskOptions& options = {}, const ViewOptions& view = {}) {
  const std::vector<SceneInstance> models = scene_models(scene);
  return overlap_bodies_glb(scene, models, make_check_report(models, check_all(models)), view, options);
}

Scene bodies_read_back(const OverlapBodiesGlb& bodies) {
  const test::TemporaryFolder folder;
  bodies.write(folder.path() / "bodies.glb");
  return read_scene(folder.path() / "bodies.glb");
}

std::string bytes_of(const OverlapBodiesGlb& bodies) {
  const test::TemporaryFolder folder;
  bodies.write(folder.path() / "bodies.glb");
  return test::text_of(folder.path() / "bodies.glb");
}

/// The properties of the nodes that have some, by the node's name.
std::map<std::string, BodiesJson> properties_in(const OverlapBodiesGlb& bodies) {
  const std::string bytes = bytes_of(bodies);
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + 12, 4);
  std::map<std::string, BodiesJson> found;
  const BodiesJson top = BodiesJson::parse(bytes.substr(20, size));
  for (const BodiesJson& node : top["nodes"])
    if (node.contains("extras")) found[node["name"].get<std::string>()] = node["extras"];
  return found;
}

struct ReadBody {
  double volume = 0;  ///< in cubed metres
  double area = 0;
  bool is_closed = false;
};

ReadBody look_at(const SceneObject& object) {
  using Corner = std::array<double, 3>;
  ReadBody body;
  std::map<std::pair<Corner, Corner>, int> edges;
  const TriangleMesh& mesh = *object.mesh();
  const Vec3 origin = transform(object.pose, mesh.vertices()[0]);
  for (const auto& t : mesh.triangles()) {
    std::array<Vec3, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) p[i] = transform(object.pose, mesh.vertices()[t[i]]) - origin;
    const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
    body.volume += dot(p[0], cross(p[1], p[2])) / 6;
    body.area += std::sqrt(dot(normal, normal)) / 2;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &from = mesh.vertices()[t[i]], &to = mesh.vertices()[t[(i + 1) % 3]];
      const Corner a{from.x, from.y, from.z}, b{to.x, to.y, to.z};
      ++edges[{a, b}];
      --edges[{b, a}];
    }
  }
  body.is_closed = std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
  return body;
}

/// Looks at each body that is there, and returns how many.
std::size_t expect_sound_bodies(const OverlapBodiesGlb& bodies, double metres) {
  const std::map<std::string, BodiesJson> properties = properties_in(bodies);
  const Scene read = bodies_read_back(bodies);
  for (const SceneObject& object : read.objects) {
    SCOPED_TRACE(object.name);
    const BodiesJson& told = properties.at(object.name);
    EXPECT_EQ(object.name, told["a"].get<std::string>() + " × " + told["b"].get<std::string>());
    const ReadBody body = look_at(object);
    EXPECT_TRUE(body.is_closed);
    const double cubed = metres * metres * metres;
    const double slack = 2 * metres * told["rounding"].get<double>() * body.area + 1e-9 * body.volume;
    EXPECT_GE(body.volume, cubed * told["volume"]["lower"].get<double>() - slack);
    EXPECT_LE(body.volume, cubed * told["volume"]["upper"].get<double>() + slack);
    EXPECT_NEAR(body.volume, cubed * told["mesh_volume"].get<double>(), 1e-9 * body.volume);
  }
  return read.objects.size();
}

SceneObject object_of(const std::string& name, const Shape& shape, const Pose& pose = {}) {
  return {name, shape, pose, Solid::automatic, "", {}, ""};
}

Shape mesh_shape(TriangleMesh mesh) { return std::make_shared<const TriangleMesh>(std::move(mesh)); }

/// Boxes in a row, a ball through two of them, a ring around a rod; and what only touches.
Scene bodies_scene(const std::string& unit) {
  Scene scene;
  scene.unit = unit;
  scene.objects = {object_of("left", Box({1, 1, 1})),
                   object_of("right", Box({1, 1, 1}), Pose::translation(1.75, 0.25, 0)),
                   object_of("ball", Sphere{0.5}, Pose::translation(1, 1, 0)),
                   object_of("beside", Box({1, 1, 1}), Pose::translation(-2, 0, 0)),
                   object_of("ring", mesh_shape(torus_mesh({})), Pose::translation(0, 5, 0)),
                   object_of("rod", mesh_shape(prism_mesh(1, 3, 12)), Pose::translation(0.25, 5, -1))};
  return scene;
}

TEST(OverlapBodiesGlb, AreClosedInMetresAndOfTheVolumeThatIsProved) {
  for (const auto& [unit, metres] : std::map<std::string, double>{{"mm", 0.001}, {"m", 1}, {"in", 0.0254}}) {
    const OverlapBodiesGlb bodies = bodies_of(bodies_scene(unit));
    EXPECT_EQ(bodies.bodies, 4U);
    EXPECT_TRUE(bodies.left_out.empty());
    EXPECT_EQ(expect_sound_bodies(bodies, metres), 4U);
    const std::map<std::string, BodiesJson> properties = properties_in(bodies);
    EXPECT_TRUE(properties.contains("left × right"));
    EXPECT_FALSE(properties.contains("left × beside"));
    EXPECT_EQ(properties.at("left × ball")["within"], true);
    EXPECT_FALSE(properties.at("left × right").contains("within"));
  }
}

TEST(OverlapBodiesGlb, LieWhereTheSolidsDo) {
  const Scene read = bodies_read_back(bodies_of(bodies_scene("m"), {}, {.up = UpAxis::y}));
  const auto found = std::find_if(read.objects.begin(), read.objects.end(),
                                  [](const SceneObject& object) { return object.name == "left × right"; });
  ASSERT_NE(found, read.objects.end());
  std::vector<Vec3> points = transform(found->pose, found->mesh()->vertices());
  for (int axis = 0; axis < 3; ++axis) {
    const auto [least, greatest] = std::minmax_element(points.begin(), points.end(),
                                                       [&](const Vec3& p, const Vec3& q) { return p[axis] < q[axis]; });
    EXPECT_EQ((*least)[axis], (Vec3{0.75, -0.75, -1})[axis]);
    EXPECT_EQ((*greatest)[axis], 1);
  }
  for (const Vec3& p : points) EXPECT_TRUE(p.x == 0.75 || p.x == 1 || p.y == -0.75 || p.y == 1 || std::abs(p.z) == 1);
}

TEST(OverlapBodiesGlb, HaveTheSameBytesOnAnyNumberOfThreads) {
  const Scene scene = many_parts(60, 5);
  const OverlapBodiesGlb one = bodies_of(scene, {.threads = 1}), four = bodies_of(scene, {.threads = 4});
  EXPECT_GT(one.bodies, 10U);
  EXPECT_EQ(bytes_of(one), bytes_of(four));
  EXPECT_EQ(one.left_out, four.left_out);
  EXPECT_EQ(expect_sound_bodies(one, 1), one.bodies);
}

std::size_t files_in(const test::TemporaryFolder& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder.path()), {}));
}

TEST(OverlapBodiesGlb, AreTheSameWhereTheyWaitInAFileWithoutAName) {
  const Scene scene = many_parts(60, 5);
  const std::vector<SceneInstance> models = scene_models(scene);
  const CheckReport report = make_check_report(models, check_all(models));
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "bodies.glb";
  {
    const OverlapBodiesGlb bodies = overlap_bodies_glb(scene, models, report, {}, {}, file);
    EXPECT_EQ(files_in(folder), 0U);
    bodies.write(file);
    EXPECT_EQ(files_in(folder), 1U);
    const std::string first = test::text_of(file);
    bodies.write(file);  // as often as is wanted
    EXPECT_EQ(test::text_of(file), first);
    EXPECT_EQ(first, bytes_of(bodies_of(scene)));
  }
  EXPECT_EQ(files_in(folder), 1U);
  EXPECT_THROW((void)overlap_bodies_glb(scene, models, report, {}, {}, folder.path() / "none" / "bodies.glb"), Error);
}

TEST(OverlapBodiesGlb, FarFromTheOriginTheyKeepTheirDetail) {
  Scene scene = bodies_scene("m");
  for (SceneObject& object : scene.objects) object.pose = Pose::translation(4e6, -5e6, 100) * object.pose;
  const OverlapBodiesGlb bodies = bodies_of(scene);
  EXPECT_EQ(bodies.bodies, 4U);
  for (const auto& [name, told] : properties_in(bodies))
    if (told.contains("mesh_volume")) {
      EXPECT_LT(told["rounding"], 1e-6);
      EXPECT_GE(told["mesh_volume"].get<double>(), told["volume"]["lower"].get<double>() * (1 - 1e-6));
    }
}

TEST(OverlapBodiesGlb, WhatHasNoneIsToldWithTheReason) {
  Scene scene = bodies_scene("m");
  scene.objects[4].solid = Solid::none;
  const OverlapBodiesGlb bodies = bodies_of(scene);
  EXPECT_EQ(bodies.bodies, 3U);
  ASSERT_EQ(bodies.left_out.size(), 1U);
  EXPECT_EQ(bodies.left_out[0].second, "a surface takes part, which has no inside");
  EXPECT_EQ(properties_in(bodies).at("ring × rod")["left_out"], "a surface takes part, which has no inside");
  EXPECT_EQ(expect_sound_bodies(bodies, 1), 3U);
}

TEST(OverlapBodiesGlb, WhenItIsStoppedTheOthersAreLeftOut) {
  const OverlapBodiesGlb bodies = bodies_of(bodies_scene("m"), {.stop = [] { return true; }});
  EXPECT_EQ(bodies.bodies, 0U);
  ASSERT_EQ(bodies.left_out.size(), 4U);
  EXPECT_EQ(bodies.left_out[0].second, "the check was stopped before it was made");
  EXPECT_EQ(bodies.stopped, 4U);
  std::size_t done = 0;
  const AskOptions cancelling{.threads = 1, .progress = [&](std::size_t, std::size_t) {
                                if (++done == 2) throw std::runtime_error("enough");
                              }};
  EXPECT_THROW((void)bodies_of(bodies_scene("m"), cancelling), std::runtime_error);
}

}  // namespace
}  // namespace toccata
