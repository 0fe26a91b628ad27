#pragma once

#include <span>
#include <string>

#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::io {

/// A mesh that is written, and what it is called in the file; empty where it has no name.
struct WrittenMesh {
  std::string name;
  const TriangleMesh* mesh;
};

/// Writes meshes into one file, each under its name: as objects of OBJ and solids of ASCII STL; OFF and PLY have no
/// names, and hold one mesh of all triangles. Throws Error where the extension names none of these.
void write_mesh_file(std::span<const WrittenMesh> meshes, const std::string& path);

// Meshes as the text of a file. Numbers are the shortest that are read as the same double.

[[nodiscard]] std::string obj_text(std::span<const WrittenMesh> meshes);
[[nodiscard]] std::string off_text(std::span<const WrittenMesh> meshes);
[[nodiscard]] std::string ply_text(std::span<const WrittenMesh> meshes);
[[nodiscard]] std::string stl_text(std::span<const WrittenMesh> meshes);

[[nodiscard]] std::string obj_text(const TriangleMesh& mesh);

}  // namespace toccata::io
