#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::io {

// The readers of each format over bytes in memory. `name` is what messages call the file. They return meshes whose
// numbers are finite, whose indices are in range and whose faces have three corners or more; or throw Error.

/// The largest number of vertices, and of corners of all faces together, that an Index can count.
inline constexpr std::size_t most_elements = 0xFFFFFFFF;

[[nodiscard]] PolygonMesh parse_obj(std::span<const char> bytes, std::string_view name);
[[nodiscard]] PolygonMesh parse_off(std::span<const char> bytes, std::string_view name);
[[nodiscard]] PolygonMesh parse_ply(std::span<const char> bytes, std::string_view name);
/// Every facet has three vertices of its own, as stored.
[[nodiscard]] TriangleMesh parse_stl(std::span<const char> bytes, std::string_view name);

/// A mesh among those of a file, and what it is called there; empty where it has no name.
struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

/// What stands under the same `o` and `g` of an OBJ file, as "object/group", with the vertices that it uses: in the
/// order in which they first have a face.
struct NamedPolygons {
  std::string name;
  PolygonMesh mesh;
};
[[nodiscard]] std::vector<NamedPolygons> parse_obj_parts(std::span<const char> bytes, std::string_view name);
/// The solids of a text file that have a facet; a binary one has one without a name.
[[nodiscard]] std::vector<NamedMesh> parse_stl_solids(std::span<const char> bytes, std::string_view name);

// Whether the bytes begin, or have the size, as in no other format. OBJ has no such sign.
[[nodiscard]] bool looks_like_off(std::span<const char> bytes);
[[nodiscard]] bool looks_like_ply(std::span<const char> bytes);
[[nodiscard]] bool looks_like_stl(std::span<const char> bytes);

/// Chooses the reader by the content, or by the extension (lower case, with its point) where the content has no
/// signature, and triangulates.
[[nodiscard]] TriangleMesh parse_mesh(std::span<const char> bytes, std::string_view name, std::string_view extension);

/// The same, in parts where the format has them.
[[nodiscard]] std::vector<NamedMesh> parse_mesh_parts(std::span<const char> bytes, std::string_view name,
                                                      std::string_view extension);

}  // namespace toccata::io
