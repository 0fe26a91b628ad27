#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "core/empty_list.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/trees/wide_bvh.hpp"
#include "trees/binary_build.hpp"
#include "trees/box_runs.hpp"
#include "trees/chunks.hpp"
#include "trees/wide_cells.hpp"

namespace toccata {
namespace {

// Work is divided by these numbers and never by threads.
constexpr std::size_t items_per_task = 4096;
constexpr std::uint32_t most_items_of_a_subtree = 8192;
constexpr std::size_t most_items_without_cells = 32768;

// Fewer cells than this tell too little of where their items are.
constexpr std::uint32_t fewest_cells_to_split = 64;

Aabb box_around(const BoxRuns& boxes, int threads) {
  const Chunks chunks{boxes.size(), items_per_task};
  std::vector<Aabb> around(chunks.size());
  parallel_for(chunks.size(), threads, [&](std::size_t chunk) {
    Aabb part;
    boxes.each(chunks, chunk, [&](std::size_t, const Aabb& box) { part = merge(part, box); });
    around[chunk] = part;
  });
  Aabb all;
  for (const Aabb& box : around) all = merge(all, box);
  return all;
}

/// The blocks of a tree over items, which are reordered to their order.
std::vector<WideBlock> blocks_over(std::span<FloatItem> items) {
  auto nodes = build_binary(items, [](const Part& part) { return part.count <= WideBlock::width; });
  set_costs(nodes);
  const auto plans = plan_blocks(nodes);
  std::vector<WideBlock> blocks(plans.size());
  fill_blocks(blocks, plans, nodes, items);
  return blocks;
}

void set_order(std::span<Index> order, std::span<const FloatItem> items) {
  std::transform(items.begin(), items.end(), order.begin(), [](const FloatItem& item) { return item.number(); });
}

void build_at_once(WideBvh& tree, const WideFrame& frame, const BoxRuns& boxes) {
  std::vector<FloatItem> items;
  items.reserve(boxes.size());
  boxes.each(0, boxes.size(), [&](std::size_t number, const Aabb& box) {
    items.push_back(item_in(frame, box, static_cast<std::uint32_t>(number)));
  });
  tree.blocks = blocks_over(items);
  set_order(tree.items, items);
}

/// A run of cells that gets a tree of its own, which is put in the place of a node of the tree over the cells.
struct Subtree {
  std::uint32_t node;
  std::span<const Cell> cells;
  std::uint32_t first_item = 0;
  std::uint32_t item_count = 0;
  std::vector<WideBlock> blocks{};
};

/// In the order of the cells.
std::vector<Subtree> subtrees_below(std::span<const BinaryNode> nodes, std::span<const Cell> cells) {
  std::vector<Subtree> subtrees;
  for (std::uint32_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].is_bottom()) subtrees.push_back({i, cells.subspan(nodes[i].first, nodes[i].count)});
  std::sort(subtrees.begin(), subtrees.end(),
            [](const Subtree& a, const Subtree& b) { return a.cells.data() < b.cells.data(); });
  std::uint32_t first = 0;
  for (Subtree& subtree : subtrees) {
    subtree.first_item = first;
    for (const Cell& cell : subtree.cells) subtree.item_count += cell.count;
    first += subtree.item_count;
  }
  return subtrees;
}

/// Builds a subtree over a copy of its items, which stays in the processor's cache.
void build(Subtree& subtree, const FloatItem* items, std::span<Index> order) {
  std::vector<FloatItem> own;
  own.reserve(subtree.item_count);
  for (const Cell& cell : subtree.cells) {
    const auto in_cell = std::span(items + cell.first, cell.count);
    own.insert(own.end(), in_cell.begin(), in_cell.end());
  }
  subtree.blocks = blocks_over(own);
  set_order(order.subspan(subtree.first_item, subtree.item_count), own);
}

/// Appends a subtree's blocks, whose numbers and places change by that.
void append(std::vector<WideBlock>& all, const Subtree& subtree) {
  const auto first_block = static_cast<std::int32_t>(all.size());
  for (const WideBlock& block : subtree.blocks) {
    WideBlock& placed = all.emplace_back(block);
    for (std::uint32_t lane = 0; lane < block.count; ++lane)
      placed.child[lane] += block.is_item(lane) ? -static_cast<std::int32_t>(subtree.first_item) : first_block;
  }
}

/// Puts the subtrees below the blocks over the cells. Each gives its blocks up, so that they are there but once.
void join(WideBvh& tree, std::vector<BinaryNode>& nodes, std::span<Subtree> subtrees) {
  for (const Subtree& subtree : subtrees) nodes[subtree.node].count = BinaryNode::made_elsewhere;
  set_costs(nodes);
  const auto plans = nodes.size() > 1 ? plan_blocks(nodes) : std::vector<BlockPlan>{};
  auto block_count = static_cast<std::uint32_t>(plans.size());
  for (const Subtree& subtree : subtrees) {
    nodes[subtree.node].first = block_count;
    block_count += static_cast<std::uint32_t>(subtree.blocks.size());
  }
  tree.blocks.reserve(block_count);
  tree.blocks.resize(plans.size());
  fill_blocks(tree.blocks, plans, nodes, {});
  for (Subtree& subtree : subtrees) {
    append(tree.blocks, subtree);
    free_list(subtree.blocks);
  }
}

/// The first levels are found from the cells of a grid, and the subtrees below them each on one thread.
void build_by_cells(WideBvh& tree, const WideFrame& frame, const BoxRuns& boxes, int threads) {
  CellGrid grid = sort_into_cells(boxes, tree.box, frame, threads);
  auto nodes = build_binary(std::span(grid.cells), [](const Part& part) {
    return part.items <= most_items_of_a_subtree || part.count < fewest_cells_to_split;
  });
  auto subtrees = subtrees_below(nodes, grid.cells);
  parallel_for(subtrees.size(), threads, [&](std::size_t i) { build(subtrees[i], grid.items.get(), tree.items); });
  grid.items.reset();
  join(tree, nodes, subtrees);
}

}  // namespace

