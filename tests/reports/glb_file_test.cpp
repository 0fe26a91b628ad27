// GLB files of what was found: sound by the standard's own rules, and read back by our own reader.
#include "toccata/reports/pages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "support/command.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/io/scene_file.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/partitions/measure.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/reports/output_file.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

using Json = nlohmann::json;

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + at, 4);
  return number;
}

/// A GLB file taken apart, with every rule of the standard that its parts could break looked at.
class SoundGlb {
 public:
  explicit SoundGlb(const std::string& file) {
    EXPECT_EQ(file.substr(0, 4), "glTF");
    EXPECT_EQ(number_at(file, 4), 2U);
    EXPECT_EQ(number_at(file, 8), file.size());
    const std::size_t text_size = number_at(file, 12);
    EXPECT_EQ(text_size % 4, 0U);
    EXPECT_EQ(file.substr(16, 4), "JSON");
    top = Json::parse(file.substr(20, text_size));
    const std::size_t behind = 20 + text_size;
    if (behind < file.size()) {
      EXPECT_EQ(number_at(file, behind) % 4, 0U);
      EXPECT_EQ(file.substr(behind + 4, 4), std::string("BIN\0", 4));
      binary = file.substr(behind + 8);
      EXPECT_EQ(number_at(file, behind), binary.size());
      EXPECT_LE(top["buffers"][0]["byteLength"].get<std::size_t>(), binary.size());
      EXPECT_LT(binary.size() - top["buffers"][0]["byteLength"].get<std::size_t>(), 4U);
    }
    EXPECT_EQ(top["asset"]["version"], "2.0");
    for (const char* list : {"nodes", "meshes", "materials", "accessors", "bufferViews", "buffers"})
      if (top.contains(list)) {
        EXPECT_FALSE(top[list].empty()) << list;
      }
    check_views();
    check_accessors();
    check_meshes();
    check_nodes();
  }

  template <class Number>
  [[nodiscard]] std::vector<Number> numbers(std::size_t accessor, std::size_t components) const {
    const Json& json = top["accessors"][accessor];
    const Json& view = top["bufferViews"][json["bufferView"].get<std::size_t>()];
    std::vector<Number> all(components * json["count"].get<std::size_t>());
    EXPECT_EQ(view["byteLength"].get<std::size_t>(), all.size() * sizeof(Number));
    std::memcpy(all.data(), binary.data() + view["byteOffset"].get<std::size_t>(), all.size() * sizeof(Number));
    return all;
  }

