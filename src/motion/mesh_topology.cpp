#include "motion/mesh_topology.hpp"

#include <algorithm>
#include <bit>
#include <compare>
#include <cstddef>

namespace toccata {
namespace {

/// Edge i of a triangle, at place 3 · triangle + i.
struct PlacedEdge {
  IndexPair ends;
  std::size_t place;
  friend constexpr auto operator<=>(const PlacedEdge&, const PlacedEdge&) = default;
};

/// The triangles' edges sorted by their ends, and for one edge that of the first triangle first.
std::vector<PlacedEdge> sorted_triangle_edges(std::span<const std::array<Index, 3>> triangles) {
  std::vector<PlacedEdge> all;
  all.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      if (from != to) all.push_back({{std::min(from, to), std::max(from, to)}, 3 * t + i});
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::size_t count_of_vertices(std::span<const std::array<Index, 3>> triangles) {
  Index greatest = 0;
  for (const auto& corners : triangles) greatest = std::max({greatest, corners[0], corners[1], corners[2]});
  return std::size_t{greatest} + 1;
}

/// Lets the triangles answer for what nobody else does, those first that have the most of it.
class Answering {
 public:
  Answering(std::vector<MeshTopology::OfTriangle>& triangles, std::size_t vertices, std::size_t edges)
      : triangles_(triangles), vertex_is_taken_(vertices), edge_is_taken_(edges) {}

  void share_out() {
    for (int wanted = 3; wanted >= 0; --wanted)
      for (MeshTopology::OfTriangle& triangle : triangles_)
        if (triangle.own_edges == 0 && std::popcount(free_edges(triangle)) == wanted) take(triangle);
  }

 private:
  [[nodiscard]] unsigned free_edges(const MeshTopology::OfTriangle& triangle) const {
    unsigned free = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (triangle.edge[i] != MeshTopology::no_edge && !edge_is_taken_[triangle.edge[i]]) free |= 1U << i;
    return free;
  }

  /// One after another: a triangle may have a corner or an edge twice.
  void take(MeshTopology::OfTriangle& triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto bit = static_cast<std::uint8_t>(1U << i);
      const bool is_edge = triangle.edge[i] != MeshTopology::no_edge;
      if (is_edge && take(edge_is_taken_, triangle.edge[i])) triangle.own_edges |= bit;
      if (take(vertex_is_taken_, triangle.corner[i])) triangle.own_vertices |= bit;
    }
  }

  /// Says whether it was free.
  static bool take(std::vector<bool>& taken, Index number) {
    const bool was_free = !taken[number];
    taken[number] = true;
    return was_free;
  }

  std::vector<MeshTopology::OfTriangle>& triangles_;
  std::vector<bool> vertex_is_taken_;
  std::vector<bool> edge_is_taken_;
};

}  // namespace

MeshTopology::MeshTopology(std::span<const std::array<Index, 3>> triangles_of_mesh)
    : triangles(triangles_of_mesh.begin(), triangles_of_mesh.end()) {
  for (const auto& corners : triangles) of_triangle.push_back({corners});
  for (const auto& [ends, place] : sorted_triangle_edges(triangles)) {
    if (edges.empty() || edges.back() != ends) edges.push_back(ends);
    of_triangle[place / 3].edge[place % 3] = static_cast<Index>(edges.size() - 1);
  }
  Answering(of_triangle, count_of_vertices(triangles), edges.size()).share_out();
}

}  // namespace toccata
