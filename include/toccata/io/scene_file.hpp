#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/shapes/scene.hpp"

namespace toccata {

/// How the numbers of a file become world units.
struct ReadOptions {
  /// What a length of 1 in the file is, in metres; the world's unit is then the metre. Not given: glTF is metres as its
  /// standard says, other meshes keep their numbers. A scene file states its units itself: giving one is an Error.
  std::optional<double> metres_per_unit = std::nullopt;
  /// Multiplies everything in the file, poses included; positive and finite, as is its product with the unit, which
  /// must also keep the full precision of a double (2.3e-308 or more): it is an Error when a shape would collapse.
  double scale = 1;
  /// The objects and groups of an OBJ file and the solids of a text STL file are objects of their own, by the names
  /// that they have there; each is numbered by itself. Else such a file is one object.
  bool split = false;
};

/// Reads any supported file as a scene: a mesh file as one object named after the file, glTF and GLB as the posed
/// meshes of their node tree, a scene file (.json, docs/reference/scene-file.md) with all it names, and
/// "gen:<name>?<parameter>=<number>&…" as that generated mesh (generate/meshes.hpp). Object names are unique
/// and UTF-8; a byte of a file name that is not becomes \xff, in hexadecimal. Objects
/// from the same mesh share it. Throws Error naming the file, and the line or the place in it.
[[nodiscard]] Scene read_scene(const std::string& path, const ReadOptions& options = {});

/// What a file holds that comes from elsewhere.
struct FileContent {
  std::span<const char> bytes;
  std::string name;    ///< what messages call it; an object that has no name is called so
  std::string format;  ///< the extension that such a file has: "obj", "stl", "ply", "off", "gltf", "glb" or "json"
};

/// The same of a file that is in memory. Names of other files in it begin at the current folder.
[[nodiscard]] Scene read_scene(const FileContent& content, const ReadOptions& options = {});

/// The scene with everything in it so many times as large, as `ReadOptions::scale` makes it. Throws Error naming an
/// object that shrinks to nothing or grows beyond the doubles.
[[nodiscard]] Scene scaled(Scene scene, double factor);

/// Writes the scene as `folder`/scene.json with every mesh once as an OBJ file beside it. Reading it gives the same
/// objects with the same doubles; the node tree is not written. Names and groups must be UTF-8, and names unique:
/// otherwise an Error naming the object, before anything is written. The folder is complete or not there: it must not
/// exist or be empty.
void write_scene(const Scene& scene, const std::string& folder);

/// One sentence for every mesh whose box diagonal in the world is 500 times the median of the scene's meshes or more,
/// or as much less: a unit is probably missing. And one where the unit is known and all meshes together are more than
/// 1 km across, or less than 0.1 mm.
[[nodiscard]] std::vector<std::string> scale_warnings(const Scene& scene);

/// Metres per unit of "mm", "cm", "m", "km", "in", "ft", or of a positive number written out. Throws Error otherwise.
[[nodiscard]] double metres_per_unit(std::string_view unit);

}  // namespace toccata
