#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "broad/box_families.hpp"
#include "toccata/core/index.hpp"
#include "toccata/partitions/partition.hpp"

namespace toccata::test {

/// Those of the broad phases, but the infinite ones, which partitions refuse.
inline constexpr std::array partition_families{
    std::string_view("uniform"), std::string_view("sizes"),     std::string_view("equal"),
    std::string_view("nested"),  std::string_view("plane"),     std::string_view("line"),
    std::string_view("giant"),   std::string_view("lattice"),   std::string_view("touching"),
    std::string_view("points"),  std::string_view("far"),       std::string_view("denormal"),
    std::string_view("huge"),    std::string_view("clusters"),  std::string_view("decades"),
    std::string_view("columns"), std::string_view("last-place")};

/// The boxes of the family, cut where doubles end.
inline Aabb random_finite_box(std::string_view family, std::size_t i, Random& random) {
  constexpr double most = std::numeric_limits<double>::max();
  Aabb box = random_box(family, i, random);
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = std::clamp(box.lower[axis], -most, most);
    box.upper[axis] = std::clamp(box.upper[axis], -most, most);
  }
  return box;
}
inline std::vector<Aabb> random_finite_boxes(std::string_view family, std::size_t count, Random& random) {
  std::vector<Aabb> boxes;
  while (boxes.size() < count) boxes.push_back(random_finite_box(family, boxes.size(), random));
  return boxes;
}

/// In the boxes of the family, some with corners at corners, flat ones among them.
inline std::vector<Triangle> random_triangles(std::string_view family, std::size_t count, Random& random) {
  std::vector<Triangle> triangles;
  while (triangles.size() < count) {
    const Aabb box = random_finite_box(family, triangles.size(), random);
    Triangle triangle;
    for (Vec3& vertex : triangle.vertex)
      for (int axis = 0; axis < 3; ++axis)
        vertex[axis] = random.below(3) == 0   ? 0.5 * box.lower[axis] + 0.5 * box.upper[axis]
                       : random.below(2) == 0 ? box.lower[axis]
                                              : box.upper[axis];
    triangles.push_back(triangle);
  }
  return triangles;
}

/// The slow truth.
inline std::vector<Index> items_intersecting_by_brute_force(const PartitionItems& items, const Aabb& box) {
  std::vector<Index> found;
  for (Index item = 0; item < items.size(); ++item)
    if (items.meets(item, box)) found.push_back(item);
  return found;
}
inline std::vector<IndexPair> pairs_intersecting_by_brute_force(const PartitionItems& items) {
  std::vector<IndexPair> found;
  for (Index a = 0; a < items.size(); ++a)
    for (Index b = a + 1; b < items.size(); ++b)
      if (items.meet(a, b)) found.push_back({a, b});
  return found;
}

/// What is wrong with a partition of the items; empty when nothing is.
template <SpacePartition P>
std::string complaint_about_partition(const P& partition, const PartitionItems& items, Random& random) {
  if (pairs_intersecting(partition, items) != pairs_intersecting_by_brute_force(items))
    return "other pairs than brute force";
  for (int i = 0; i < 20 && items.size() > 0; ++i) {
    Aabb box = items.boxes()[random.below(items.size())];
    if (i % 3 == 1) box = merge(box, items.boxes()[random.below(items.size())]);
    if (i % 3 == 2) box = {box.upper, box.upper};
    if (items_intersecting(partition, items, box) != items_intersecting_by_brute_force(items, box))
      return "other items in a box than brute force";
  }
  std::vector<char> held(items.size(), 0);
  for (const PartitionCell& cell : partition.cells()) {
    if (cell.items.empty()) return "a cell without items";
    for (std::size_t k = 0; k < cell.items.size(); ++k) {
      if (k > 0 && cell.items[k - 1] >= cell.items[k]) return "a cell's items are not ascending";
      if (!items.meets(cell.items[k], cell.box)) return "a cell has an item that does not meet it";
      held[cell.items[k]] = 1;
    }
  }
  return std::count(held.begin(), held.end(), 1) == static_cast<std::ptrdiff_t>(items.size()) ? "" : "an item is lost";
}

}  // namespace toccata::test
