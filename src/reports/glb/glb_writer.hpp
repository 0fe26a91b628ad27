#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

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

/// A GLB file in the making (Khronos Group, "glTF 2.0 Specification", 2021). What is added gets a number, by which
/// other things name it.
class GlbWriter {
 public:
  /// A part of a mesh: a primitive, without its material.
  [[nodiscard]] Json add_part(const GlbPart& part, GlbMode mode);
  /// `colour` is sRGB, 0xRRGGBB; what covers less than 1 is seen through.
  std::size_t add_material(const std::string& name, unsigned colour, double cover);
  std::size_t add_mesh(Json mesh);
  std::size_t add_node(Json node);
  /// `width` numbers a key, 1, 3 or 4.
  std::size_t add_keys(std::span<const float> numbers, std::size_t width);
  void add_animation(Json animation);

  /// The whole file, which shows this node and what hangs on it. Throws Error when it would have 4 GiB or more.
  [[nodiscard]] std::string file(std::size_t root) const;

 private:
  std::size_t add_points(std::span<const std::array<float, 3>> points);
  std::size_t add_corners(std::span<const Index> corners, std::size_t points);
  template <class Number>
  std::size_t add_view(std::span<const Number> numbers, std::optional<int> target);
  std::size_t add_accessor(Json accessor);

  std::string bytes_;
  Json views_ = Json::array();
  Json accessors_ = Json::array();
  Json materials_ = Json::array();
  Json meshes_ = Json::array();
  Json nodes_ = Json::array();
  Json animations_ = Json::array();
};

}  // namespace toccata::io
