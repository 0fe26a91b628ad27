#include "trees/wide_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "toccata/core/parallel.hpp"
#include "trees/chunks.hpp"

namespace toccata {
namespace {

constexpr std::size_t cells_per_task = 1024;
constexpr std::size_t fewest_items_per_task = 16384;

/// Tells the cell of an item's box.
class CellSorter {
 public:
  CellSorter(const WideFrame& frame, const Aabb& around, std::size_t item_count) : frame_(frame) {
    lower_ = in_frame(around.lower);
    const auto upper = in_frame(around.upper);
    float longest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) longest = std::max(longest, upper[axis] - lower_[axis]);
    // A closed surface passes through some 3 · side² cells of side³.
    const float side = std::clamp(std::sqrt(static_cast<float>(item_count) / 64), 8.0F, 64.0F);
    const float scale = 0.99999F * side / longest;
    // All items coincide, or nearly so: one cell.
    if (!std::isfinite(scale)) return;
    scale_ = scale;
    for (std::size_t axis = 0; axis < 3; ++axis)
      last_[axis] = static_cast<std::size_t>((upper[axis] - lower_[axis]) * scale);
  }

  [[nodiscard]] std::size_t cell_count() const { return of_place(last_) + 1; }

  [[nodiscard]] std::size_t of(const Aabb& box) const {
    const auto middle = in_frame(0.5 * box.lower + 0.5 * box.upper);
    std::array<std::size_t, 3> place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto cell = static_cast<std::int32_t>((middle[axis] - lower_[axis]) * scale_);
      place[axis] = std::min(static_cast<std::size_t>(std::max(cell, 0)), last_[axis]);
    }
    return of_place(place);
  }

 private:
  [[nodiscard]] std::array<float, 3> in_frame(const Vec3& x) const {
    const Vec3 q = frame_.inverse * (x - frame_.origin);
    return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
  }

  [[nodiscard]] std::size_t of_place(const std::array<std::size_t, 3>& place) const {
    return (place[2] * (last_[1] + 1) + place[1]) * (last_[0] + 1) + place[0];
  }

  WideFrame frame_;
  std::array<float, 3> lower_;
  float scale_ = 0;
  std::array<std::size_t, 3> last_{0, 0, 0};
};

/// Places for the items of each chunk in each cell, from the numbers of them, which are replaced.
/// Returns where the cells start, and last where they end.
std::vector<std::uint32_t> place_chunks(std::span<std::vector<std::uint32_t>> chunks, std::size_t cell_count) {
  std::vector<std::uint32_t> starts(cell_count + 1, 0);
  for (const auto& counts : chunks)
    for (std::size_t cell = 0; cell < cell_count; ++cell) starts[cell + 1] += counts[cell];
  for (std::size_t cell = 0; cell < cell_count; ++cell) starts[cell + 1] += starts[cell];
  std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
  for (auto& counts : chunks) {
    for (std::size_t cell = 0; cell < cell_count; ++cell) {
      const std::uint32_t count = counts[cell];
      counts[cell] = next[cell];
      next[cell] += count;
    }
  }
  return starts;
}

std::vector<Cell> cells_that_hold_items(std::span<const std::uint32_t> starts) {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    if (starts[i + 1] == starts[i]) continue;
    cells.push_back({FloatBox::empty(), starts[i], starts[i + 1] - starts[i]});
  }
  return cells;
}

}  // namespace

CellGrid sort_into_cells(const BoxRuns& boxes, const Aabb& around, const WideFrame& frame, int threads) {
  const CellSorter grid(frame, around, boxes.size());
  // The chunks' numbers of items in cells take no more space than a part of the items'.
  const Chunks chunks{boxes.size(), std::max(fewest_items_per_task, grid.cell_count())};
  std::vector<std::vector<std::uint32_t>> places(chunks.size());
  parallel_for(chunks.size(), threads, [&](std::size_t chunk) {
    places[chunk].assign(grid.cell_count(), 0);
    boxes.each(chunks, chunk, [&](std::size_t, const Aabb& box) { ++places[chunk][grid.of(box)]; });
  });
  CellGrid result;
  result.cells = cells_that_hold_items(place_chunks(places, grid.cell_count()));
  // Not set to anything first, so that the memory is first touched in parallel.
  result.items = std::make_unique_for_overwrite<FloatItem[]>(boxes.size());
  parallel_for(chunks.size(), threads, [&](std::size_t chunk) {
    boxes.each(chunks, chunk, [&](std::size_t number, const Aabb& box) {
      result.items[places[chunk][grid.of(box)]++] = item_in(frame, box, static_cast<std::uint32_t>(number));
    });
  });
  const Chunks cell_chunks{result.cells.size(), cells_per_task};
  parallel_for(cell_chunks.size(), threads, [&](std::size_t chunk) {
    for (Cell& cell : cell_chunks.of(std::span(result.cells), chunk))
      for (const FloatItem& item : std::span(&result.items[cell.first], cell.count)) cell.add(item);
  });
  return result;
}

}  // namespace toccata
