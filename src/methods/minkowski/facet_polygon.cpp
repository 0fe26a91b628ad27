#include "methods/minkowski/facet_polygon.hpp"

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
  corners_.reserve(std::size_t{face_.size} + far.size);
  while ((upwards_ = normal_component(first, face, axis_)) == Sign::zero) ++axis_;
  merge(far);
}

/// Positive: the second edge's direction lies less than half a turn on from the first's.
Sign FacetPolygon::turn(Index half_edge_of_first, Index half_edge_of_second) const {
  return upwards_ *
         triple_product_sign(first_.along(half_edge_of_first), second_.along(half_edge_of_second), along_axis(axis_));
}

/// Whether two parallel edges point the same way.
bool FacetPolygon::same_way(Index half_edge_of_first, Index half_edge_of_second) const {
  const Difference e = first_.along(half_edge_of_first), f = second_.along(half_edge_of_second);
  for (int axis = 0; axis < 3; ++axis)
    if (e.head[axis] != e.tail[axis]) return (e.head[axis] > e.tail[axis]) == (f.head[axis] > f.tail[axis]);
  return false;
}

/// The place in the cycle of the first edge from the direction of the face's first edge on, which is less than half a
/// turn on: the one before it, if the cycle is that of a face, lies more than half a turn on.
Index FacetPolygon::start(const FarFeature& far) const {
  if (!far.is_face()) {
    const Sign sign = turn(face_.first, far.first);
    if (sign == Sign::zero) return same_way(face_.first, far.first) ? 0 : 1;
    return sign == Sign::positive ? 0 : 1;
  }
  Sign before = turn(face_.first, far.half_edge(far.size - 1));
  for (Index i = 0; i < far.size; ++i) {
    const Sign here = turn(face_.first, far.half_edge(i));
    if (before == Sign::negative && here != Sign::negative) return i;
    before = here;
  }
  return 0;  // does not happen: the edges of a face turn once round
}

// The next edges of both lie at most half a turn on from the last one taken, and not both at its ends; so equal
// directions are the only parallel ones that meet here.
void FacetPolygon::merge(const FarFeature& far) {
  const Index begin = start(far);
  const auto of_second = [&](Index i) { return far.half_edge(begin + i); };
  const auto of_first = [&](Index i) { return face_.first + i % face_.size; };
  for (Index i = 0, j = 0; i < face_.size || j < far.size;) {
    corners_.push_back({first_.half_edges()[of_first(i)].origin, second_.half_edges()[of_second(j)].origin});
    const Sign sign = i == face_.size ? Sign::negative
                      : j == far.size ? Sign::positive
                                      : turn(of_first(i), of_second(j));
    i += sign != Sign::negative;
    j += sign != Sign::positive;
  }
}

}  // namespace toccata
