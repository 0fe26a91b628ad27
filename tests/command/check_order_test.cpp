// The order in which files are named and the number of threads change nothing of what `check` tells.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "support/command.hpp"
#include "support/data.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/math/pose.hpp"

namespace toccata {
namespace {

namespace fs = std::filesystem;
using test::run_command;
using test::TemporaryFolder;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

/// What a pair is told to be, without what depends on which of the two is a: a number is the same in either order.
Json told_of(const Json& pair) {
  const bool is_ascending = pair["a"] < pair["b"];
  const auto flipped = [](const std::string& way) -> std::string {
    if (way == "a_through_b" || way == "b_through_a") return way == "a_through_b" ? "b_through_a" : "a_through_b";
    return way == "a_in_b" ? "b_in_a" : way == "b_in_a" ? "a_in_b" : way;
  };
  const std::string containment = pair["containment"];
  Json told = {{"relation", pair["relation"]},
               {"containment", is_ascending ? containment : flipped(containment)},
               {"status", pair["status"]},
               {"side_unresolved", pair["side_unresolved"]}};
  if (pair.contains("piercing"))
    told["piercing"] = is_ascending ? pair["piercing"].get<std::string>() : flipped(pair["piercing"]);
  for (const char* const key : {"kind", "volume", "tolerance", "tolerance_by", "local_depth"})
    if (pair.contains(key)) told[key] = pair[key];
  for (const char* const key : {"distance", "penetration"})
    if (pair.contains(key) && !pair[key].is_null())
      told[key] = {pair[key]["lower"], pair[key]["upper"], pair[key]["status"]};
  for (const Json& region : pair.value("regions", Json::array()))
    told["regions"].push_back({region["face_pairs"], region["triangle_pairs"], region["depth"], region["depth_upper"],
                               region["lower"], region["upper"]});
  return told;
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

/// Asks in so many orders, each with 1, 2 and 4 threads, and returns what all told.
PairsByName expect_one_list(Words files, const Words& options, const fs::path& folder, int orders) {
  Random random(28);
  PairsByName expected;
  for (int order = 0; order < orders; ++order, shuffle(files, random)) {
    std::string with_one;
    for (const std::string threads : {"1", "2", "4"}) {
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
      EXPECT_EQ(pairs_in(run.out), expected) << "in order " << order;
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

TEST(CheckOrder, OfRealMeshesChangesNothing) {
  const auto data = test::data_folder();
  if (!data || !fs::exists(*data / "meshes")) GTEST_SKIP() << "set TOCCATA_DATA to the folder of real models";
  Words files;
  for (const fs::directory_entry& file : fs::directory_iterator(*data / "meshes"))
    files.push_back(file.path().string());
  std::sort(files.begin(), files.end());
  const PairsByName pairs = expect_one_list(files, {"--clearance", "0.25"}, ".", 3);
  EXPECT_GT(pairs.size(), 5U);
}

}  // namespace
}  // namespace toccata
