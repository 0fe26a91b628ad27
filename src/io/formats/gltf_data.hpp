#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/formats/json_value.hpp"
#include "io/scenes/scene_parts.hpp"
#include "toccata/core/index.hpp"

namespace toccata::io {

/// The two parts of a GLB file, or a glTF file as its text alone.
struct GltfChunks {
  std::span<const char> text;
  std::optional<std::span<const char>> binary;
};

[[nodiscard]] GltfChunks split_glb(const SceneBytes& source);

/// The numbers of a glTF file: buffers, views and accessors, each checked against what it lies in before it is read.
class GltfData {
 public:
  /// `top`, and what `source` and `chunks` point to, must outlive this.
  GltfData(const JsonValue& top, const SceneBytes& source, const GltfChunks& chunks);

  /// The numbers of an accessor of a type, as "VEC4", element by element. Floats are widened exactly; whole numbers
  /// (KHR_mesh_quantization) are taken as they are, or divided by the greatest of their type when normalised.
  [[nodiscard]] std::vector<double> numbers(std::size_t accessor, std::string_view type);
  /// The elements of a VEC3 accessor.
  [[nodiscard]] std::vector<Vec3> vectors(std::size_t accessor);
  /// The elements of a SCALAR accessor of unsigned whole numbers.
  [[nodiscard]] std::vector<Index> indices(std::size_t accessor);

  [[nodiscard]] std::size_t accessor_count() const { return accessors_.size(); }

  /// Takes `elements` from what a file of this size may ask for: every number that is read, and every corner that is
  /// made of those. Throws Error at `place` when that is used up, so call it before making them.
  void spend(const JsonValue& place, std::size_t elements);

 private:
  struct Layout;

  [[nodiscard]] std::span<const char> buffer(std::size_t index);
  [[nodiscard]] std::span<const char> external_buffer(const JsonValue& uri);
  [[nodiscard]] std::span<const char> view(const JsonValue& place, std::size_t index);
  [[nodiscard]] Layout layout_of(const JsonValue& accessor, std::size_t components);
  [[nodiscard]] std::vector<double> read(std::size_t accessor, std::size_t components);
  void apply_sparse(const JsonValue& accessor, const Layout& layout, std::vector<double>& values);

  const SceneBytes& source_;
  std::optional<std::span<const char>> binary_;
  std::vector<JsonValue> buffers_, views_, accessors_;
  std::map<std::size_t, std::span<const char>> resolved_;         ///< the bytes of the buffers that were asked for
  std::vector<std::vector<char>> loaded_;                         ///< the bytes of those that are not the GLB's own
  std::map<std::filesystem::path, std::span<const char>> files_;  ///< those of loaded_ that are files
  std::size_t budget_;  ///< elements that may still be asked for: a small file must not fill the memory
};

}  // namespace toccata::io
