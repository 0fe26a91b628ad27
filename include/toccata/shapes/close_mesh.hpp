#pragma once

#include <cstddef>
#include <optional>

#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// What `close_mesh` has done, counted.
struct MeshRepair {
  std::size_t moved_vertices = 0;       ///< vertices of the boundary, moved onto another one within the gap
  std::size_t collapsed_triangles = 0;  ///< triangles two corners of which became one; they are gone
  std::size_t filled_holes = 0;
  std::size_t added_triangles = 0;  ///< that fill them; each is a face of its own, behind the others
  std::size_t open_holes = 0;       ///< that are wider, or whose boundary is no simple loop

  friend bool operator==(const MeshRepair&, const MeshRepair&) = default;
};

/// A mesh that is another one with its gaps closed.
struct RepairedMesh {
  TriangleMesh mesh;
  MeshRepair repair;
  bool closed = false;  ///< `is_closed(mesh)`
};

/// Closes the gaps of a mesh that are no wider than `gap`: vertices of the boundary within that distance of each other
/// become one, by which none moves farther; then every hole is filled that triangles can fill of which each is
/// somewhere no higher than that. Nothing else is changed: what is no boundary stays as it is, bit by bit, faces keep
/// their numbers, and a wider hole stays open. Where two sheets that are meant to be apart have boundaries as near,
/// these are joined. Throws Error when the gap is not positive and finite.
[[nodiscard]] RepairedMesh close_mesh(const TriangleMesh& mesh, double gap);

/// A gap by which `close_mesh` closes the mesh, at most twice the least of some twenty-five that are tried, from a
/// thousand-millionth to a fiftieth of its size: how far from closed it is. None where none of them does; 0 of a mesh
/// that is closed.
[[nodiscard]] std::optional<double> closing_gap(const TriangleMesh& mesh);

/// The number of loops or chains in which the boundary of the mesh hangs together: its holes, and the rims of what is
/// open.
[[nodiscard]] std::size_t boundary_count(const TriangleMesh& mesh);

}  // namespace toccata
