#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "toccata/shapes/scene.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// Reads OBJ, STL (ASCII or binary), PLY (ASCII, little or big endian, triangle strips) or OFF as one mesh. The format
/// is told by the content where it has a signature and by the extension otherwise. Every number is the double nearest
/// to the text. Throws Error naming file and line (or byte) for anything that is not a valid mesh.
[[nodiscard]] TriangleMesh read_mesh(const std::filesystem::path& path);

/// Reads any supported file as a scene: a mesh file as one object named after the file, glTF and GLB as the posed
/// meshes of their node tree, and a scene file (.json, docs/reference/scene-file.md) with all it names.
[[nodiscard]] Scene read_scene(const std::filesystem::path& path);

/// Writes a mesh so that reading it gives the same doubles: OBJ, OFF, ASCII STL or PLY by the extension. The file is
/// complete or not there.
void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path);

}  // namespace toccata
