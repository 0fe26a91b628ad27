#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "toccata/query/model.hpp"

namespace toccata {

/// Which triangles of a mesh meet at a vertex, those of equal coordinates taken as one, and which way is out of it.
class VertexFans {
 public:
  VertexFans() = default;
  explicit VertexFans(const Model& model);

  /// The corners as they are numbered here, in the order of the triangle's corners.
  [[nodiscard]] const std::array<Index, 3>& corners(Index triangle) const { return corners_[triangle]; }

  /// Ascending.
  [[nodiscard]] std::span<const Index> triangles_at(Index vertex) const {
    return std::span(triangles_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }

  /// −1 where the normal of a triangle of a closed mesh, by the order of its corners, points inwards; else 1. Connected
  /// parts may differ.
  [[nodiscard]] double turn(Index triangle) const {
    return turn_of_part_.empty() ? 1 : turn_of_part_[part_of_triangle_[triangle]];
  }

  /// About, of a mesh of so many triangles.
  [[nodiscard]] static std::size_t bytes_for(std::size_t triangles) { return 26 * triangles; }

 private:
  std::vector<std::array<Index, 3>> corners_;
  std::vector<Index> first_{0};
  std::vector<Index> triangles_;
  std::span<const Index> part_of_triangle_;  ///< the model's
  std::vector<std::int8_t> turn_of_part_;
};

}  // namespace toccata
