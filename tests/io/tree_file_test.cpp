#include "toccata/io/model_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "io/formats/tree_bytes.hpp"
#include "io/text_file.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {
namespace {

using test::bytes_of;
using test::message_of;
using test::TemporaryFolder;

std::shared_ptr<const TriangleMesh> shared(TriangleMesh mesh) {
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

std::shared_ptr<const TriangleMesh> knot() { return shared(generate_mesh("torus-knot")); }
std::shared_ptr<const TriangleMesh> noisy_ball() {
  return shared(generate_mesh("noise-sphere", {{"subdivisions", 1}}));
}

/// The pairs of triangles that meet.
std::vector<ItemPair> contacts_with_ball(const Model& model) {
  PairQuery query;
  query.pose_b = Pose::translation(0.9, 0.1, 0);
  std::vector<ItemPair> pairs;
  for (const Contact& contact : contacts(model, Model(noisy_ball()), query))
    pairs.push_back({contact.element_a, contact.element_b});
  return pairs;
}

/// The bytes with the checksum that they should have.
std::string with_checksum(std::string bytes) {
  const std::uint64_t checksum = io::checksum_of(bytes_of(bytes).subspan(io::tree_checksum_at + 8));
  for (std::size_t i = 0; i < 8; ++i) bytes[io::tree_checksum_at + i] = static_cast<char>(checksum >> 8 * i);
  return bytes;
}

TEST(TreeFile, WhatIsLoadedIsWhatWasBuilt) {
  const TemporaryFolder folder;
  for (const auto& mesh : {noisy_ball(), knot(), shared(generate_mesh("noise-sphere", {{"subdivisions", 6}}))}) {
    const Model built(mesh);
    save_tree(built, folder / "mesh.tree");
    const Model loaded = load_model(shared(TriangleMesh(*mesh)), folder / "mesh.tree");
    EXPECT_EQ(io::tree_bytes(loaded.wide_bvh(), *mesh), io::tree_bytes(built.wide_bvh(), *mesh));
    EXPECT_EQ(contacts_with_ball(loaded), contacts_with_ball(built));
    EXPECT_FALSE(contacts_with_ball(loaded).empty());
  }
}

TEST(TreeFile, ATreeThatWasRefittedIsSavedAsItIs) {
  const TemporaryFolder folder;
  const auto mesh = noisy_ball();
  std::vector<Vec3> vertices(mesh->vertices().begin(), mesh->vertices().end());
  for (Vec3& v : vertices) v.x += 0.1 * v.y * v.z;
  Model model(mesh);
  model.deform(vertices);
  save_tree(model, folder / "deformed.tree");
  const Model loaded = load_model(shared(mesh->with_vertices(vertices)), folder / "deformed.tree");
  EXPECT_EQ(loaded.wide_bvh().built_size, model.wide_bvh().built_size);
  EXPECT_EQ(io::tree_bytes(loaded.wide_bvh(), loaded.mesh()), io::tree_bytes(model.wide_bvh(), model.mesh()));
}

TEST(TreeFile, ItsChecksumIsWhereItSays) {
  const auto mesh = noisy_ball();
  const std::string bytes = io::tree_bytes(Model(mesh).wide_bvh(), *mesh);
  EXPECT_EQ(with_checksum(bytes), bytes);
}

TEST(TreeFile, AnyDamagedByteIsSeen) {
  const auto mesh = noisy_ball();
  const std::string bytes = io::tree_bytes(Model(mesh).wide_bvh(), *mesh);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    for (const int change : {0x01, 0x80}) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ change);
      const std::string message =
          message_of([&] { static_cast<void>(io::parse_tree(bytes_of(damaged), *mesh, "x.tree")); });
      ASSERT_EQ(message.rfind("x.tree: ", 0), 0U) << "byte " << i << ": " << message;
    }
}

TEST(TreeFile, DamageThatTheChecksumHidesIsRefusedOrHarmless) {
  const auto mesh = noisy_ball();
  const Model built(mesh);
  const std::string bytes = io::tree_bytes(built.wide_bvh(), *mesh);
  const auto right = contacts_with_ball(built);
  std::size_t refused = 0;
  for (std::size_t i = io::tree_checksum_at + 8; i < bytes.size(); ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ (1 << i % 8));
    damaged = with_checksum(damaged);
    const std::string message = message_of([&] {
      const Model model(mesh, io::parse_tree(bytes_of(damaged), *mesh, "x.tree"));
      ASSERT_EQ(contacts_with_ball(model), right) << "byte " << i;
    });
    refused += message.empty() ? 0 : 1;
  }
  // Boxes may grow, and lanes may change places with what they hold.
  EXPECT_GT(refused, bytes.size() / 2);
}

TEST(TreeFile, AFileCutShortAnywhereIsRefused) {
  const auto mesh = noisy_ball();
  const std::string bytes = io::tree_bytes(Model(mesh).wide_bvh(), *mesh);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::string text = bytes.substr(0, size);
    EXPECT_NE(message_of([&] { static_cast<void>(io::parse_tree(bytes_of(text), *mesh, "x.tree")); }), "") << size;
  }
  EXPECT_NE(message_of([&] { static_cast<void>(io::parse_tree(bytes_of(bytes + "x"), *mesh, "x.tree")); }), "");
}

