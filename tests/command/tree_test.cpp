#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/command.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;

bool tree_says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(TreeCommand, SavesATreeAndKnowsItAgain) {
  const TemporaryFolder folder;
  const auto saved = run_command({"tree", "gen:torus-knot", "--save", "knot.tree"}, folder.path());
  EXPECT_EQ(saved.exit_code, 0) << saved.err;
  EXPECT_TRUE(tree_says(saved.out, "knot.tree: saved a tree of ")) << saved.out;
  const auto checked = run_command({"tree", "gen:torus-knot", "--check", "knot.tree"}, folder.path());
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_TRUE(tree_says(checked.out, "knot.tree: the tree of ")) << checked.out;
  const auto other = run_command({"tree", "gen:torus-knot?p=3&q=2", "--check", "knot.tree"}, folder.path());
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_TRUE(tree_says(other.err, "another mesh")) << other.err;
  EXPECT_EQ(other.out, "");
}

TEST(TreeCommand, RefusesWhatItCannotDo) {
  const TemporaryFolder folder;
  folder.write("shape.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "ball", "shape": {"type": "sphere", "radius": 1}}]})");
  folder.write("no.tree", "not a tree at all");
  const auto trouble = [&](const std::vector<std::string>& words, const std::string& part) {
    const auto result = run_command(words, folder.path());
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(tree_says(result.err, part)) << result.err;
    EXPECT_EQ(result.out, "");
  };
  trouble({"tree", "gen:torus-knot"}, "--save FILE");
  trouble({"tree", "gen:torus-knot", "--save", "a", "--check", "a"}, "excludes");
  trouble({"tree", "shape.json", "--save", "a.tree"}, "no mesh");
  trouble({"tree", "gen:torus-knot", "--check", "no.tree"}, "no tree file");
  trouble({"tree", "gen:torus-knot", "--check", "none.tree"}, "no such file");
  trouble({"tree", "gen:torus-knot", "--save", "no-folder/a.tree"}, "no-folder");
  trouble({"tree", "shape.json", "--save", "shape.json"}, "no mesh");
  folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  trouble({"tree", "a.off", "--save", "a.off"}, "exists and is no tree file");
  trouble({"tree", "a.off", "--check", "a.off"}, "is no tree file");
}

/// Two rows of triangles: a node for all at even places and one for all at odd places.
std::string gltf_of_rows() {
  std::string nodes, children[2];
  for (int i = 0; i < 12; ++i) {
    nodes += R"(, {"mesh": 0, "translation": [)" + std::to_string(3 * i) + ", 0, 0]}";
    children[i % 2] += (children[i % 2].empty() ? "" : ", ") + std::to_string(i + 3);
  }
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [
    {"name": "all", "children": [1, 2]}, {"name": "even", "children": [)" +
         children[0] + R"(]}, {"name": "odd", "children": [)" + children[1] + "]}" + nodes + R"(],
    "meshes": [{"name": "part", "primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAIA/"}]})";
}

TEST(InspectHierarchy, TellsWhatRebalancingGains) {
  const TemporaryFolder folder;
  folder.write("rows.gltf", gltf_of_rows());
  const auto table = run_command({"inspect", "rows.gltf", "--hierarchy"}, folder.path());
  EXPECT_EQ(table.exit_code, 0) << table.err;
  for (const char* part : {"over 12 objects", "as it is", "cured", "rebuilt", "N_bv", "times cheaper"})
    EXPECT_TRUE(tree_says(table.out, part)) << table.out;
  const Json json = Json::parse(run_command({"inspect", "rows.gltf", "--hierarchy", "--json"}, folder.path()).out);
  EXPECT_EQ(json["schema"], "toccata/hierarchy/1");
  EXPECT_EQ(json["as_is"]["leaves"], 12);
  EXPECT_EQ(json["as_is"]["depth"], 3);
  EXPECT_EQ(json["as_is"]["levels"].size(), 4U);
  EXPECT_EQ(json["as_is"]["levels"][0]["overlapping_sibling_pairs"], 1);
  EXPECT_EQ(json["as_is"]["N_p"], 0);
  EXPECT_GT(json["as_is"]["F"], json["cured"]["F"]);
  EXPECT_GT(json["as_is"]["F"], json["rebuilt"]["F"]);
  EXPECT_EQ(json["unbounded_objects"], 0);
}

TEST(InspectHierarchy, ObjectsOfASceneFileAreSideBySide) {
  const TemporaryFolder folder;
  folder.write("balls.json", R"({"format": "toccata-scene", "version": 1, "objects": [
    {"name": "a", "shape": {"type": "sphere", "radius": 1}},
    {"name": "b", "shape": {"type": "sphere", "radius": 1, "centre": [1, 0, 0]}},
    {"name": "ground", "shape": {"type": "half-space", "normal": [0, 0, 1]}}]})");
  const Json json = Json::parse(run_command({"inspect", "balls.json", "--hierarchy", "--json"}, folder.path()).out);
  EXPECT_EQ(json["as_is"]["most_children"], 2);
  EXPECT_EQ(json["as_is"]["N_p"], 1);
  EXPECT_EQ(json["named_nodes"], 2);  // each has a node of its own
  EXPECT_EQ(json["unbounded_objects"], 1);
  EXPECT_EQ(run_command({"inspect", "balls.json", "--hierarchy", "--volumes"}, folder.path()).exit_code, 2);
}

}  // namespace
}  // namespace toccata