  [[nodiscard]] std::vector<Json> nodes_named(const std::string& name) const {
    std::vector<Json> found;
    for (const Json& node : top["nodes"])
      if (node["name"] == name) found.push_back(node);
    return found;
  }

  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> all;
    for (const Json& node : top["nodes"]) all.insert(node["name"].get<std::string>());
    return all;
  }

  Json top;
  std::string binary;

 private:
  void check_views() const {
    std::size_t end = 0;
    for (const Json& view : top.value("bufferViews", Json::array())) {
      EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0U);
      EXPECT_GE(view["byteOffset"].get<std::size_t>(), end);
      EXPECT_GT(view["byteLength"].get<std::size_t>(), 0U);
      end = view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>();
      EXPECT_LE(end, top["buffers"][0]["byteLength"].get<std::size_t>());
    }
  }

  void check_accessors() const {
    std::set<std::size_t> used;
    for (const Json& accessor : top.value("accessors", Json::array())) {
      EXPECT_TRUE(used.insert(accessor["bufferView"].get<std::size_t>()).second);
      if (accessor["type"] == "VEC3" && accessor.contains("min")) check_bounds(accessor, used.size() - 1);
    }
    EXPECT_EQ(used.size(), top.value("bufferViews", Json::array()).size());
  }

  void check_bounds(const Json& accessor, std::size_t number) const {
    EXPECT_EQ(accessor["componentType"], 5126);
    const std::vector<float> points = numbers<float>(number, 3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float least = points[axis], greatest = points[axis];
      for (std::size_t i = axis; i < points.size(); i += 3) {
        EXPECT_TRUE(std::isfinite(points[i]));
        least = std::min(least, points[i]);
        greatest = std::max(greatest, points[i]);
      }
      EXPECT_EQ(accessor["min"][axis].get<double>(), static_cast<double>(least));
      EXPECT_EQ(accessor["max"][axis].get<double>(), static_cast<double>(greatest));
    }
  }

  void check_meshes() const {
    for (const Json& mesh : top.value("meshes", Json::array()))
      for (const Json& part : mesh["primitives"]) {
        EXPECT_LT(part["material"].get<std::size_t>(), top["materials"].size());
        const std::size_t points =
            top["accessors"][part["attributes"]["POSITION"].get<std::size_t>()]["count"].get<std::size_t>();
        const std::size_t corners = part.contains("indices") ? check_indices(part["indices"], points) : points;
        EXPECT_GT(corners, 0U);
        EXPECT_EQ(corners % (part["mode"] == 4 ? 3 : part["mode"] == 1 ? 2 : 1), 0U);
      }
  }

  std::size_t check_indices(const Json& place, std::size_t points) const {
    const Json& accessor = top["accessors"][place.get<std::size_t>()];
    EXPECT_EQ(accessor["type"], "SCALAR");
    const auto below = [&](const auto& all) {
      for (const auto number : all) EXPECT_LT(number, points);
    };
    if (accessor["componentType"] == 5123)
      below(numbers<std::uint16_t>(place.get<std::size_t>(), 1));
    else
      below(numbers<std::uint32_t>(place.get<std::size_t>(), 1));
    return accessor["count"].get<std::size_t>();
  }

  /// A tree from the one root of the scene, whose matrices can be taken apart.
  void check_nodes() const {
    std::vector<int> parents(top["nodes"].size(), 0);
    for (const Json& node : top["nodes"]) {
      for (const Json& child : node.value("children", Json::array())) ++parents[child.get<std::size_t>()];
      if (node.contains("children")) {
        EXPECT_FALSE(node["children"].empty());
      }
      if (node.contains("mesh")) {
        EXPECT_LT(node["mesh"].get<std::size_t>(), top["meshes"].size());
      }
      if (node.contains("matrix")) check_matrix(node["matrix"].get<std::array<double, 16>>());
    }
    ASSERT_EQ(top["scenes"][0]["nodes"].size(), 1U);
    ++parents[top["scenes"][0]["nodes"][0].get<std::size_t>()];
    for (const int count : parents) EXPECT_EQ(count, 1);
  }

  static void check_matrix(const std::array<double, 16>& m) {
    EXPECT_EQ((std::array<double, 4>{m[3], m[7], m[11], m[15]}), (std::array<double, 4>{0, 0, 0, 1}));
    const std::array<Vec3, 3> columns{Vec3{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}};
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_GT(std::hypot(columns[i].x, columns[i].y, columns[i].z), 0);
      const Vec3& next = columns[(i + 1) % 3];
      EXPECT_LE(std::abs(dot(columns[i], next)),
                2e-6 * std::sqrt(dot(columns[i], columns[i])) * std::sqrt(dot(next, next)));
    }
  }
};

struct Exported {
  std::vector<SceneInstance> models;
  std::string bytes;
};

Exported exported(const Scene& scene, const CheckOptions& asked = {}, const ViewOptions& options = {}) {
  Exported result{scene_models(scene), ""};
  const CheckReport report =
      make_check_report(result.models, check_all(result.models, asked),
                        {Touching::count, asked.contacts, asked.penetration, asked.clearance, {}});
  result.bytes = scene_glb(scene, result.models, report, options);
  return result;
}

Scene read_back(const std::string& bytes) {
  const test::TemporaryFolder folder;
  write_glb(bytes, folder.path() / "scene.glb");
  return read_scene(folder.path() / "scene.glb");
}

CheckOptions everything() {
  CheckOptions options;
  options.contacts = true;
  options.penetration = true;
  return options;
}

Scene scene_of(const std::vector<SceneObject>& objects, const std::string& unit = "m") {
  Scene scene;
  scene.objects = objects;
  scene.unit = unit;
  return scene;
}

SceneObject object(const std::string& name, const Shape& shape, const Pose& pose = {}) {
  return {name, shape, pose, Solid::automatic, "", {}, ""};
}

std::shared_ptr<const TriangleMesh> ball() { return std::make_shared<const TriangleMesh>(icosphere_mesh(1, 2)); }

