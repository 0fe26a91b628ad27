#include "shapes/hull_guide.hpp"

#include <algorithm>
#include <cmath>

namespace toccata {
namespace {

constexpr Index least_guided_vertices = 512;

/// The six sides of the cube have as many rows of as many cells each.
Index rows_of(std::size_t size) {
  const std::size_t cells = size / 6;
  return static_cast<Index>(std::lround(std::sqrt(static_cast<double>(cells))));
}

/// From −1 to 1.
double middle_of(Index row, Index rows) { return (2.0 * row + 1) / rows - 1; }

Vec3 middle_of_cell(Index side, double u, double v) {
  Vec3 direction;
  const int axis = static_cast<int>(side / 2);
  direction[axis] = side % 2 == 0 ? 1 : -1;
  direction[(axis + 1) % 3] = u;
  direction[(axis + 2) % 3] = v;
  return direction;
}

Index walk_to_farthest(const ConvexHull& hull, const HullTopology& topology, const Vec3& direction, Index start) {
  Index farthest = start;
  double height = dot(direction, hull.vertex(start));
  for (Index from = farthest;; from = farthest) {
    const Index first = topology.leaving[from];
    Index edge = first;
    do {
      const Index twin = topology.twin[edge], neighbour = topology.origin[twin];
      const double its_height = dot(direction, hull.vertex(neighbour));
      if (its_height > height) {
        height = its_height;
        farthest = neighbour;
      }
      edge = topology.next(twin);
    } while (edge != first);
    if (farthest == from) return farthest;
  }
}

}  // namespace

Index guide_size(Index vertices) {
  if (vertices < least_guided_vertices) return 0;
  const auto rows = static_cast<Index>(std::sqrt(vertices / 6.0));
  return 6 * rows * rows;
}

void fill_guide(const ConvexHull& hull, std::span<Index> guide) {
  if (guide.empty()) return;
  const HullTopology topology = hull.topology();
  const Index rows = rows_of(guide.size());
  Index farthest = 0;
  std::size_t cell = 0;
  for (Index side = 0; side < 6; ++side)
    for (Index i = 0; i < rows; ++i) {
      // The vertex of the cell in the row before is nearer than that of the end of the row.
      if (i > 0) farthest = guide[cell - rows];
      for (Index j = 0; j < rows; ++j, ++cell) {
        const Vec3 direction = middle_of_cell(side, middle_of(i, rows), middle_of(j, rows));
        farthest = walk_to_farthest(hull, topology, direction, farthest);
        guide[cell] = farthest;
      }
    }
}

Index guide_cell(const Vec3& direction, std::size_t size) {
  const Vec3 magnitude{std::fabs(direction.x), std::fabs(direction.y), std::fabs(direction.z)};
  int axis = magnitude.y > magnitude.x ? 1 : 0;
  axis = magnitude.z > magnitude[axis] ? 2 : axis;
  const Index rows = rows_of(size);
  const double half = 0.5 * rows, scale = half / magnitude[axis];
  // The conversion is of a number within the range, whatever the direction is.
  const auto row_of = [&](double coordinate) {
    return static_cast<Index>(std::fmin(std::fmax(half + scale * coordinate, 0), rows - 1.0));
  };
  const Index side = 2 * static_cast<Index>(axis) + (direction[axis] < 0 ? 1 : 0);
  const Index i = row_of(direction[(axis + 1) % 3]), j = row_of(direction[(axis + 2) % 3]);
  return (side * rows + i) * rows + j;
}

}  // namespace toccata
