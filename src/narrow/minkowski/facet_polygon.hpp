#pragma once

#include <span>
#include <vector>

#include "narrow/minkowski/sum_operand.hpp"

namespace toccata {

/// Where an operand is farthest along a normal: the edges there in a cycle that turns counter-clockwise round the
/// normal. A face has all of its own, an edge both half-edges, a vertex none.
struct FarFeature {
  Index vertex = 0;
  std::vector<Index> cycle;
};

/// A corner of the sum of two polygons.
struct PolygonCorner {
  Index on_first = 0;
  Index on_second = 0;
};

/// The sum of a face and of what the other operand has farthest along the face's normal: a polygon in a plane. Edges
/// are merged by their direction; parallel ones become one.
class FacetPolygon {
 public:
  FacetPolygon(const SumOperand& first, Index face, const SumOperand& second, const FarFeature& far);

  [[nodiscard]] std::span<const PolygonCorner> corners() const { return corners_; }

 private:
  [[nodiscard]] Sign turn(Index half_edge_of_first, Index half_edge_of_second) const;
  [[nodiscard]] bool same_way(Index half_edge_of_first, Index half_edge_of_second) const;
  [[nodiscard]] std::size_t start(std::span<const Index> cycle) const;
  void merge(std::span<const Index> cycle);

  const SumOperand& first_;
  const SumOperand& second_;
  const SumOperand::Face& face_;
  int axis_ = 0;    ///< along which the normal has a component
  Sign upwards_{};  ///< its sign
  std::vector<PolygonCorner> corners_;
};

}  // namespace toccata
