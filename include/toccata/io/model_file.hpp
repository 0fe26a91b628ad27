#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "toccata/core/parallel.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/model.hpp"
#include "toccata/shapes/scene.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// A mesh file (OBJ, STL, PLY, OFF), or "gen:<name>?<parameter>=<number>&…", made ready for questions. Files that hold
/// several posed objects are read with `read_scene` and made ready with `scene_models`. Throws Error like `read_mesh`.
[[nodiscard]] Model load_model(const std::string& path);

/// Reads OBJ, STL (ASCII or binary), PLY (ASCII, little or big endian, triangle strips) or OFF as one mesh. The format
/// is recognised by the content where it has a signature and by the extension otherwise. Every number is the double
/// nearest to the text. Corners of STL facets that have the same coordinates are one vertex. Throws Error naming file
/// and line (or byte) for anything that is not a valid mesh.
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

/// A folder of tree files from run to run: that of a mesh of 1000 triangles or more is found by the mesh's vertices and
/// triangles. No answer depends on what the folder holds, nor on whether there is one.
class TreeCache {
 public:
  /// Nothing is done yet.
  explicit TreeCache(std::string folder) : folder_(std::move(folder)) {}

  /// The models that `scene_models` makes, with the trees that the folder has. One that cannot be taken, as it is
  /// damaged or of another version, is reported in `warnings`, and another is built.
  [[nodiscard]] std::vector<SceneInstance> models(const Scene& scene, int threads = all_threads);

  /// Writes the trees that were built, each complete or not at all, and makes the folder for it; that this cannot be
  /// done is a warning.
  void save();

  [[nodiscard]] std::span<const std::string> warnings() const { return warnings_; }

 private:
  std::string folder_;
  std::vector<Model> built_;
  std::vector<std::string> warnings_;
};

/// Where a folder of trees has that of a mesh, whether it is there or not.
[[nodiscard]] std::string tree_path(const TriangleMesh& mesh, const std::string& folder);

}  // namespace toccata