/// The file's world is metres and Y up; this is that of the scene.
Vec3 in_z_up(const Vec3& v, double metres) { return {v.x / metres, -v.z / metres, v.y / metres}; }

double difference(const Vec3& a, const Vec3& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

/// Every vertex of these objects is where it was, up to this much of what is around it.
void expect_same_places(const Scene& before, const Scene& after, double metres, double tolerance) {
  for (std::size_t i = 0; i < before.objects.size(); ++i) {
    const SceneObject &old = before.objects[i], &read = after.objects[i];
    EXPECT_EQ(read.name, old.name);
    ASSERT_EQ(read.mesh()->triangle_count(), old.mesh()->triangle_count());
    ASSERT_EQ(read.mesh()->vertices().size(), old.mesh()->vertices().size());
    for (Index t = 0; t < old.mesh()->triangle_count(); ++t)
      ASSERT_EQ(read.mesh()->triangles()[t], old.mesh()->triangles()[t]);
    for (std::size_t v = 0; v < old.mesh()->vertices().size(); ++v)
      ASSERT_LE(difference(in_z_up(transform(read.pose, read.mesh()->vertices()[v]), metres),
                           transform(old.pose, old.mesh()->vertices()[v])),
                tolerance)
          << old.name;
  }
}

TEST(GlbFile, IsReadBackWithTheSameTrianglesPlacesAndNames) {
  const Scene scene = gear_train();
  const Exported file = exported(scene);
  const SoundGlb glb(file.bytes);
  EXPECT_TRUE(glb.names().contains("objects"));
  expect_same_places(scene, read_back(file.bytes), 1, 1e-7);
}

TEST(GlbFile, IsInMetresAndWithYUp) {
  const auto mesh = ball();
  for (const auto& [unit, metres] : std::map<std::string, double>{{"mm", 0.001}, {"in", 0.0254}, {"unit", 1}}) {
    const Scene scene = scene_of({object("a", mesh, Pose::translation(1, 2, 3))}, unit);
    expect_same_places(scene, read_back(exported(scene).bytes), metres, 1e-6);
    const Scene lying = read_back(exported(scene, {}, {"", UpAxis::y, {}}).bytes);
    const Vec3 placed = transform(lying.objects[0].pose, lying.objects[0].mesh()->vertices()[5]);
    EXPECT_LT(difference(placed, metres * (mesh->vertices()[5] + Vec3{1, 2, 3})), 1e-6 * metres);
  }
}

TEST(GlbFile, FarTinyAndHugeScenesKeepTheirDetail) {
  const auto mesh = ball();
  const Vec3 far{1e9, -3e8, 7e7};
  std::vector<Vec3> far_vertices;
  for (const Vec3& v : mesh->vertices()) far_vertices.push_back(v + far);
  const std::vector<std::array<Index, 3>> triangles(mesh->triangles().begin(), mesh->triangles().end());
  const auto far_mesh = std::make_shared<const TriangleMesh>(far_vertices, triangles);
  const Scene far_scene = scene_of({object("by its pose", mesh, {{}, far}), object("by its vertices", far_mesh)});
  // Two roundings of doubles near 1e9.
  expect_same_places(far_scene, read_back(exported(far_scene, everything()).bytes), 1, 5e-7);
  for (const double size : {1e-200, 1e-30, 1e30, 1e200}) {
    const Scene scene = scene_of({object("scaled", mesh, scaled(Pose{}, size)),
                                  object("vertices", std::make_shared<const TriangleMesh>(icosphere_mesh(size, 1)))});
    const std::string bytes = exported(scene).bytes;
    const SoundGlb glb(bytes);
    expect_same_places(scene, read_back(bytes), 1, 1e-6 * size);
  }
}

TEST(GlbFile, NamesAreThoseOfTheObjectsWhateverTheyHold) {
  const auto mesh = ball();
  const std::vector<std::string> names{"Zahnräder 齿轮 🐰", "\"quoted\\", "line\nbreak", "e\u0301", "</script>", " "};
  Scene scene;
  for (std::size_t i = 0; i < names.size(); ++i)
    scene.objects.push_back(object(names[i], mesh, Pose::translation(1.5 * static_cast<double>(i), 0, 0)));
  const std::string bytes = exported(scene, everything()).bytes;
  const SoundGlb glb(bytes);
  EXPECT_TRUE(glb.names().contains("contacts of " + names[0] + " and " + names[1]));
  const Scene read = read_back(bytes);
  for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(read.objects[i].name, names[i]);
  scene.objects[0].name = "broken \xff";
  EXPECT_EQ(read_back(exported(scene).bytes).objects[0].name, "broken \\xff");
}

TEST(GlbFile, InstancesShareTheirNumbers) {
  const Scene scene = many_parts(500, 3);
  CheckOptions with_faces;
  with_faces.contacts = true;
  const Exported file = exported(scene, with_faces);
  const SoundGlb glb(file.bytes);
  const std::vector<Json> objects = glb.nodes_named("objects");
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_EQ(objects[0]["children"].size(), 500U);
  std::set<Json> positions;
  for (const Json& node : objects[0]["children"]) {
    const Json& mesh = glb.top["meshes"][glb.top["nodes"][node.get<std::size_t>()]["mesh"].get<std::size_t>()];
    positions.insert(mesh["primitives"][0]["attributes"]["POSITION"]);
  }
  EXPECT_LT(positions.size(), 20U);
}

TEST(GlbFile, ShearedAndSingularPosesAreInTheVertices) {
  const auto mesh = ball();
  const Scene scene = scene_of({object("sheared", mesh, Pose::from_numbers({1, 2, 0, 0, 1, 0.5, 0, 0, 1, 5, 6, 7})),
                                object("flat", mesh, Pose::from_numbers({1, 0, 0, 0, 1, 0, 0, 0, 0, 8, 0, 0})),
                                object("mirrored", mesh, Pose::from_numbers({-1, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 9}))});
  Scene surfaces = scene;
  for (SceneObject& each : surfaces.objects) each.solid = Solid::none;
  const std::string bytes = exported(surfaces, {}, {"", UpAxis::z, cost_volume<Obb>}).bytes;
  const SoundGlb glb(bytes);
  EXPECT_EQ(glb.nodes_named("level 0").size(), 3U);
  expect_same_places(scene, read_back(bytes), 1, 1e-6);
}

TEST(GlbFile, ContactsAreNodesOfTheirOwn) {
  const Scene scene = gear_train();
  const Exported file = exported(scene, everything());
  const SoundGlb glb(file.bytes);
  const CheckAnswer answer = check_all(file.models, everything());
  ASSERT_EQ(answer.pairs.size(), 1U);
  const PairAnswer& pair = answer.pairs[0];
  const std::string between = file.models[pair.a].name + " and " + file.models[pair.b].name;
  const std::vector<Json> found = glb.nodes_named("contacts of " + between);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0]["extras"]["found"].get<std::string>().starts_with(file.models[pair.a].name));
  std::map<std::string, std::size_t> corners;
  for (const Json& part : glb.top["meshes"][found[0]["mesh"].get<std::size_t>()]["primitives"])
    corners[glb.top["materials"][part["material"].get<std::size_t>()]["name"]] +=
        glb.top["accessors"][part["indices"].get<std::size_t>()]["count"].get<std::size_t>();
  std::set<Index> faces_a, faces_b;
  for (const Contact& contact : pair.contacts) {
    faces_a.insert(contact.face_a);
    faces_b.insert(contact.face_b);
  }
  const auto triangles = [&](Index number, const std::set<Index>& faces) {
    const TriangleMesh& mesh = file.models[number].model.mesh();
    std::size_t count = 0;
    for (Index i = 0; i < mesh.triangle_count(); ++i) count += faces.contains(mesh.face_of(i)) ? 1 : 0;
    return count;
  };
  EXPECT_EQ(corners["faces of the first that meet"], 3 * triangles(pair.a, faces_a));
  EXPECT_EQ(corners["faces of the second that meet"], 3 * triangles(pair.b, faces_b));
  EXPECT_GT(corners["where they meet"], 0U);
  const std::vector<Json> depth = glb.nodes_named("depth of " + between);
  ASSERT_EQ(depth.size(), 1U);
  EXPECT_EQ(depth[0]["extras"]["depth"]["lower"].get<double>(), pair.penetration->lower);
  EXPECT_EQ(depth[0]["extras"]["depth"]["upper"].get<double>(), pair.penetration->upper);
  EXPECT_EQ(depth[0]["extras"]["found"].get<std::string>(),
            bracket_text(pair.penetration->lower, pair.penetration->upper) + " deep");
}

