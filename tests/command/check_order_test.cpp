// The order in which files are named and the number of threads change nothing of what `check` tells.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "support/command.hpp"
#include "support/data.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/io/scene_file.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

namespace fs = std::filesystem;
using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

void flip_way(Json& pair, const char* key) {
  if (!pair.contains(key)) return;
  const std::string way = pair[key];
  if (way == "a_through_b" || way == "b_through_a") pair[key] = way == "a_through_b" ? "b_through_a" : "a_through_b";
  if (way == "a_in_b" || way == "b_in_a") pair[key] = way == "a_in_b" ? "b_in_a" : "a_in_b";
}

void turn_round(Json& vector) {
  for (Json& coordinate : vector) coordinate = -coordinate.get<double>();
}

/// All that is told of a pair, as if the one whose name comes first were a: but for their numbers in the list, which of
/// the places that are as near is told, and which way two equal ones are parted.
Json told_of(Json pair) {
  for (const char* const key : {"a_index", "b_index"}) pair.erase(key);
  if (pair.contains("distance"))
    for (const char* const key : {"on_a", "on_b", "face_a", "face_b"}) pair["distance"].erase(key);
  const bool has_way = pair.contains("penetration") && !pair["penetration"].is_null();
  if (pair["containment"] == "equal") {
    if (has_way)
      for (const char* const key : {"direction", "on_a", "on_b"}) pair["penetration"].erase(key);
    for (Json& region : pair["regions"]) region.erase("normal");
  }
  if (pair["a"] < pair["b"]) return pair;
  std::swap(pair["a"], pair["b"]);
  flip_way(pair, "containment");
  flip_way(pair, "piercing");
  if (pair.contains("regions") && pair["containment"] != "equal")
    for (Json& region : pair["regions"]) turn_round(region["normal"]);
  if (has_way && pair["containment"] != "equal") {
    turn_round(pair["penetration"]["direction"]);
    std::swap(pair["penetration"]["on_a"], pair["penetration"]["on_b"]);
  }
  return pair;
}

using PairsByName = std::map<std::pair<std::string, std::string>, Json>;

PairsByName pairs_in(const std::string& text) {
  const Json report = Json::parse(text);
  PairsByName pairs;
  for (const Json& pair : report["pairs"]) {
    const std::string a = pair["a"], b = pair["b"];
    const bool is_new = pairs.emplace(std::minmax(a, b), told_of(pair)).second;
    EXPECT_TRUE(is_new) << a << " " << b;
  }
  return pairs;
}

void shuffle(Words& files, Random& random) {
  for (std::size_t i = files.size(); i > 1; --i) std::swap(files[i - 1], files[random.below(i)]);
}

/// Tells the first pair that is another one.
void expect_same(const PairsByName& found, const PairsByName& expected, const std::string& where) {
  EXPECT_EQ(found.size(), expected.size()) << where;
  for (const auto& [names, told] : expected) {
    const auto other = found.find(names);
    ASSERT_TRUE(other != found.end()) << where << ": " << told;
    ASSERT_EQ(other->second, told) << where;
  }
}

/// Asks in so many orders, each with 1, 2 and 4 threads, but of the first with 2 alone, and returns what all told.
PairsByName expect_one_list(Words files, const Words& options, const fs::path& folder, int orders) {
  Random random(28);
  PairsByName expected;
  for (int order = 0; order < orders; ++order, shuffle(files, random)) {
    std::string with_one;
    const Words thread_counts = order == 0 ? Words{"2"} : Words{"1", "2", "4"};
    for (const std::string& threads : thread_counts) {
      Words words{"check"};
      words.insert(words.end(), files.begin(), files.end());
      words.insert(words.end(), options.begin(), options.end());
      words.insert(words.end(), {"--json", "--threads", threads});
      const auto run = run_command(words, folder);
      EXPECT_LE(run.exit_code, 1) << run.err;
      if (run.exit_code > 1) return expected;
      if (with_one.empty()) with_one = run.out;
      EXPECT_EQ(run.out == with_one, true) << "with " << threads << " threads other bytes";
      if (expected.empty()) expected = pairs_in(run.out);
      expect_same(pairs_in(run.out), expected, "in order " + std::to_string(order));
    }
  }
  return expected;
}

