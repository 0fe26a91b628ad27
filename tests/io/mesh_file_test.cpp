#include "toccata/io/model_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "io/text_file.hpp"

namespace toccata {
namespace {

using test::message_of;
using test::TemporaryFolder;

std::string error_of_mesh(const std::filesystem::path& path) {
  return message_of([&] { static_cast<void>(read_mesh(path)); });
}

const std::string obj_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string off_triangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string stl_triangle =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
    "a\n";

TEST(MeshFile, FaceNumbersAreThoseOfTheFile) {
  const TemporaryFolder folder;
  const TriangleMesh mesh =
      read_mesh(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 4 3 2 1\nf 1 2 3\n"));
  EXPECT_EQ(mesh.triangle_count(), 5u);
  EXPECT_EQ(mesh.face_count(), 3u);
  EXPECT_EQ(mesh.face_of(3), 1u);
  EXPECT_EQ(mesh.face_of(4), 2u);
}

TEST(MeshFile, ContentWithASignatureOverridesTheExtension) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_mesh(folder.write("a.obj", off_triangle)).triangle_count(), 1u);
  EXPECT_EQ(read_mesh(folder.write("a.PLY", stl_triangle)).triangle_count(), 1u);
  EXPECT_EQ(read_mesh(folder.write("noextension", off_triangle)).triangle_count(), 1u);
  EXPECT_EQ(read_mesh(folder.write("a.OBJ", obj_triangle)).triangle_count(), 1u);
}

TEST(MeshFile, WhatCannotBeReadIsNamed) {
  const TemporaryFolder folder;
  const auto path = [&](const std::string& name) { return (folder / name).string(); };
  EXPECT_EQ(error_of_mesh(folder / "none.obj"),
            path("none.obj") + ": there is no such file; check the name and the folder");
  std::filesystem::create_directory(folder / "folder.obj");
  EXPECT_EQ(error_of_mesh(folder / "folder.obj"), path("folder.obj") + ": this is a directory; name a file in it");
  for (const char* name : {"empty.obj", "empty.stl", "empty.ply", "empty.off"})
    EXPECT_EQ(error_of_mesh(folder.write(name, "")), path(name) + ": the file is empty; export it again");
  EXPECT_EQ(
      error_of_mesh(folder.write("a.xyz", obj_triangle)),
      path("a.xyz") +
          ": the format \".xyz\" is not read as a mesh; use an OBJ, STL, PLY or OFF file with its usual extension");
  EXPECT_EQ(error_of_mesh(folder.write("obj", obj_triangle)),
            path("obj") +
                ": the format cannot be told without an extension; use an "
                "OBJ, STL, PLY or OFF file with its usual extension");
  EXPECT_EQ(error_of_mesh(folder.write("a.glb", "glTF")),
            path("a.glb") + ": this is a scene of posed objects, not one mesh; read it with read_scene");
  EXPECT_EQ(error_of_mesh(folder.write("a.ply", obj_triangle)),
            path("a.ply") +
                ":1: a PLY file begins with a line that says ply; check that the extension is that of the format");
  EXPECT_TRUE(error_of_mesh(folder.write("a.off", obj_triangle))
                  .starts_with(path("a.off") + ":1: an OFF file begins with OFF; "));
  EXPECT_TRUE(
      error_of_mesh(folder.write("a.stl", obj_triangle)).starts_with(path("a.stl") + ": this is no STL file: "));
  EXPECT_TRUE(error_of_mesh("/dev/null").starts_with("/dev/null: this is not a regular file; "));
}

/// Every double there is may be a coordinate; +0 and −0 keep their sign.
double any_finite_double(std::mt19937_64& random) {
  for (;;)
    if (const double value = std::bit_cast<double>(random()); value - value == 0) return value;
}

TriangleMesh random_mesh(std::mt19937_64& random) {
  std::vector<Vec3> vertices(50);
  for (Vec3& v : vertices) v = {any_finite_double(random), any_finite_double(random), any_finite_double(random)};
  vertices[0] = {-0.0, 5e-324, std::numeric_limits<double>::max()};
  std::vector<std::array<Index, 3>> triangles(80);
  for (auto& triangle : triangles)
    for (Index& corner : triangle) corner = static_cast<Index>(random() % vertices.size());
  return {std::move(vertices), std::move(triangles)};
}

std::vector<std::uint64_t> bits_of_corners(const TriangleMesh& mesh) {
  std::vector<std::uint64_t> bits;
  for (const auto& triangle : mesh.triangles())
    for (const Index corner : triangle)
      for (int axis = 0; axis < 3; ++axis) bits.push_back(std::bit_cast<std::uint64_t>(mesh.vertices()[corner][axis]));
  return bits;
}

TEST(MeshFile, WhatIsWrittenIsReadBackToTheBit) {
  const TemporaryFolder folder;
  std::mt19937_64 random(20263);
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl", "a.STL"}) {
    const TriangleMesh mesh = random_mesh(random);
    write_mesh(mesh, folder / name);
    const TriangleMesh again = read_mesh(folder / name);
    EXPECT_EQ(bits_of_corners(again), bits_of_corners(mesh)) << name;
    if (!std::string(name).ends_with("stl") && !std::string(name).ends_with("STL")) {
      EXPECT_TRUE(std::ranges::equal(again.triangles(), mesh.triangles())) << name;
      EXPECT_EQ(again.vertices().size(), mesh.vertices().size()) << name;
    }
  }
}

TEST(MeshFile, WritingLeavesTheFileOrNothing) {
  const TemporaryFolder folder;
  const TriangleMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  write_mesh(mesh, folder / "a.obj");
  write_mesh(mesh, folder / "a.obj");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / ""), {}), 1);

  const auto error = [&](const std::string& name) { return message_of([&] { write_mesh(mesh, folder / name); }); };
  EXPECT_EQ(error("a.txt"), (folder / "a.txt").string() +
                                ": the extension names no format that is written; use .obj, .off, .ply or .stl");
  EXPECT_TRUE(error("none/a.obj").starts_with((folder / "none/a.obj").string() + ": the file cannot be written: "));
  std::filesystem::create_directory(folder / "b.obj");
  EXPECT_TRUE(error("b.obj").starts_with((folder / "b.obj").string() + ": the file cannot be written: "));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / ""), {}), 2);
}

}  // namespace
}  // namespace toccata
