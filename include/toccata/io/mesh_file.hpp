#pragma once

#include <filesystem>

#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// Reads OBJ, STL (ASCII or binary), PLY (ASCII, little or big endian, triangle strips) or OFF as one mesh. The format
/// is told by the content where it has a signature and by the extension otherwise. Every number is the double nearest
/// to the text. Throws Error naming file and line (or byte) for anything that is not a valid mesh.
[[nodiscard]] TriangleMesh read_mesh(const std::filesystem::path& path);

/// Writes a mesh so that reading it gives the same doubles: OBJ, OFF, ASCII STL or PLY by the extension. The file is
/// complete or not there.
void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path);

}  // namespace toccata
