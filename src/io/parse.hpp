#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::io {

// The readers of each format over bytes in memory. `name` is what messages call the file. They return meshes whose
// numbers are finite, whose indices are in range and whose faces have three corners or more; or throw Error.

/// The largest number of vertices, and of corners of all faces together, that an Index can count.
inline constexpr std::size_t most_elements = 0xFFFFFFFF;

[[nodiscard]] PolygonMesh parse_obj(std::span<const char> bytes, std::string_view name);

/// Chooses the reader by the content, or by the extension (lower case, with its point) where the content has no
/// signature, and triangulates.
[[nodiscard]] TriangleMesh parse_mesh(std::span<const char> bytes, std::string_view name, std::string_view extension);

}  // namespace toccata::io
