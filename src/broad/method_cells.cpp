#include "broad/method_cells.hpp"

#include <initializer_list>
#include <utility>

#include <fmt/format.h>

#include "math/vec3_coordinates.hpp"

namespace toccata {
namespace {

Aabb along(const Aabb& box, std::initializer_list<std::size_t> axes) {
  Aabb shadow = whole_space;
  for (const std::size_t axis : axes) {
    shadow.lower.*vec3_coordinates[axis] = box.lower.*vec3_coordinates[axis];
    shadow.upper.*vec3_coordinates[axis] = box.upper.*vec3_coordinates[axis];
  }
  return shadow;
}

}  // namespace

CellsOfGroup::CellsOfGroup(BroadPhaseCells& all, std::string name, int dimensions)
    : all_(all), group_(static_cast<Index>(all.groups.size())) {
  all.groups.push_back({std::move(name), dimensions});
}

void add_intervals(BroadPhaseCells& cells, std::span<const Aabb> boxes, std::size_t axis) {
  CellsOfGroup group(cells, fmt::format("intervals along {}", "xyz"[axis]), 1);
  for (const Aabb& box : boxes)
    if (!is_empty(box)) group.add(along(box, {axis}));
}

void add_rectangles(BroadPhaseCells& cells, std::span<const Aabb> boxes, std::size_t axis) {
  CellsOfGroup group(cells, fmt::format("rectangles in {}{}", "xyz"[axis], "xyz"[axis + 1]), 2);
  for (const Aabb& box : boxes)
    if (!is_empty(box)) group.add(along(box, {axis, axis + 1}));
}

Aabb cube_of_cell(const CellPlace& place, double side) {
  const Vec3 lower{static_cast<double>(place[0]), static_cast<double>(place[1]), static_cast<double>(place[2])};
  return {side * lower, side * (lower + Vec3{1, 1, 1})};
}

Aabb box_of_floats(const FloatFrame& frame, const std::array<float, 3>& lower, const std::array<float, 3>& upper) {
  return {{frame.unmap(lower[0], 0), frame.unmap(lower[1], 1), frame.unmap(lower[2], 2)},
          {frame.unmap(upper[0], 0), frame.unmap(upper[1], 1), frame.unmap(upper[2], 2)}};
}

}  // namespace toccata
