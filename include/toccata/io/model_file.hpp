#pragma once

#include <memory>
#include <string>

#include "toccata/query/model.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// A mesh file (OBJ, STL, PLY, OFF), or "gen:<name>?<parameter>=<number>&…", made ready for questions. Files that hold
/// several posed objects are read with `read_scene` and made ready with `scene_models`. Throws Error like `read_mesh`.
[[nodiscard]] Model load_model(const std::string& path);

/// Reads OBJ, STL (ASCII or binary), PLY (ASCII, little or big endian, triangle strips) or OFF as one mesh. The format
/// is told by the content where it has a signature and by the extension otherwise. Every number is the double nearest
/// to the text. Throws Error naming file and line (or byte) for anything that is not a valid mesh.
[[nodiscard]] TriangleMesh read_mesh(const std::string& path);

/// Writes a mesh so that reading it gives the same doubles: OBJ, OFF, ASCII STL or PLY by the extension. The file is
/// complete or not there.
void write_mesh(const TriangleMesh& mesh, const std::string& path);

/// Writes the tree of a mesh's model (docs/reference/tree-file.md), some 40 bytes a triangle, so that another run need
/// not build it. The file is complete or not there. A tree file that is there is replaced; a link is followed.
/// Throws Error naming the file, for anything else that is there, and for a model that is no mesh.
void save_tree(const Model& model, const std::string& path);

/// The mesh made ready for questions with a tree that `save_tree` wrote for it, or for a mesh of the same vertices and
/// triangles: every answer has the same bits as with a tree built now. Throws Error naming the file when it is of
/// another mesh or version, damaged, or cut short. Whatever the file holds, a tree that is taken is right: that is
/// checked, in time proportional to the mesh.
[[nodiscard]] Model load_model(std::shared_ptr<const TriangleMesh> mesh, const std::string& tree);

}  // namespace toccata