/// Meshes about one place, turned, some of them touching exactly, one twice, one within another, one open.
Words files_of_parts(const TemporaryFolder& folder) {
  Random random(11);
  const auto coordinate = [&] { return random.between(-1.6, 1.6); };
  const std::vector<TriangleMesh> shapes = {
      torus_mesh({.around = 24, .sides = 12}), gear_mesh({.teeth = 9}),  icosphere_mesh(0.8, 2), prism_mesh(0.4, 2, 7),
      noise_sphere_mesh({.subdivisions = 2}),  box_mesh({0.5, 0.7, 0.3})};
  std::vector<TriangleMesh> meshes;
  for (int i = 0; i < 12; ++i) {
    const TriangleMesh& shape = shapes[static_cast<std::size_t>(i) % shapes.size()];
    const Pose pose{rotation_about({coordinate(), coordinate(), 1}, random.between(0, 360)),
                    {coordinate(), coordinate(), coordinate()}};
    meshes.push_back(shape.with_vertices(transform(pose, shape.vertices())));
  }
  meshes.push_back(meshes[3]);
  meshes.push_back(box_mesh({0.5, 0.5, 0.5}, {4, 0, 0}));
  meshes.push_back(box_mesh({0.5, 0.5, 0.5}, {5, 0, 0}));
  meshes.push_back(box_mesh({0.25, 0.25, 0.25}, {5, 0, 0}));
  const std::vector<Vec3> corners = {{3.75, -1, 0.125}, {3.75, 1, 0.125}, {4.5, 0, 0.125}};
  meshes.push_back(TriangleMesh(corners, {{0, 1, 2}}));
  Words files;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    files.push_back("part-" + std::to_string(i) + ".obj");
    write_mesh(meshes[i], (folder.path() / files.back()).string());
  }
  return files;
}

TEST(CheckOrder, OfFilesAndThreadsChangeNothing) {
  const TemporaryFolder folder;
  const Words files = files_of_parts(folder);
  const PairsByName pairs = expect_one_list(
      files, {"--penetration", "--volume", "--clearance", "0.2", "--tolerance", "0.05"}, folder.path(), 4);
  EXPECT_GT(pairs.size(), 25U);
  std::map<std::string, int> relations;
  for (const auto& [names, told] : pairs) ++relations[told["relation"]];
  EXPECT_GT(relations["overlapping"], 10);
  EXPECT_GT(relations["apart"], 0);
  EXPECT_GT(relations["touching"], 0);
  EXPECT_GT(relations["crossing"], 0);
  EXPECT_EQ(pairs.at({"part-12", "part-3"})["containment"], "equal");
}

/// Writes the mesh as it lies in the world, and returns the name of the file.
std::string written(const TriangleMesh& mesh, const Pose& pose, const std::string& name,
                    const TemporaryFolder& folder) {
  write_mesh(mesh.with_vertices(transform(pose, mesh.vertices())), (folder.path() / name).string());
  return name;
}

/// The parts of an assembly, each as a file of its own.
Words files_of_assembly(const fs::path& file, const TemporaryFolder& folder) {
  const Scene scene = read_scene(file.string(), {.split = true});
  Words files;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& part = scene.objects[i];
    files.push_back(written(*part.mesh(), part.pose, "part-" + std::to_string(i) + ".obj", folder));
  }
  return files;
}

const Words all_questions = {"--penetration", "--volume", "--precision", "1"};

Words with_lengths(const std::string& tolerance, const std::string& clearance) {
  Words options = all_questions;
  options.insert(options.end(), {"--tolerance", tolerance, "--clearance", clearance});
  return options;
}

std::map<std::string, int> kinds_in(const PairsByName& pairs) {
  std::map<std::string, int> kinds;
  for (const auto& [names, told] : pairs) ++kinds[told["kind"]];
  return kinds;
}

const fs::path assimp_models = "/usr/share/assimp/models";

TEST(CheckOrder, OfTheRealPartsOfAnEngineChangesNothing) {
  if (!fs::is_directory(assimp_models)) GTEST_SKIP() << "install assimp-testmodels";
  const TemporaryFolder folder;
  const Words files =
      files_of_assembly(assimp_models / "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", folder);
  EXPECT_EQ(files.size(), 67U);
  auto kinds = kinds_in(expect_one_list(files, with_lengths("0.5", "2"), folder.path(), 2));
  EXPECT_GT(kinds["pierce"], 10);
  EXPECT_GT(kinds["crossing"], 50);
  EXPECT_GT(kinds["clearance"], 50);
}

