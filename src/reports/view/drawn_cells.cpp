#include "reports/view/drawn_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <span>
#include <utility>

#include "math/vec3_coordinates.hpp"

namespace toccata::io {
namespace {

double length_of(const Aabb& box, std::size_t axis) {
  return box.upper.*vec3_coordinates[axis] - box.lower.*vec3_coordinates[axis];
}

/// Whether any of them is; boxes themselves may be infinite.
bool are_bounded(std::span<const BroadPhaseCell> cells, std::size_t axis) {
  return std::any_of(cells.begin(), cells.end(), [axis](const BroadPhaseCell& cell) {
    return std::isfinite(cell.box.lower.*vec3_coordinates[axis]) ||
           std::isfinite(cell.box.upper.*vec3_coordinates[axis]);
  });
}

Aabb ended(Aabb cell, const Aabb& scene) {
  for (const auto coordinate : vec3_coordinates) {
    if (!std::isfinite(cell.lower.*coordinate))
      cell.lower.*coordinate = std::min(scene.lower.*coordinate, cell.upper.*coordinate);
    if (!std::isfinite(cell.upper.*coordinate))
      cell.upper.*coordinate = std::max(scene.upper.*coordinate, cell.lower.*coordinate);
  }
  return cell;
}

/// For each interval along the axis the least lane in which nothing is open there; and how many lanes there are.
std::pair<std::vector<std::size_t>, std::size_t> lanes_of(std::span<const BroadPhaseCell> cells, std::size_t axis) {
  const auto lower = [&](std::size_t i) { return cells[i].box.lower.*vec3_coordinates[axis]; };
  std::vector<std::size_t> order(cells.size()), lanes(cells.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return lower(i) != lower(j) ? lower(i) < lower(j) : i < j; });
  using Open = std::pair<double, std::size_t>;  // its end, and its lane
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> free;
  std::size_t count = 0;
  for (const std::size_t i : order) {
    for (; !open.empty() && open.top().first < lower(i); open.pop()) free.push(open.top().second);
    if (free.empty()) free.push(count++);
    lanes[i] = free.top();
    free.pop();
    open.emplace(cells[i].box.upper.*vec3_coordinates[axis], lanes[i]);
  }
  return {std::move(lanes), count};
}

/// Flat boxes at the foot of the scene: those along x before it, those along y and z to its left.
void add_intervals(std::span<const BroadPhaseCell> cells, const Aabb& scene, double size, std::vector<Aabb>& drawn) {
  std::size_t axis = 0;
  while (axis < 2 && !are_bounded(cells, axis)) ++axis;
  const std::size_t out = axis == 0 ? 1 : 0;
  const std::size_t flat = 3 - axis - out;
  const auto [lanes, count] = lanes_of(cells, axis);
  const double spacing = 0.3 * size / static_cast<double>(std::max<std::size_t>(count, 12));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Aabb box = ended(cells[i].box, scene);
    const double at = scene.lower.*vec3_coordinates[out] - 0.05 * size - spacing * static_cast<double>(lanes[i]);
    box.lower.*vec3_coordinates[out] = at - 0.6 * spacing;
    box.upper.*vec3_coordinates[out] = at;
    const double foot = axis == 2 ? scene.upper.*vec3_coordinates[flat] : scene.lower.*vec3_coordinates[flat];
    box.lower.*vec3_coordinates[flat] = box.upper.*vec3_coordinates[flat] = foot;
    drawn.push_back(box);
  }
}

void add_rectangles(std::span<const BroadPhaseCell> cells, const Aabb& scene, double size, std::vector<Aabb>& drawn) {
  std::size_t across = 0;
  while (across < 2 && are_bounded(cells, across)) ++across;
  const double wall = scene.lower.*vec3_coordinates[across] - 0.15 * size;
  for (const BroadPhaseCell& cell : cells) {
    Aabb box = ended(cell.box, scene);
    box.lower.*vec3_coordinates[across] = box.upper.*vec3_coordinates[across] = wall;
    drawn.push_back(box);
  }
}

}  // namespace

std::vector<Aabb> drawn_cells(const BroadPhaseCells& space, const Aabb& scene) {
  const double size = std::max({length_of(scene, 0), length_of(scene, 1), length_of(scene, 2)});
  const std::span<const BroadPhaseCell> all = space.cells;
  std::vector<Aabb> drawn;
  for (std::size_t first = 0, last; first < all.size(); first = last) {
    for (last = first; last < all.size() && all[last].group == all[first].group;) ++last;
    const std::span<const BroadPhaseCell> cells = all.subspan(first, last - first);
    const int dimensions = space.groups[cells.front().group].dimensions;
    if (dimensions == 1) add_intervals(cells, scene, size, drawn);
    if (dimensions == 2) add_rectangles(cells, scene, size, drawn);
    for (std::size_t i = 0; dimensions == 3 && i < cells.size(); ++i) drawn.push_back(ended(cells[i].box, scene));
  }
  return drawn;
}

}  // namespace toccata::io
