#pragma once

#include <span>
#include <vector>

#include "methods/minkowski/sum_operand.hpp"

namespace toccata {

/// Where an operand is farthest along a normal, and the half-edges there, a cycle that turns counter-clockwise round
/// the normal: a face's own, both of an edge, none of a vertex.
struct FarFeature {
  Index vertex = 0;
  Index first = 0;   ///< of the cycle
  Index second = 0;  ///< of an edge
  Index size = 0;

  [[nodiscard]] bool is_face() const { return size > 2; }
  [[nodiscard]] Index half_edge(Index i) const {
    const Index place = i % size;
    return is_face() ? first + place : place == 0 ? first : second;
  }
};

/// A corner of the sum of two polygons.
struct SumCorner {
  Index on_first = 0;
  Index on_second = 0;
};

/// The sum of a face and of what the other operand has farthest along the face's normal, an edge or a face: a polygon
/// in a plane. Edges are merged by their direction; parallel ones become one.
class FacetPolygon {
 public:
  FacetPolygon(const SumOperand& first, Index face, const SumOperand& second, const FarFeature& far);

  [[nodiscard]] std::span<const SumCorner> corners() const { return corners_; }

 private:
  [[nodiscard]] Sign turn(Index half_edge_of_first, Index half_edge_of_second) const;
  [[nodiscard]] bool same_way(Index half_edge_of_first, Index half_edge_of_second) const;
  [[nodiscard]] Index start(const FarFeature& far) const;
  void merge(const FarFeature& far);

  const SumOperand& first_;
  const SumOperand& second_;
  const SumOperand::Face& face_;
  int axis_ = 0;    ///< along which the normal has a component
  Sign upwards_{};  ///< its sign
  std::vector<SumCorner> corners_;
};

}  // namespace toccata
