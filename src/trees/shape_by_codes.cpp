#include <algorithm>
#include <bit>
#include <cmath>

#include "trees/binary_shape.hpp"

namespace toccata {
namespace {

/// 21 bits, two places apart from each other.
std::uint64_t spread_bits(std::uint64_t x) {
  x = (x | x << 32) & 0x1f00000000ffffULL;
  x = (x | x << 16) & 0x1f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

std::uint64_t code_of(const Vec3& place, const Aabb& box) {
  constexpr double cells = 0x1p21;
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = box.upper[axis] - box.lower[axis];
    // Flat boxes have one cell.
    const double part = size > 0 ? (place[axis] - box.lower[axis]) / size : 0;
    const double cell = std::clamp(part * cells, 0.0, cells - 1);
    code = code << 1 | spread_bits(static_cast<std::uint64_t>(cell));
  }
  return code;
}

/// A run of codes that becomes a fork.
struct CodeRun {
  std::size_t first;
  std::size_t count;
  Index fork;
};

/// How many have the first differing bit of the run's codes not set; half of them where all codes are equal.
std::size_t first_part(std::span<const CodedItem> run) {
  const std::uint64_t differing = run.front().code ^ run.back().code;
  if (differing == 0) return run.size() / 2;
  const std::uint64_t bit = std::bit_floor(differing);
  const auto border =
      std::partition_point(run.begin(), run.end(), [bit](const CodedItem& i) { return (i.code & bit) == 0; });
  return static_cast<std::size_t>(border - run.begin());
}

}  // namespace

std::vector<CodedItem> along_curve(const ShapeItems& items, int threads) {
  Aabb box;
  for (const Vec3& centroid : items.centroids) box = merge(box, centroid);
  std::vector<CodedItem> coded(items.centroids.size());
  parallel_for(coded.size(), threads, [&](std::size_t i) {
    coded[i] = {code_of(items.centroids[i], box), static_cast<Index>(i)};
  });
  std::sort(coded.begin(), coded.end());
  return coded;
}

// No deeper than the 63 bits, and then the halves of equal codes.
BinaryShape shape_by_codes(const ShapeItems& items, int threads) {
  const std::vector<CodedItem> coded = along_curve(items, threads);
  BinaryShape shape;
  shape.root = shape.add_leaf(coded.front().item);
  std::vector<CodeRun> tasks{{0, coded.size(), shape.root}};
  while (!tasks.empty()) {
    const CodeRun task = tasks.back();
    tasks.pop_back();
    if (task.count == 1) continue;
    const std::size_t border = first_part(std::span(coded).subspan(task.first, task.count));
    const Index left = shape.add_leaf(coded[task.first].item), right = shape.add_leaf(coded[task.first + border].item);
    shape.forks[task.fork] = {left, right, no_index};
    tasks.push_back({task.first + border, task.count - border, right});
    tasks.push_back({task.first, border, left});
  }
  return shape;
}

}  // namespace toccata