WideBvh build_wide_bvh(const BoxRuns& boxes, const WideBuildOptions& options) {
  const std::size_t most = std::min(options.most_items, WideBuildOptions::greatest_item_count);
  if (boxes.size() > most)
    throw Error("a tree over " + std::to_string(boxes.size()) + " items was asked for, and it holds at most " +
                std::to_string(most) + ": divide the mesh into parts, each with a tree of its own");
  WideBvh tree;
  if (boxes.size() == 0) return tree;
  tree.box = box_around(boxes, options.threads);
  const WideFrame frame = frame_around(tree.box);
  tree.origin = frame.origin;
  tree.unit = frame.unit;
  tree.items = std::vector<Index>(boxes.size());
  if (boxes.size() <= most_items_without_cells) {
    build_at_once(tree, frame, boxes);
  } else {
    build_by_cells(tree, frame, boxes, options.threads);
  }
  return tree;
}

WideBvh build_wide_bvh(std::span<const Aabb> boxes, const WideBuildOptions& options) {
  const auto tell = [boxes](std::size_t first, std::span<Aabb> run) {
    std::copy_n(boxes.begin() + static_cast<std::ptrdiff_t>(first), run.size(), run.begin());
  };
  return build_wide_bvh(BoxRuns(boxes.size(), tell), options);
}

WideBvh build_wide_bvh(const TriangleMesh& mesh, const WideBuildOptions& options) {
  const auto tell = [&](std::size_t first, std::span<Aabb> run) {
    for (std::size_t i = 0; i < run.size(); ++i) run[i] = triangle_box(mesh, first + i);
  };
  return build_wide_bvh(BoxRuns(mesh.triangle_count(), tell), options);
}

}  // namespace toccata