TEST(GlbFile, DistancesAreSegmentsBetweenTheNearestPoints) {
  CheckOptions options = everything();
  options.clearance = 10;
  const Scene scene = scene_of({object("a", Sphere(1)), object("b", Sphere(1), Pose::translation(0, 0, 5))});
  const SoundGlb glb(exported(scene, options).bytes);
  const std::vector<Json> found = glb.nodes_named("distance of a and b");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0]["extras"]["distance"].get<double>(), 3, 1e-12);
  const Json& part = glb.top["meshes"][found[0]["mesh"].get<std::size_t>()]["primitives"][0];
  EXPECT_EQ(part["mode"], 1);
  EXPECT_EQ(glb.numbers<float>(part["attributes"]["POSITION"].get<std::size_t>(), 3),
            (std::vector<float>{0, 0, 1, 0, 0, 4}));
  EXPECT_TRUE(glb.nodes_named("contacts of a and b").empty());
}

TEST(GlbFile, EveryShapeIsThere) {
  const Scene scene = scene_of(
      {object("point", Point{{1, 2, 3}}), object("segment", Segment{{0, 0, 0}, {1, 0, 0}}),
       object("triangle", Triangle{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}),
       object("floor", HalfSpace({0, 0, -1}, {0, 0, 3})),
       object("ball", Sphere(2, {1, 0, 0}), Pose::translation(5, 0, 0)), object("ball again", Sphere(0.5)),
       object("box", Box({1, 2, 3}, {1, 1, 1})), object("capsule", Capsule({0, 0, 0}, {0, 0, 2}, 0.5)),
       object("hull", ConvexHull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})),
       object("rounded", Rounded(Box({1, 1, 1}), 0.25)),
       object("compound",
              Compound(std::vector<CompoundPart>{{Box({1, 1, 1}), Pose{}}, {Sphere(1), Pose::translation(3, 0, 0)}}))});
  const Exported file = exported(scene, everything());
  const SoundGlb glb(file.bytes);
  for (const SceneObject& each : scene.objects) EXPECT_EQ(glb.nodes_named(each.name).size(), 1U) << each.name;
  const auto mode_of = [&](const char* name) {
    return glb.top["meshes"][glb.nodes_named(name)[0]["mesh"].get<std::size_t>()]["primitives"][0]["mode"].get<int>();
  };
  EXPECT_EQ(mode_of("point"), 0);
  EXPECT_EQ(mode_of("segment"), 1);
  EXPECT_EQ(mode_of("triangle"), 4);
  const Scene read = read_back(file.bytes);
  const auto box =
      std::find_if(read.objects.begin(), read.objects.end(), [](const auto& o) { return o.name == "box"; });
  ASSERT_NE(box, read.objects.end());
  Aabb around;
  for (const Vec3& v : box->mesh()->vertices()) around = merge(around, in_z_up(transform(box->pose, v), 1));
  EXPECT_EQ(around, (Aabb{{0, -1, -2}, {2, 3, 4}}));
}

