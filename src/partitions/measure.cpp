#include "toccata/partitions/measure.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "partitions/partition_makers.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

class Stopwatch {
 public:
  [[nodiscard]] double ns() const {
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Twice as large as the item's box, cut where doubles end.
Aabb twice_as_large(const Aabb& box) {
  constexpr double greatest = std::numeric_limits<double>::max();
  Aabb larger = box;
  for (int axis = 0; axis < 3; ++axis) {
    const double half = 0.5 * box.upper[axis] - 0.5 * box.lower[axis];
    larger.lower[axis] = std::max(box.lower[axis] - half, -greatest);
    larger.upper[axis] = std::min(box.upper[axis] + half, greatest);
  }
  return larger;
}

std::vector<Aabb> boxes_to_ask(const PartitionItems& items, const PartitionCostOptions& options) {
  Random random(options.seed);
  std::vector<Aabb> boxes;
  if (items.size() == 0) return boxes;
  for (std::size_t i = 0; i < options.questions; ++i)
    boxes.push_back(twice_as_large(items.boxes()[random.below(items.size())]));
  return boxes;
}

Vec3 middle_of(const PartitionItems& items, Index item) {
  if (items.triangles().empty()) return 0.5 * items.boxes()[item].lower + 0.5 * items.boxes()[item].upper;
  const Triangle& t = items.triangles()[item];
  return 0.25 * t[0] + 0.25 * t[1] + 0.5 * t[2];
}

/// A cell without its upper sides, so that neighbours do not count twice; a flat one with them.
bool holds(const Aabb& cell, const Vec3& point) {
  for (int axis = 0; axis < 3; ++axis) {
    const double lower = cell.lower[axis], upper = cell.upper[axis];
    if (point[axis] < lower || (lower < upper ? point[axis] >= upper : point[axis] > upper)) return false;
  }
  return true;
}

/// At ten thousand items at most, evenly chosen.
double cells_at_items(const PartitionItems& items, const std::vector<PartitionCell>& cells) {
  std::vector<Aabb> boxes;
  for (const PartitionCell& cell : cells) boxes.push_back(cell.box);
  const RTree tree(boxes);
  const std::size_t step = items.size() / 10'000 + 1;
  std::size_t asked = 0, held = 0;
  for (std::size_t item = 0; item < items.size(); item += step, ++asked) {
    const Vec3 middle = middle_of(items, static_cast<Index>(item));
    for (const Index cell : tree.candidates({middle, middle})) held += holds(boxes[cell], middle) ? 1 : 0;
  }
  return asked == 0 ? 0 : static_cast<double>(held) / static_cast<double>(asked);
}

struct Answers {
  std::vector<std::vector<Index>> in_boxes;
  std::vector<IndexPair> pairs;
  friend bool operator==(const Answers&, const Answers&) = default;
};

template <SpacePartition P>
void count_cells(const P& partition, const PartitionItems& items, PartitionCost& cost) {
  const std::vector<PartitionCell> cells = partition.cells();
  std::size_t copies = 0;
  for (const PartitionCell& cell : cells) {
    copies += cell.items.size();
    cost.most_in_a_cell = std::max(cost.most_in_a_cell, cell.items.size());
  }
  cost.cells = cells.size();
  if (cells.empty()) return;
  cost.items_per_cell = static_cast<double>(copies) / static_cast<double>(cells.size());
  cost.copies_per_item = static_cast<double>(copies) / static_cast<double>(items.size());
  cost.cells_at_an_item = cells_at_items(items, cells);
}

template <SpacePartition P>
Answers ask(const P& partition, const PartitionItems& items, std::span<const Aabb> boxes, PartitionCost& cost) {
  Answers answers;
  const Stopwatch questions;
  for (const Aabb& box : boxes) answers.in_boxes.push_back(items_intersecting(partition, items, box));
  const auto count = static_cast<double>(std::max<std::size_t>(boxes.size(), 1));
  cost.question_ns = questions.ns() / count;
  const Stopwatch all;
  answers.pairs = pairs_intersecting(partition, items);
  cost.pairs_ns = all.ns();
  cost.pairs = answers.pairs.size();
  cost.candidate_pairs = partition.candidate_pairs().size();
  std::size_t candidates = 0, found = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    candidates += partition.candidates(boxes[i]).size();
    found += answers.in_boxes[i].size();
  }
  cost.candidates = static_cast<double>(candidates) / count;
  cost.answers = static_cast<double>(found) / count;
  return answers;
}

template <class Make>
Answers measure(const Make& make, const PartitionItems& items, std::span<const Aabb> boxes, PartitionCost& cost) {
  const Stopwatch building;
  const auto partition = make();
  cost.build_ns = building.ns();
  cost.bytes = partition.bytes();
  count_cells(partition, items, cost);
  return ask(partition, items, boxes, cost);
}

Answers measure(const PartitionItems& items, std::span<const Aabb> boxes, PartitionCost& cost) {
  return with_maker(cost.kind, items, [&](const auto& make) { return measure(make, items, boxes, cost); });
}

}  // namespace

std::string_view name_of(PartitionKind kind) {
  constexpr std::array<std::string_view, all_partition_kinds.size()> names{"grid-2d", "grid",   "octree",
                                                                           "kd-tree", "r-tree", "inserted-r-tree"};
  return names[static_cast<std::size_t>(kind)];
}

bool is_object_centric(PartitionKind kind) {
  return kind == PartitionKind::r_tree || kind == PartitionKind::inserted_r_tree;
}

std::vector<PartitionCost> measure_partitions(const PartitionItems& items, const PartitionCostOptions& options) {
  const std::vector<Aabb> boxes = boxes_to_ask(items, options);
  std::vector<PartitionCost> costs;
  Answers first;
  for (const PartitionKind kind : all_partition_kinds) {
    PartitionCost cost;
    cost.kind = kind;
    Answers answers = measure(items, boxes, cost);
    if (costs.empty())
      first = std::move(answers);
    else if (answers != first)
      throw Error(fmt::format("'{}' and '{}' answer differently: this is an error of Toccata, please report it",
                              name_of(kind), name_of(costs.front().kind)));
    costs.push_back(cost);
    if (options.progress) options.progress(costs.size(), all_partition_kinds.size());
  }
  return costs;
}

}  // namespace toccata
