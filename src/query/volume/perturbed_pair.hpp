#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "query/contacts/surface_within.hpp"
#include "query/meshes/posed_mesh.hpp"

// Two solids after the first was moved by (δ, ε, ε²), where δ is infinitely small and ε infinitely smaller: then no
// vertex of one lies in the plane of a triangle of the other, no two edges meet, and what the two have in common has
// the same volume. Symbolic perturbation after H. Edelsbrunner, E. P. Mücke, "Simulation of simplicity", 1990.
namespace toccata {

/// Which of two solids is meant: the first is the one that was moved.
enum class VolumeSide { first, second };

/// Where the edges of two triangles pass through the other triangle. Edge i leads from vertex i to the next. +1: from
/// the side to which the other's normal points to the other side; −1: back; 0: not through it.
struct EdgesThrough {
  std::array<int, 3> of_first{};
  std::array<int, 3> of_second{};

  /// Then exactly two of the six pass, as ends of the one segment that the triangles have in common.
  [[nodiscard]] bool any() const;
};

/// The order in which two meshes are looked at does not depend on that in which they are named, and so what is
/// disturbed does not.
[[nodiscard]] bool comes_first(const PosedMesh& a, const PosedMesh& b);

/// Exact. Preconditions: both have area.
[[nodiscard]] EdgesThrough perturbed_edges_through(const Triangle& first, const Triangle& second);

/// Where an edge passes through a triangle of the other mesh: its ends, the lesser first, as the graph of its mesh
/// numbers them.
struct EdgePass {
  VolumeSide side = VolumeSide::first;  ///< of the edge
  std::array<Index, 2> edge{};
  Index triangle = 0;
  friend auto operator<=>(const EdgePass&, const EdgePass&) = default;
};

/// The curves along which two surfaces cross, by the segments that their triangles have in common.
class CrossingCurves {
 public:
  /// The graphs are those of the two meshes.
  void add(VertexGraph& first, Index of_first, VertexGraph& second, Index of_second, const EdgesThrough& through);

  /// How many they are: of closed meshes each is closed.
  [[nodiscard]] std::size_t count() const;

 private:
  [[nodiscard]] Index end_at(const EdgePass& pass);

  std::map<EdgePass, Index> ends_;
  std::vector<std::pair<Index, Index>> segments_;
};

/// How often the closed mesh winds around the point, a vertex of the solid of that side; the mesh is of the other.
/// Exact.
[[nodiscard]] int perturbed_winding(const Vec3& point, VolumeSide side, const PosedMesh& mesh);

}  // namespace toccata
