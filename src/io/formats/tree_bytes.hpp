#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "toccata/shapes/triangle_mesh.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata::io {

/// The content of a tree file (docs/reference/tree-file.md) for the tree over a mesh.
[[nodiscard]] std::string tree_bytes(const WideBvh& tree, const TriangleMesh& mesh);

/// The tree in such bytes; what it holds is not yet looked at. Throws Error naming the file for bytes that are damaged,
/// of another version, or of another mesh.
[[nodiscard]] WideBvh parse_tree(std::span<const char> bytes, const TriangleMesh& mesh, std::string_view name);

/// Whether a file of these bytes was meant as a tree file: its first eight are those of one.
[[nodiscard]] bool begins_as_tree(std::string_view bytes);

/// Tells apart meshes with different vertices or triangles; −0 is 0.
[[nodiscard]] std::uint64_t digest_of(const TriangleMesh& mesh);

/// Sees every change within eight bytes that lie side by side from a multiple of eight on, and others but for one in
/// 2⁶⁴.
[[nodiscard]] std::uint64_t checksum_of(std::span<const char> bytes);

/// Where a file has its checksum, which is that of all bytes after it.
inline constexpr std::size_t tree_checksum_at = 16;

}  // namespace toccata::io
