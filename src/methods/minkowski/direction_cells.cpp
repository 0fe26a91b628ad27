#include "methods/minkowski/direction_cells.hpp"

#include <algorithm>
#include <cmath>

namespace toccata {
namespace {

constexpr double slack_of_sines = 0x1p-18;  ///< of sines of angles

/// Side 2 · axis is that of the positive axis, and 2 · axis + 1 of the negative; the next two axes are u and v.
Vec3 direction_at(int side, double u, double v) {
  const int axis = side / 2;
  Vec3 direction;
  direction[axis] = side % 2 == 0 ? 1 : -1;
  direction[(axis + 1) % 3] = u;
  direction[(axis + 2) % 3] = v;
  return direction;
}

/// A square's own cone: its corners, and the planes through its edges, inwards.
struct SquareCone {
  std::array<Vec3, 4> corners;
  std::array<Vec3, 4> walls;
};

SquareCone cone_of(int side, double u, double v, double width) {
  SquareCone cone{{direction_at(side, u, v), direction_at(side, u + width, v), direction_at(side, u + width, v + width),
                   direction_at(side, u, v + width)},
                  {}};
  const Vec3 middle = direction_at(side, u + width / 2, v + width / 2);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 n = cross(cone.corners[i], cone.corners[(i + 1) % 4]);
    cone.walls[i] = (std::copysign(1.0, dot(n, middle)) / std::sqrt(dot(n, n))) * n;
  }
  return cone;
}

/// False only where a plane parts the two, with room to spare.
bool may_meet(const DirectionCone& cone, const SquareCone& square) {
  const auto parts = [](const Vec3& wall, const auto& corners) {
    return std::ranges::all_of(corners,
                               [&](const Vec3& c) { return dot(wall, c) < -slack_of_sines * std::sqrt(dot(c, c)); });
  };
  const auto parts_square = [&](const Vec3& wall) { return parts(wall, square.corners); };
  const auto parts_cone = [&](const Vec3& wall) { return parts(wall, cone.corners); };
  return std::ranges::none_of(cone.walls, parts_square) && std::ranges::none_of(square.walls, parts_cone);
}

}  // namespace

DirectionCells::DirectionCells(std::span<const DirectionCone> cones) {
  constexpr Index row = 1U << depth_of_roots;
  roots_.assign(std::size_t{6} * row * row, 0);
  std::vector<Index> all(cones.size());
  for (Index i = 0; i < cones.size(); ++i) all[i] = i;
  cells_.resize(6);
  for (int side = 0; side < 6; ++side) fill(cones, {side, 0, 0, 0}, static_cast<Index>(side), all);
}

void DirectionCells::fill(std::span<const DirectionCone> cones, const Square& square, Index cell,
                          std::vector<Index> list) {
  const double width = std::ldexp(2.0, -square.depth);
  const SquareCone own = cone_of(square.side, square.u * width - 1, square.v * width - 1, width);
  std::erase_if(list, [&](Index i) { return !may_meet(cones[i], own); });
  if (square.depth == depth_of_roots)
    roots_[(static_cast<Index>(square.side) << (2 * depth_of_roots)) + (square.v << depth_of_roots) + square.u] = cell;
  if (square.depth < depth_of_roots || (list.size() > few && square.depth < greatest_depth)) {
    divide(cones, square, cell, list);
    return;
  }
  cells_[cell] = {static_cast<Index>(lists_.size()), static_cast<Index>(list.size())};
  lists_.insert(lists_.end(), list.begin(), list.end());
}

void DirectionCells::divide(std::span<const DirectionCone> cones, const Square& square, Index cell,
                            const std::vector<Index>& list) {
  const Index first = static_cast<Index>(cells_.size());
  cells_[cell] = {first, divided};
  cells_.resize(cells_.size() + 4);
  for (Index child = 0; child < 4; ++child)
    fill(cones, {square.side, square.depth + 1, 2 * square.u + (child & 1), 2 * square.v + (child >> 1)}, first + child,
         list);
}

std::span<const Index> DirectionCells::cones_around(const Vec3& direction) const {
  const double x = std::fabs(direction.x), y = std::fabs(direction.y), z = std::fabs(direction.z);
  const int axis = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
  const double half_row = 1 << (greatest_depth - 1), along = std::fabs(direction[axis]);
  constexpr Index last = (1U << greatest_depth) - 1;
  const auto place = [&](double across) {
    return std::min(static_cast<Index>(half_row * (across / along) + half_row), last);
  };
  const Index u = place(direction[(axis + 1) % 3]), v = place(direction[(axis + 2) % 3]);
  const Index side = 2 * static_cast<Index>(axis) + (direction[axis] < 0);
  int shift = greatest_depth - depth_of_roots;
  Cell cell = cells_[roots_[(side << (2 * depth_of_roots)) + ((v >> shift) << depth_of_roots) + (u >> shift)]];
  while (cell.count == divided) {
    --shift;
    cell = cells_[cell.first + ((u >> shift) & 1) + 2 * ((v >> shift) & 1)];
  }
  return std::span(lists_).subspan(cell.first, cell.count);
}

}  // namespace toccata
