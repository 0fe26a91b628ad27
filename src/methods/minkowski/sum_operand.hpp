#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/no_index.hpp"
#include "math/filter.hpp"
#include "toccata/math/predicates.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// The hull of the world vertices of a shape, or of their negatives, with its exact boundary, as the overlay of Gauss
/// maps reads it. A vertex of it is a region of the Gauss map, an edge an arc, a face a point.
class SumOperand {
 public:
  SumOperand(const PosedPolytope& shape, bool negated);

  struct HalfEdge {
    Vec3 along;  ///< target − origin, rounded
    Index origin, target, next, previous, twin;
    Index face;  ///< no_index: of a segment, which has no face
  };
  struct Face {
    Vec3 normal{};         ///< outwards, of any length, rounded
    double magnitude = 0;  ///< of what the normal was rounded from (math/filter.hpp)
    std::array<Index, 3> corners{};
    Index first = 0;  ///< half-edge
    Index size = 0;
  };

  [[nodiscard]] std::span<const Vec3> points() const { return points_; }
  /// The number of a point among the shape's vertices.
  [[nodiscard]] Index source(Index point) const { return source_[point]; }
  [[nodiscard]] int dimension() const { return dimension_; }
  [[nodiscard]] std::span<const HalfEdge> half_edges() const { return half_edges_; }
  [[nodiscard]] std::span<const Face> faces() const { return faces_; }
  /// The half-edges that start at the point, ascending; none of a single point.
  [[nodiscard]] std::span<const Index> leaving_all(Index point) const {
    return std::span(leaving_).subspan(first_leaving_[point], first_leaving_[point + 1] - first_leaving_[point]);
  }
  /// The first of them; no_index: of a single point.
  [[nodiscard]] Index leaving(Index point) const {
    return half_edges_.empty() ? no_index : leaving_[first_leaving_[point]];
  }
  [[nodiscard]] Index next_leaving(Index half_edge) const { return half_edges_[half_edges_[half_edge].twin].next; }

  [[nodiscard]] Difference along(Index half_edge) const {
    return {points_[half_edges_[half_edge].target], points_[half_edges_[half_edge].origin]};
  }
  /// Two edges that span a face's plane; their cross product is its outward normal, exactly.
  [[nodiscard]] std::array<Difference, 2> plane_of(Index face) const {
    const auto& [p, q, r] = faces_[face].corners;
    return {Difference{points_[q], points_[p]}, Difference{points_[r], points_[p]}};
  }

  /// (normal of this one's face) · (edge of the other), rounded.
  [[nodiscard]] double rounded_slope(Index face, const SumOperand& other, Index half_edge) const {
    return dot(faces_[face].normal, other.half_edges_[half_edge].along);
  }
  /// A rounded slope that is greater in magnitude has the sign of the exact one. The bound is that of
  /// `filtered_triple_product` for the longest edge, twice, for its own rounding.
  [[nodiscard]] double slope_error(Index face, const SumOperand& other) const {
    return 2 * filter::triple_product_bound * (faces_[face].magnitude * other.reach_ + filter::floor);
  }
  /// The sign of the slope, exactly.
  [[nodiscard]] Sign slope(Index face, const SumOperand& other, Index half_edge) const {
    const double value = rounded_slope(face, other, half_edge), error = slope_error(face, other);
    if (value > error) return Sign::positive;
    if (value < -error) return Sign::negative;
    return exact_slope(face, other, half_edge);
  }

 private:
  [[nodiscard]] Sign exact_slope(Index face, const SumOperand& other, Index half_edge) const;
  void take_hull(const HullTopology& topology, bool reversed);
  void list_leaving();
  void measure();

  std::vector<Vec3> points_;
  std::vector<Index> source_;
  std::vector<HalfEdge> half_edges_;
  std::vector<Face> faces_;
  std::vector<Index> first_leaving_;  ///< one more than points
  std::vector<Index> leaving_;        ///< of point i [first_leaving_[i], first_leaving_[i + 1])
  double reach_ = 0;                  ///< the greatest magnitude of a coordinate of an edge
  int dimension_ = 0;
};

}  // namespace toccata