TEST(GlbFile, LevelsAreNodesWithWhatThePageTells) {
  const auto mesh = ball();
  const Scene scene = scene_of({object("one", mesh), object("two", mesh, Pose::translation(9, 0, 0))});
  const std::string bytes = exported(scene, {}, {"", UpAxis::z, cost_volume<Aabb>}).bytes;
  const SoundGlb glb(bytes);
  EXPECT_TRUE(glb.names().contains("hierarchy of aabb over one"));
  EXPECT_TRUE(glb.names().contains("hierarchy of aabb over two"));
  const std::vector<Json> tops = glb.nodes_named("level 0"), deep = glb.nodes_named("level 3");
  ASSERT_EQ(tops.size(), 2U);
  ASSERT_EQ(deep.size(), 2U);
  EXPECT_EQ(tops[0]["mesh"], tops[1]["mesh"]);
  EXPECT_EQ(tops[0]["extras"]["volumes"], 1);
  EXPECT_EQ(deep[0]["extras"]["volumes"], 8);
  const Json& box = glb.top["meshes"][tops[0]["mesh"].get<std::size_t>()]["primitives"][0];
  const std::vector<float> corners = glb.numbers<float>(box["attributes"]["POSITION"].get<std::size_t>(), 3);
  EXPECT_EQ(corners.size(), 24U);
  for (const float x : corners) EXPECT_NEAR(std::abs(x), 1, 0.2);
}

