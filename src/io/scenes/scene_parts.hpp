#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "io/formats/json_value.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata::io {

/// The bytes of a file, what it is called in messages, and the folder that the names in it start from.
struct SceneBytes {
  std::span<const char> bytes;
  std::string file;
  std::filesystem::path folder;
};

/// A glTF or GLB file as its posed meshes, in metres.
[[nodiscard]] Scene parse_gltf(const SceneBytes& source);

/// A scene file, docs/reference/scene-file.md.
[[nodiscard]] Scene parse_scene_file(const SceneBytes& source);

/// The same of what is parsed; names in it start from the folder.
[[nodiscard]] Scene scene_of(const JsonValue& top, const std::filesystem::path& folder);

/// Whether what a mesh file holds is one object.
enum class MeshFileIs { one_object, its_parts };

/// A file that holds shapes but no scene file: a mesh as one object, or as its parts, at the identity; or a glTF.
[[nodiscard]] Scene read_shapes(const std::filesystem::path& path, MeshFileIs mesh_file = MeshFileIs::one_object);

[[nodiscard]] bool is_gltf(const std::filesystem::path& path);

/// What a world unit is, by what a scene calls it; none where the scene does not say, or in words of its own.
[[nodiscard]] std::optional<double> unit_in_metres(std::string_view unit);

/// Whether a factor between units, or what is left of one after a product, still scales: positive, finite, and of full
/// precision. A product of sensible factors may be 0 or infinite.
[[nodiscard]] bool is_scale(double factor);

/// Whether `after`, which is `before` times such factors, has lost the size of what it poses.
[[nodiscard]] bool is_collapsed(const Pose& before, const Pose& after);

/// Tells names apart: gives `name`, or "name #2", "name #3" … whichever is free.
class UniqueNames {
 public:
  std::string make(const std::string& name);

 private:
  std::map<std::string, int> uses_;  ///< how often a name was asked for, or 1 when it came about by a number
};

}  // namespace toccata::io
