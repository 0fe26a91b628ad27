#include "narrow/minkowski/facet_polygon.hpp"

// All edges lie across the face's normal, so the cross product of two of them is along it: one coordinate tells its
// sense.
namespace toccata {
namespace {

Difference along_axis(int axis) {
  Difference unit{};
  unit.head[axis] = 1;
  return unit;
}

Sign normal_component(const SumOperand& operand, Index face, int axis) {
  const auto [u, v] = operand.plane_of(face);
  return triple_product_sign(u, v, along_axis(axis));
}

}  // namespace

FacetPolygon::FacetPolygon(const SumOperand& first, Index face, const SumOperand& second, const FarFeature& far)
    : first_(first), second_(second), face_(first.faces()[face]) {
  corners_.reserve(face_.size + far.cycle.size());
  if (far.cycle.empty()) {
    for (Index i = 0; i < face_.size; ++i) corners_.push_back({first.half_edges()[face_.first + i].origin, far.vertex});
    return;
  }
  while ((upwards_ = normal_component(first, face, axis_)) == Sign::zero) ++axis_;
  merge(far.cycle);
}

/// Positive: the second edge's direction lies less than half a turn on from the first's.
Sign FacetPolygon::turn(Index half_edge_of_first, Index half_edge_of_second) const {
  return upwards_ *
         triple_product_sign(first_.along(half_edge_of_first), second_.along(half_edge_of_second), along_axis(axis_));
}

/// Of parallel edges.
bool FacetPolygon::same_way(Index half_edge_of_first, Index half_edge_of_second) const {
  const Difference e = first_.along(half_edge_of_first), f = second_.along(half_edge_of_second);
  for (int axis = 0; axis < 3; ++axis)
    if (e.head[axis] != e.tail[axis]) return (e.head[axis] > e.tail[axis]) == (f.head[axis] > f.tail[axis]);
  return false;
}

/// The place in the cycle of the first edge from the direction of the face's first edge on, which is less than half a
/// turn on: the one before it, if the cycle is that of a face, lies more than half a turn on.
std::size_t FacetPolygon::start(std::span<const Index> cycle) const {
  if (cycle.size() == 2) {
    const Sign sign = turn(face_.first, cycle[0]);
    if (sign == Sign::zero) return same_way(face_.first, cycle[0]) ? 0 : 1;
    return sign == Sign::positive ? 0 : 1;
  }
  Sign before = turn(face_.first, cycle.back());
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const Sign here = turn(face_.first, cycle[i]);
    if (before == Sign::negative && here != Sign::negative) return i;
    before = here;
  }
  return 0;  // does not happen: the edges of a face turn once round
}

// The next edges of both lie at most half a turn on from the last one taken, and not both at its ends; so equal
// directions are the only parallel ones that meet here.
void FacetPolygon::merge(std::span<const Index> cycle) {
  const std::size_t begin = start(cycle);
  const auto of_second = [&](std::size_t i) { return cycle[(begin + i) % cycle.size()]; };
  const auto of_first = [&](std::size_t i) { return face_.first + static_cast<Index>(i % face_.size); };
  for (std::size_t i = 0, j = 0; i < face_.size || j < cycle.size();) {
    corners_.push_back({first_.half_edges()[of_first(i)].origin, second_.half_edges()[of_second(j)].origin});
    const Sign sign = i == face_.size     ? Sign::negative
                      : j == cycle.size() ? Sign::positive
                                          : turn(of_first(i), of_second(j));
    i += sign != Sign::negative;
    j += sign != Sign::positive;
  }
}

}  // namespace toccata