TEST(CheckOrder, OfTheRealPartsOfAHouseChangesNothing) {
  if (!fs::is_directory(assimp_models)) GTEST_SKIP() << "install assimp-testmodels";
  const TemporaryFolder folder;
  const Words files = files_of_assembly(assimp_models / "OBJ/regr01.obj", folder);
  EXPECT_EQ(files.size(), 55U);
  auto kinds = kinds_in(expect_one_list(files, with_lengths("0.5", "2"), folder.path(), 2));
  EXPECT_GT(kinds["protrude"], 20);
  EXPECT_GT(kinds["touching"], 40);
  EXPECT_GT(kinds["crossing"], 20);
  EXPECT_GT(kinds["clearance"], 20);
}

Aabb box_of(const TriangleMesh& mesh) { return fit_aabb(mesh.vertices()); }

/// Real models in a row, each of the height 1, pressed into the next one by 0.02 of their boxes, some of them standing
/// on a table, exactly, and some sunk into it.
TEST(CheckOrder, OfRealMeshesThatClashChangesNothing) {
  const auto data = test::data_folder();
  if (!data || !fs::exists(*data / "meshes")) GTEST_SKIP() << "set TOCCATA_DATA to the folder of real models";
  const TemporaryFolder folder;
  Words files;
  double from = 0;
  for (const char* const name : {"spot", "fandisk", "teapot", "cow", "rocker-arm", "suzanne", "spot", "cow"}) {
    const TriangleMesh mesh = read_mesh((*data / "meshes" / (std::string(name) + ".obj")).string());
    const Aabb box = box_of(mesh);
    const double scale = 1 / (box.upper.z - box.lower.z);
    const TriangleMesh sized = scaled_mesh(mesh, scale);
    const Pose pose = Pose::translation(from - scale * box.lower.x, -0.5 * scale * (box.lower.y + box.upper.y), 0);
    from += scale * (box.upper.x - box.lower.x) - 0.02;
    const std::string file = "part-" + std::to_string(files.size()) + ".obj";
    // The lowest vertex is at the height 0 exactly, or 2⁻⁶ below.
    const Pose down = Pose::translation(0, 0, -box_of(sized).lower.z);
    const TriangleMesh standing = sized.with_vertices(transform(down, sized.vertices()));
    files.push_back(
        written(standing, {pose.linear, pose.offset - Vec3{0, 0, files.size() % 2 == 0 ? 0 : 0x1p-6}}, file, folder));
  }
  files.push_back(written(box_mesh({0.5 * from, 2, 0.25}, {0.5 * from, 0, -0.25}), {}, "table.obj", folder));
  auto kinds = kinds_in(expect_one_list(files, with_lengths("0.01", "0.05"), folder.path(), 2));
  EXPECT_GT(kinds["touching"], 0);
  EXPECT_GT(kinds["protrude"] + kinds["pierce"], 2);
  EXPECT_GT(kinds["crossing"], 0);
}

/// A scene of motion planning, of 85 parts, and a robot in it.
TEST(CheckOrder, OfARealSceneAndItsRobotChangesNothing) {
  const auto data = test::data_folder();
  if (!data || !fs::exists(*data / "meshes")) GTEST_SKIP() << "set TOCCATA_DATA to the folder of real models";
  const TemporaryFolder folder;
  Words files;
  for (const char* const name : {"env", "rob"}) {
    const TriangleMesh mesh = read_mesh((*data / "meshes" / (std::string(name) + ".obj")).string());
    const MeshParts parts = mesh_parts(mesh);
    for (Index part = 0; part < parts.first_triangle.size(); ++part) {
      std::vector<std::array<Index, 3>> triangles;
      for (Index i = 0; i < mesh.triangle_count(); ++i)
        if (parts.part_of_triangle[i] == part) triangles.push_back(mesh.triangles()[i]);
      const std::vector<Vec3> vertices(mesh.vertices().begin(), mesh.vertices().end());
      files.push_back(written({vertices, triangles}, {}, name + std::to_string(part) + ".obj", folder));
    }
  }
  const PairsByName pairs = expect_one_list(files, with_lengths("1", "5"), folder.path(), 2);
  EXPECT_GT(pairs.size(), 50U);
}

}  // namespace
}  // namespace toccata
