#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/file_bytes.hpp"
#include "io/formats/json.hpp"
#include "toccata/core/index.hpp"

namespace toccata::io {

/// How the points of a part of a mesh are joined, by glTF's numbers.
enum class GlbMode { points = 0, lines = 1, triangles = 4 };

/// Points of a part of a mesh and, in `corners`, the numbers of those that are joined.
struct GlbPart {
  std::vector<std::array<float, 3>> points;
  std::vector<Index> corners;
};

/// A list of JSON, kept as text: many times smaller than its values.
class JsonList {
 public:
  /// Returns its place.
  std::size_t add(const Json& value);
  [[nodiscard]] std::size_t size() const { return size_; }
  /// The values, with commas between them.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t size_ = 0;
};

/// A GLB file in the making (Khronos Group, "glTF 2.0 Specification", 2021). What is added gets a number, by which
/// other things name it.
class GlbWriter {
 public:
  GlbWriter() = default;
  /// Coordinates and numbers of corners, the most of it, wait in a file without a name in the folder of this one, and
  /// not in memory.
  explicit GlbWriter(const std::filesystem::path& beside);

  /// A part of a mesh: a primitive, without its material.
  [[nodiscard]] Json add_part(const GlbPart& part, GlbMode mode);
  /// `colour` is sRGB, 0xRRGGBB; what covers less than 1 is seen through.
  std::size_t add_material(const std::string& name, unsigned colour, double cover);
  std::size_t add_mesh(const Json& mesh);
  std::size_t add_node(const Json& node);
  /// `width` numbers a key, 1, 3 or 4.
  std::size_t add_keys(std::span<const float> numbers, std::size_t width);
  void add_animation(const Json& animation);

  /// The whole file, which shows this node and what hangs on it; of a writer that keeps all in memory. Throws Error
  /// when it would have 4 GiB or more.
  [[nodiscard]] std::string file(std::size_t root) const;
  /// Writes the same, of any writer: the file is complete or not there. Throws Error naming it.
  void write(std::size_t root, const std::filesystem::path& path) const;

 private:
  /// All that comes before the bytes.
  [[nodiscard]] std::string head(std::size_t root) const;
  /// What the bytes lack of a multiple of four.
  [[nodiscard]] std::string filling() const;
  std::size_t add_points(std::span<const std::array<float, 3>> points);
  std::size_t add_corners(std::span<const Index> corners, std::size_t points);
  template <class Number>
  std::size_t add_view(std::span<const Number> numbers, std::optional<int> target);
  void add_bytes(std::string_view bytes);

  std::optional<FileInMaking> waiting_;  ///< the first of the bytes, where they wait in a file
  std::string bytes_;                    ///< the others
  std::size_t size_ = 0;                 ///< of all bytes
  JsonList views_, accessors_, materials_, meshes_, nodes_, animations_;
};

}  // namespace toccata::io
