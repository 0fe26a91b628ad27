#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace toccata::io {

enum class PlyEncoding { ascii, binary_little_endian, binary_big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] constexpr std::size_t size_of(PlyType type) {
  constexpr std::size_t size[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return size[static_cast<std::size_t>(type)];
}
[[nodiscard]] bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type;  ///< of a list, before its values
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::size_t line = 0;  ///< of its declaration
  std::vector<PlyProperty> properties;
};

/// What stands before the values in a PLY file (G. Turk, "The PLY polygon file format", 1994).
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t body_offset = 0;  ///< the byte where the values begin
  std::size_t body_line = 0;    ///< and its line
};

/// Throws Error naming file and line.
[[nodiscard]] PlyHeader parse_ply_header(std::span<const char> bytes, std::string_view name);

}  // namespace toccata::io