TEST(GlbFile, LevelsHaveNoTrianglesWithoutArea) {
  const auto flat = std::make_shared<const TriangleMesh>(generate_mesh("torus-knot"));
  const SoundGlb glb(exported(scene_of({object("knot", flat)}), {}, {"", UpAxis::z, cost_volume<Obb>}).bytes);
  for (const Json& part : glb.top["meshes"].back()["primitives"]) {
    const auto place = part["indices"].get<std::size_t>();
    ASSERT_EQ(glb.top["accessors"][place]["componentType"], 5123);
    const std::vector<std::uint16_t> corners = glb.numbers<std::uint16_t>(place, 1);
    for (std::size_t i = 0; i < corners.size(); i += 3)
      EXPECT_TRUE(corners[i] != corners[i + 1] && corners[i + 1] != corners[i + 2] && corners[i + 2] != corners[i]);
  }
}

TEST(GlbFile, EmptyScenesAndBadOnesAreTold) {
  const SoundGlb glb(exported(Scene{}).bytes);
  EXPECT_EQ(glb.top["nodes"].size(), 1U);
  EXPECT_FALSE(glb.top.contains("meshes"));
  const auto mesh = ball();
  EXPECT_THROW(static_cast<void>(exported(scene_of({object("far", mesh, {{}, {1e308, 0, 0}})}, "km"))), Error);
}

/// The pose of a node at a key of the animation.
Pose pose_at_key(const SoundGlb& glb, const std::string& name, std::size_t key) {
  Vec3 translation, scale;
  Mat3 rotation;
  for (const Json& channel : glb.top["animations"][0]["channels"]) {
    const Json& target = channel["target"];
    if (glb.top["nodes"][target["node"].get<std::size_t>()]["name"] != name) continue;
    const Json& sampler = glb.top["animations"][0]["samplers"][channel["sampler"].get<std::size_t>()];
    EXPECT_EQ(sampler["interpolation"], "STEP");
    EXPECT_EQ(glb.numbers<float>(sampler["input"].get<std::size_t>(), 1).at(key), static_cast<float>(key) / 24);
    const std::size_t width = target["path"] == "rotation" ? 4 : 3;
    const std::vector<float> keys = glb.numbers<float>(sampler["output"].get<std::size_t>(), width);
    const auto at = [&](std::size_t i) { return static_cast<double>(keys.at(width * key + i)); };
    if (target["path"] == "translation") translation = {at(0), at(1), at(2)};
    if (target["path"] == "scale") scale = {at(0), at(1), at(2)};
    if (width == 4) rotation = rotation_of({at(0), at(1), at(2), at(3)});
  }
  return pose_of(translation, rotation, scale);
}

TEST(GlbFile, PosesAreKeysOfAnAnimation) {
  const Scene scene = scene_of({object("a", ball()), object("b", Box({1, 2, 3}))});
  const std::vector<SceneInstance> models = scene_models(scene);
  Random random(5);
  CheckPosesQuestion question;
  for (int i = 0; i < 40; ++i) {
    Pose pose{test::random_rotation(random), {random.between(-4, 4), random.between(-4, 4), 0}};
    if (i % 3 == 1) pose.linear[0] = -1.0 * pose.linear[0];  // mirrored
    if (i % 5 == 2)
      for (int row = 0; row < 3; ++row) pose.linear[row] = 0.25 * pose.linear[row];
    question.queries.push_back({pose, Pose::translation(0, 0, 0.5 * i)});
  }
  const PosesReport report = with_face_pairs(std::get<PosesReport>(ask(models, question)), models, 1000);
  ViewOptions options;
  options.up = UpAxis::y;
  const SoundGlb glb(scene_glb(scene, models, report, options));
  for (std::size_t i = 0; i < question.queries.size(); ++i)
    for (const bool is_a : {true, false}) {
      const Pose &was = is_a ? question.queries[i].pose_a : question.queries[i].pose_b,
                 is = pose_at_key(glb, is_a ? "a moving" : "b moving", i);
      for (const Vec3& corner : {Vec3{1, 2, 3}, Vec3{-1, 2, -3}})
        EXPECT_LE(difference(transform(is, corner), transform(was, corner)), 1e-5) << i;
    }
  EXPECT_EQ(std::count_if(report.relations.begin(), report.relations.end(),
                          [](const Relation& r) { return r.kind != RelationKind::apart; }),
            static_cast<std::ptrdiff_t>(glb.nodes_named("contacts of a and b").size()));
  question.queries[7].pose_b.linear[0].y = 0.5;
  const SceneAnswer sheared = ask(models, question);
  EXPECT_THROW(static_cast<void>(scene_glb(scene, models, sheared, options)), Error);
}

