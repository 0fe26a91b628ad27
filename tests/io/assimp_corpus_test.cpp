// Debian's assimp-testmodels: many files, some broken on purpose. Each loads or is refused with a message.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "io/formats/file_bytes.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/model_file.hpp"

namespace toccata {
namespace {

namespace fs = std::filesystem;

const fs::path assimp_corpus = "/usr/share/assimp/models";

std::vector<fs::path> mesh_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(assimp_corpus)) {
    const std::string extension = io::lower_case_extension(entry.path());
    if (extension == ".obj" || extension == ".stl" || extension == ".ply" || extension == ".off")
      files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// Those that hold no mesh, and what is wrong in them. Looked at by hand, each.
struct Refused {
  std::string file, message;
};
const std::vector<Refused> refused = {
    {"OBJ/box_UTF16BE.obj", ": this is UTF-16 text; "},
    {"OBJ/number_formats.obj", ":11: the z coordinate \"3.1+e2\" is not a finite decimal number; "},
    {"OBJ/point_cloud.obj", ": there is no face in it (3 vertices); "},
    {"OBJ/testline.obj", ": there is no face in it (8 vertices); "},
    {"OBJ/testpoints.obj", ": there is no face in it (8 vertices); "},
    {"OFF/invalid.off", ":2: the file is too short for 3 vertices and 4 faces; "},
    {"PLY/issue623.ply", ":14: the length of a list \"7.941797\" is not an integer; "},
    {"PLY/points.ply", ": there is no face in it (4 vertices); "},
    {"PLY/pond.0.ply", ":3: the file is too short for 70051 elements \"vertex\"; "},
    {"invalid/OutOfMemory.off", ":2: the number of vertices is 353535235358; "},
    {"invalid/empty.obj", ": the file is empty; "},
    {"invalid/empty.off", ": the file is empty; "},
    {"invalid/empty.ply", ": the file is empty; "},
    {"invalid/malformed.obj", ":28: a face names vertex 0; "},
    {"invalid/malformed2.obj", ":23: a face has 0 corners; "},
};

std::string expected_message(const fs::path& path) {
  const auto found = std::ranges::find(refused, path.lexically_relative(assimp_corpus).string(), &Refused::file);
  return found == refused.end() ? "" : path.string() + found->message;
}

TEST(AssimpCorpus, EveryFileLoadsOrIsRefusedForItsReason) {
  if (!fs::is_directory(assimp_corpus)) GTEST_SKIP() << "install assimp-testmodels";
  int loaded = 0;
  for (const fs::path& path : mesh_files()) {
    const std::string expected = expected_message(path);
    try {
      const TriangleMesh mesh = read_mesh(path);
      EXPECT_GT(mesh.triangle_count(), 0u) << path;
      EXPECT_EQ(expected, "") << path << " was loaded";
      ++loaded;
    } catch (const Error& error) {
      ASSERT_NE(expected, "") << error.what();
      EXPECT_EQ(std::string(error.what()).substr(0, expected.size()), expected);
    }
  }
  EXPECT_GE(loaded, 32);
}

}  // namespace
}  // namespace toccata
