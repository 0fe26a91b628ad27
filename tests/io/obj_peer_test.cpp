// The topology of real OBJ files compared with tinyobjloader's; it rounds coordinates otherwise.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#if __has_include(<tiny_obj_loader.h>)
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include "io/formats/file_bytes.hpp"
#include "io/formats/parse.hpp"
#include "support/data.hpp"

namespace toccata {
namespace {

struct PeerMesh {
  PolygonMesh mesh;
  bool valid = false;
};

PeerMesh read_by_peer(const std::filesystem::path& path) {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  const std::string folder = path.parent_path().string() + "/";
  PeerMesh result;
  result.valid = tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, path.c_str(), folder.c_str(),
                                  /*triangulate=*/false, /*default_vcols_fallback=*/false);
  for (std::size_t i = 0; i + 2 < attributes.vertices.size(); i += 3)
    result.mesh.vertices.push_back({attributes.vertices[i], attributes.vertices[i + 1], attributes.vertices[i + 2]});
  for (const tinyobj::shape_t& shape : shapes) {
    std::size_t corner = 0;
    for (const auto corners : shape.mesh.num_face_vertices) {
      for (std::size_t i = 0; i < corners; ++i)
        result.mesh.corners.push_back(static_cast<Index>(shape.mesh.indices[corner++].vertex_index));
      result.mesh.first.push_back(static_cast<Index>(result.mesh.corners.size()));
    }
  }
  return result;
}

void expect_close(const std::vector<Vec3>& ours, const std::vector<Vec3>& peers) {
  ASSERT_EQ(ours.size(), peers.size());
  for (std::size_t i = 0; i < ours.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_NEAR(ours[i][axis], peers[i][axis], 1e-14 * std::abs(ours[i][axis])) << "vertex " << i;
}

TEST(ObjPeer, RealFilesHaveTheSameVerticesAndFaces) {
  const auto data = test::data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA";
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*data / "meshes")) {
    if (entry.path().extension() != ".obj") continue;
    const io::FileBytes bytes = io::read_file(entry.path());
    const PolygonMesh ours = io::parse_obj(bytes.span(), entry.path().string());
    const PeerMesh peer = read_by_peer(entry.path());
    ASSERT_TRUE(peer.valid) << entry.path();
    EXPECT_EQ(ours.corners, peer.mesh.corners) << entry.path();
    EXPECT_EQ(ours.first, peer.mesh.first) << entry.path();
    expect_close(ours.vertices, peer.mesh.vertices);
    ++files;
  }
  EXPECT_GT(files, 5);
}

}  // namespace
}  // namespace toccata
#else
TEST(ObjPeer, RealFilesHaveTheSameVerticesAndFaces) { GTEST_SKIP() << "install libtinyobjloader-dev"; }
#endif