TEST(TreeFile, ATreeOfAnotherMeshIsRefusedAndBothAreNamed) {
  const TemporaryFolder folder;
  save_tree(Model(noisy_ball()), folder / "ball.tree");
  const auto message = [&](const TriangleMesh& mesh) {
    return message_of([&] { static_cast<void>(load_model(shared(mesh), folder / "ball.tree")); });
  };
  EXPECT_NE(message(*knot()).find("of one of 80 triangles"), std::string::npos) << message(*knot());
  EXPECT_NE(message(*knot()).find("ball.tree"), std::string::npos);
  const auto own = noisy_ball();
  std::vector<Vec3> vertices(own->vertices().begin(), own->vertices().end());
  const std::vector<std::array<Index, 3>> triangles(own->triangles().begin(), own->triangles().end());
  EXPECT_EQ(message(TriangleMesh(vertices, triangles)), "");
  vertices[5].y += 1e-9;
  EXPECT_NE(message(TriangleMesh(vertices, triangles)).find("another mesh"), std::string::npos);
  vertices[5] = own->vertices()[5];
  std::vector<std::array<Index, 3>> turned = triangles;
  std::swap(turned[3][0], turned[3][1]);
  EXPECT_NE(message(TriangleMesh(vertices, turned)).find("another mesh"), std::string::npos);
}