TEST(GlbFile, CrowdsMoveAndTheirPairsAreSeenInTheirFrames) {
  const CrowdRecording recording = record_crowd({"uniform", 30, 3, {BroadPhaseMethod::uniform_grid}});
  const SoundGlb glb(recording_glb(recording));
  for (std::size_t i = 0; i < recording.frames().size(); ++i) {
    const CrowdRecording::Frame& frame = recording.frames()[i];
    for (std::size_t box = 0; box < frame.boxes.size(); ++box)
      EXPECT_LE(difference(transform(pose_at_key(glb, "box " + std::to_string(box) + " moving", i), {1, 1, 1}),
                           frame.boxes[box].upper),
                1e-5);
    const auto nodes = glb.nodes_named("frame " + std::to_string(i));  // of pairs, and of cells
    ASSERT_EQ(nodes.size(), 2U);
    for (const Json& node : nodes) {
      const bool is_pairs = node["extras"].contains("pairs");
      const Json& shown = glb.top["nodes"][node["children"][0].get<std::size_t>()];
      const Json& part = glb.top["meshes"][shown["mesh"].get<std::size_t>()]["primitives"][0];
      const Json& points = glb.top["accessors"][part["attributes"]["POSITION"].get<std::size_t>()];
      EXPECT_EQ(part["mode"], 1);
      EXPECT_EQ(points["count"], is_pairs ? 2 * frame.pairs.size() : 8 * frame.space.cells.size());
      EXPECT_EQ(node["extras"][is_pairs ? "pairs" : "cells"], is_pairs ? frame.pairs.size() : frame.space.cells.size());
    }
  }
  EXPECT_THROW(static_cast<void>(recording_glb(CrowdRecording{})), Error);
  const CrowdRecording many = record_crowd({"uniform", 20'001, 1});
  EXPECT_THROW(static_cast<void>(recording_glb(many)), Error);
}

/// A body that comes later and one that goes are nowhere in the other frames.
TEST(GlbFile, BodiesOfAWorldMoveComeAndGo) {
  World world({.distance = true, .manifold = true});
  const BodyId ball = world.add({Model(Sphere(1)), Pose::translation(0, 0, 1.5)});
  world.add({Model(Box({1, 1, 1}))});
  world.step();
  WorldRecording recording;
  recording.add(world);
  const BodyId late = world.add({Model(Sphere(1)), Pose::translation(5, 0, 0)});
  world.move(ball, Pose::translation(0, 0, 3));
  world.step();
  recording.add(world);
  world.remove(late);
  world.step();
  recording.add(world);
  const SoundGlb glb(recording_glb(recording));
  const auto place_of = [&](std::size_t body, std::size_t key) {
    return pose_at_key(glb, "body " + std::to_string(body) + " moving", key);
  };
  EXPECT_LE(difference(place_of(0, 0).offset, {0, 0, 1.5}), 1e-6);
  EXPECT_LE(difference(place_of(0, 1).offset, {0, 0, 3}), 1e-6);
  EXPECT_EQ(place_of(2, 0).linear, (Mat3{{Vec3{}, Vec3{}, Vec3{}}}));
  EXPECT_LE(difference(place_of(2, 1).offset, {5, 0, 0}), 1e-6);
  EXPECT_EQ(place_of(2, 2).linear, (Mat3{{Vec3{}, Vec3{}, Vec3{}}}));
  const std::vector<Json> first = glb.nodes_named("step 0"), second = glb.nodes_named("step 1");
  ASSERT_EQ(first.size(), 1U);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(first[0]["extras"], Json({{"begin", 1}, {"persist", 0}, {"end", 0}}));
  EXPECT_EQ(second[0]["extras"], Json({{"begin", 0}, {"persist", 0}, {"end", 1}}));
  EXPECT_EQ(glb.nodes_named("contact points").size(), 1U);
}

TEST(GlbFile, PartitionsAndVoronoiRegionsAreNodes) {
  const Scene scene = scene_of({object("one", ball()), object("two", ball(), {{}, {3, 0, 0}})});
  const std::vector<SceneInstance> models = scene_models(scene);
  ViewOptions options;
  options.partition = PartitionKind::octree;
  const SoundGlb glb(scene_glb(scene, models, CheckReport{}, options));
  const auto levels = partition_levels(PartitionKind::octree, PartitionItems(models[0].model.mesh()));
  for (const char* name : {"cells of the octree over one", "cells of the octree over two"}) {
    ASSERT_EQ(glb.nodes_named(name).size(), 1U);
    EXPECT_EQ(glb.nodes_named(name)[0]["children"].size(), levels.size());
  }
  const Json depth = glb.nodes_named("depth 1").at(0);
  EXPECT_EQ(depth["extras"]["cells"], levels.at(1).cells.size());
  const Json& part = glb.top["meshes"][depth["mesh"].get<std::size_t>()]["primitives"][0];
  EXPECT_EQ(glb.top["accessors"][part["indices"].get<std::size_t>()]["count"], 24 * levels[1].cells.size());
  const Scene boxes = scene_of({object("box", Box({1, 2, 3}))});
  options.partition.reset();
  options.voronoi = true;
  const SoundGlb regions(scene_glb(boxes, scene_models(boxes), CheckReport{}, options));
  ASSERT_EQ(regions.nodes_named("Voronoi regions of box").size(), 1U);
  EXPECT_EQ(regions.nodes_named("Voronoi regions of box")[0]["children"].size(), 3U);
  const Scene gears = gear_train();
  EXPECT_THROW(static_cast<void>(scene_glb(gears, scene_models(gears), CheckReport{}, options)), Error);
}

TEST(GlbFile, VisitsOfAWalkThroughVoronoiRegionsAreNodes) {
  const Scene scene = scene_of({object("one", Box({1, 1, 1})), object("two", Box({1, 1, 1}), {{}, {3.5, 0.5, 0.25}})});
  ViewOptions options;
  options.voronoi_walk = true;
  const SoundGlb glb(scene_glb(scene, scene_models(scene), CheckReport{}, options));
  const std::vector<Json> walks = glb.nodes_named("Voronoi walk of one and two");
  ASSERT_EQ(walks.size(), 1U);
  const Json& visits = walks[0]["children"];
  ASSERT_GT(visits.size(), 2U);
  double before = 1e9;
  for (const Json& index : visits) {
    const Json& visit = glb.top["nodes"][index.get<std::size_t>()];
    const double distance = visit["extras"]["distance"].get<double>();
    EXPECT_LT(distance, before);
    before = distance;
    EXPECT_EQ(glb.top["meshes"][visit["mesh"].get<std::size_t>()]["primitives"][0]["mode"], 1);
  }
  EXPECT_DOUBLE_EQ(before, 1.5);
  const Scene alone = scene_of({object("one", Box({1, 1, 1}))});
  EXPECT_THROW(static_cast<void>(scene_glb(alone, scene_models(alone), CheckReport{}, options)), Error);
}

TEST(GlbFile, ReplacesNothingThatIsNotItsOwn) {
  const test::TemporaryFolder folder;
  const std::string bytes = exported(scene_of({object("a", ball())})).bytes;
  std::string foreign = bytes;
  foreign.replace(foreign.find("Toccata"), 7, "Blender");
  const auto theirs = folder.write("theirs.glb", foreign), own = folder.path() / "own.glb";
  EXPECT_THROW(write_glb(bytes, theirs), Error);
  EXPECT_THROW(require_output(theirs, OutputKind::glb), Error);
  write_glb(bytes, own);
  write_glb(bytes, own);
  require_output(own, OutputKind::glb);
  EXPECT_THROW(require_output(own, OutputKind::page), Error);
  EXPECT_THROW(require_output(folder.path() / "missing" / "a.glb", OutputKind::glb), Error);
}

}  // namespace
}  // namespace toccata