TEST(TreeFile, MinusZeroIsZero) {
  const TriangleMesh plus({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const TriangleMesh minus({{-0.0, 0, -0.0}, {1, -0.0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  EXPECT_EQ(io::digest_of(plus), io::digest_of(minus));
  const TemporaryFolder folder;
  save_tree(Model(plus), folder / "one.tree");
  EXPECT_EQ(load_model(shared(minus), folder / "one.tree").element_count(), 1U);
}

TEST(TreeFile, BadInputIsToldByName) {
  const TemporaryFolder folder;
  const auto mesh = noisy_ball();
  const auto message = [&](const std::filesystem::path& path) {
    return message_of([&] { static_cast<void>(load_model(mesh, path)); });
  };
  EXPECT_NE(message(folder / "none.tree").find("no such file"), std::string::npos);
  EXPECT_NE(message(folder / ".").find("directory"), std::string::npos);
  EXPECT_NE(message(folder.write("empty.tree", "")).find("empty"), std::string::npos);
  EXPECT_NE(message(folder.write("a.obj", "v 0 0 0\n")).find("no tree file"), std::string::npos);
  std::string bytes = io::tree_bytes(Model(mesh).wide_bvh(), *mesh);
  bytes[8] = 2;
  EXPECT_NE(message(folder.write("new.tree", bytes)).find("version 2"), std::string::npos);
  EXPECT_THROW(static_cast<void>(load_model(nullptr, folder / "new.tree")), Error);
  EXPECT_THROW(save_tree(Model(mesh), folder / "no-folder" / "a.tree"), Error);
  EXPECT_THROW(save_tree(Model(Sphere(1)), folder / "a.tree"), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.tree"));
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A scene of two meshes, one of them twice, and of what has no tree.
Scene scene_to_keep() {
  Scene scene;
  for (const auto& mesh : {knot(), shared(generate_mesh("noise-sphere"))}) {
    SceneObject object;
    object.shape = mesh;
    scene.objects.push_back(object);
  }
  scene.objects.push_back(scene.objects[0]);
  scene.objects.emplace_back().shape = Sphere(1);
  scene.objects.emplace_back().shape = noisy_ball();  // too small to be kept
  return scene;
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

void expect_same_trees(const std::vector<SceneInstance>& models, const Scene& scene) {
  const std::vector<SceneInstance> built = scene_models(scene);
  ASSERT_EQ(models.size(), built.size());
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (!built[i].model.has_mesh()) continue;
    EXPECT_EQ(io::tree_bytes(models[i].model.wide_bvh(), models[i].model.mesh()),
              io::tree_bytes(built[i].model.wide_bvh(), built[i].model.mesh()));
  }
}

/// The first run builds and keeps, the second takes and writes nothing.
TEST(TreeCache, KeepsTreesFromRunToRun) {
  const TemporaryFolder folder;
  const Scene scene = scene_to_keep();
  const std::string place = folder / "new" / "trees";
  TreeCache first(place);
  expect_same_trees(first.models(scene), scene);
  EXPECT_FALSE(std::filesystem::exists(place));
  first.save();
  EXPECT_EQ(first.warnings().size(), 0U);
  const auto files = files_in(place);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_TRUE(std::filesystem::exists(tree_path(*knot(), place)));
  EXPECT_EQ(io::tree_bytes(load_model(knot(), tree_path(*knot(), place)).wide_bvh(), *knot()),
            content_of(tree_path(*knot(), place)));

  for (const auto& file : files) std::filesystem::last_write_time(file, std::filesystem::file_time_type{});
  TreeCache second(place);
  expect_same_trees(second.models(scene), scene);
  second.save();
  EXPECT_EQ(second.warnings().size(), 0U);
  for (const auto& file : files)
    EXPECT_EQ(std::filesystem::last_write_time(file), std::filesystem::file_time_type{}) << "written again";
}

TEST(TreeCache, WhatIsDamagedIsToldAndBuiltAnew) {
  const TemporaryFolder folder;
  const Scene scene = scene_to_keep();
  const std::filesystem::path path = tree_path(*knot(), folder / ".");
  const std::string whole = io::tree_bytes(Model(knot()).wide_bvh(), *knot());
  const auto after = [&](std::size_t byte) {
    std::string bytes = whole;
    bytes[byte] = static_cast<char>(bytes[byte] ^ 0x20);
    return bytes;
  };
  // The magic, the version, the digest, a block, cut short, another file, another mesh's tree.
  for (const std::string& damaged :
       {after(0), after(8), after(24), after(1000), whole.substr(0, 700), std::string("v 0 0 0"),
        io::tree_bytes(Model(noisy_ball()).wide_bvh(), *noisy_ball())}) {
    folder.write(path.filename().string(), damaged);
    TreeCache cache(folder / ".");
    expect_same_trees(cache.models(scene), scene);
    cache.save();
    ASSERT_EQ(cache.warnings().size(), 1U);
    EXPECT_NE(cache.warnings()[0].find(path.filename().string()), std::string::npos) << cache.warnings()[0];
    EXPECT_NE(cache.warnings()[0].find("the tree is built anew"), std::string::npos) << cache.warnings()[0];
    EXPECT_EQ(content_of(path), whole);
  }
}

TEST(TreeCache, AFolderThatCannotBeWrittenIsAWarning) {
  const TemporaryFolder folder;
  folder.write("file", "no folder");
  const Scene scene = scene_to_keep();
  TreeCache cache(folder / "file" / "trees");
  expect_same_trees(cache.models(scene), scene);
  cache.save();
  ASSERT_EQ(cache.warnings().size(), 1U);
  EXPECT_EQ(cache.warnings()[0].rfind("trees were not kept: ", 0), 0U) << cache.warnings()[0];
}

TEST(TreeFile, NothingButATreeIsWrittenOver) {
  const TemporaryFolder folder;
  const Model model(noisy_ball()), other(knot());
  const auto refused = [&](const std::filesystem::path& path) { return message_of([&] { save_tree(model, path); }); };
  folder.write("mesh.off", "OFF\n0 0 0\n");
  EXPECT_NE(refused(folder / "mesh.off").find("mesh.off: the file exists and is no tree file; choose another name"),
            std::string::npos);
  EXPECT_EQ(content_of(folder / "mesh.off"), "OFF\n0 0 0\n");
  EXPECT_NE(refused(folder.write("empty", "")).find("no tree file"), std::string::npos);
  std::filesystem::create_symlink("mesh.off", folder / "link.tree");
  EXPECT_NE(refused(folder / "link.tree").find("no tree file"), std::string::npos);

  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_NE(refused(folder / "pipe").find("no regular file"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_fifo(folder / "pipe"));
  EXPECT_NE(refused(folder / ".").find("no regular file"), std::string::npos);
  std::filesystem::create_symlink("loop", folder / "loop");
  EXPECT_NE(refused(folder / "loop"), "");

  save_tree(other, folder / "a.tree");
  save_tree(model, folder / "a.tree");
  EXPECT_EQ(content_of(folder / "a.tree"), io::tree_bytes(model.wide_bvh(), model.mesh()));
}

TEST(TreeFile, LinksAreFollowed) {
  const TemporaryFolder folder;
  const Model model(noisy_ball());
  std::filesystem::create_directory(folder / "far");
  std::filesystem::create_symlink("far/next.tree", folder / "near.tree");
  std::filesystem::create_symlink("end.tree", folder / "far/next.tree");
  for (int i = 0; i < 2; ++i) {  // where there is nothing, and where there is a tree
    save_tree(model, folder / "near.tree");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "near.tree"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "far/next.tree"));
    EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(folder / "far/end.tree")));
  }
  EXPECT_EQ(content_of(folder / "far/end.tree"), io::tree_bytes(model.wide_bvh(), model.mesh()));
}

TEST(TreeFile, AModelTakesOnlyATreeOfItsMesh) {
  const auto mesh = noisy_ball();
  const Model built(mesh);
  EXPECT_EQ(Model(mesh, built.wide_bvh()).element_count(), built.element_count());
  const std::string message = message_of([&] { Model(knot(), built.wide_bvh()); });
  EXPECT_NE(message.find("no tree over the mesh"), std::string::npos) << message;
  EXPECT_THROW(Model(std::shared_ptr<const TriangleMesh>(), built.wide_bvh()), Error);
}

}  // namespace
}  // namespace toccata
