#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/trees/wide_tree.hpp"
#include "trees/binary_split.hpp"
#include "trees/wide_collapse.hpp"
#include "trees/wide_frame.hpp"

namespace toccata {
namespace {

// Work is divided by these numbers and never by threads.
constexpr std::size_t items_per_task = 4096;
constexpr std::uint32_t most_items_of_a_subtree = 8192;

// Below this depth parts are halved instead: boxes spread over many orders of magnitude cannot make the tree a list.
constexpr int greatest_heuristic_depth = 64;

/// The parts of [0, count) that are worth a task each.
struct Chunks {
  std::size_t count;

  [[nodiscard]] std::size_t size() const { return (count + items_per_task - 1) / items_per_task; }
  [[nodiscard]] std::size_t first(std::size_t chunk) const { return chunk * items_per_task; }
  [[nodiscard]] std::size_t length(std::size_t chunk) const {
    return std::min(items_per_task, count - chunk * items_per_task);
  }
};

Aabb box_around(std::span<const Aabb> boxes, int threads) {
  const Chunks chunks{boxes.size()};
  std::vector<Aabb> around(chunks.size());
  parallel_for(chunks.size(), threads, [&](std::size_t chunk) {
    for (const Aabb& box : boxes.subspan(chunks.first(chunk), chunks.length(chunk)))
      around[chunk] = merge(around[chunk], box);
  });
  Aabb all;
  for (const Aabb& box : around) all = merge(all, box);
  return all;
}

std::vector<FloatItem> items_in(const WideFrame& frame, std::span<const Aabb> boxes, int threads) {
  const Chunks chunks{boxes.size()};
  std::vector<FloatItem> items(boxes.size());
  parallel_for(chunks.size(), threads, [&](std::size_t chunk) {
    const std::size_t first = chunks.first(chunk);
    for (std::size_t i = first; i < first + chunks.length(chunk); ++i) {
      items[i] = {to_frame(frame, boxes[i])};
      items[i].set_number(static_cast<std::uint32_t>(i));
    }
  });
  return items;
}

/// A node that is to be split.
struct Task {
  std::uint32_t node;
  int depth;
  Part part;
};

/// Splits a run of items from the top down.
class BinaryBuilder {
 public:
  BinaryBuilder(std::span<FloatItem> items, std::uint32_t most_below) : items_(items), most_below_(most_below) {}

  /// Splits until parts are not larger than the builder makes; those larger than a bottom are left over.
  void build(const Part& part, int depth) {
    add(part, depth);
    while (!tasks_.empty()) {
      const Task task = tasks_.back();
      tasks_.pop_back();
      const SplitPart parts =
          task.depth < greatest_heuristic_depth ? split(items_, task.part) : split_in_halves(items_, task.part);
      nodes_[task.node].children = static_cast<std::uint32_t>(nodes_.size());
      add(parts.left, task.depth + 1);
      add(parts.right, task.depth + 1);
    }
  }

  void set_costs() {
    for (std::size_t i = nodes_.size(); i > 0; --i) set_cost(nodes_[i - 1], nodes_);
  }

  std::vector<BinaryNode>& nodes() { return nodes_; }
  [[nodiscard]] std::span<const Task> left_over() const { return left_over_; }

 private:
  void add(const Part& part, int depth) {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({part.box, part.first, part.count});
    if (part.count > most_below_) {
      tasks_.push_back({number, depth, part});
    } else if (part.count > WideBlock::width) {
      left_over_.push_back({number, depth, part});
    }
  }

  std::span<FloatItem> items_;
  std::uint32_t most_below_;
  std::vector<BinaryNode> nodes_;
  std::vector<Task> tasks_;
  std::vector<Task> left_over_;
};

/// Puts a subtree in the place of a node that was left over; but for its root, its nodes go to the end.
void graft(std::vector<BinaryNode>& nodes, std::uint32_t place, std::span<const BinaryNode> subtree) {
  const auto shift = static_cast<std::uint32_t>(nodes.size() - 1);
  nodes[place] = subtree[0];
  nodes.insert(nodes.end(), subtree.begin() + 1, subtree.end());
  nodes[place].children += shift;
  for (std::size_t i = shift + 1; i < nodes.size(); ++i)
    if (!nodes[i].is_bottom()) nodes[i].children += shift;
}

std::vector<BinaryNode> binary_tree(std::span<FloatItem> items, int threads) {
  BinaryBuilder top(items, most_items_of_a_subtree);
  top.build(part_of(items, 0, static_cast<std::uint32_t>(items.size())), 0);
  const auto tasks = top.left_over();
  std::vector<std::vector<BinaryNode>> subtrees(tasks.size());
  parallel_for(tasks.size(), threads, [&](std::size_t i) {
    BinaryBuilder builder(items, WideBlock::width);
    builder.build(tasks[i].part, tasks[i].depth);
    builder.set_costs();
    subtrees[i] = std::move(builder.nodes());
  });
  const std::size_t top_count = top.nodes().size();
  for (std::size_t i = 0; i < tasks.size(); ++i) graft(top.nodes(), tasks[i].node, subtrees[i]);
  for (std::size_t i = top_count; i > 0; --i) set_cost(top.nodes()[i - 1], top.nodes());
  return std::move(top.nodes());
}

}  // namespace

WideTree build_wide_tree(std::span<const Aabb> boxes, const WideBuildOptions& options) {
  const std::size_t most = std::min(options.most_items, WideBuildOptions::greatest_item_count);
  if (boxes.size() > most)
    throw Error("a tree over " + std::to_string(boxes.size()) + " items was asked for, and it holds at most " +
                std::to_string(most) + ": divide the mesh into parts, each with a tree of its own");
  WideTree tree;
  if (boxes.empty()) return tree;
  tree.box = box_around(boxes, options.threads);
  const WideFrame frame = frame_around(tree.box);
  tree.origin = frame.origin;
  tree.unit = frame.unit;
  std::vector<FloatItem> items = items_in(frame, boxes, options.threads);
  tree.blocks = collapse(binary_tree(items, options.threads), items, options.threads);
  tree.items.reserve(items.size());
  for (const FloatItem& item : items) tree.items.push_back(item.number());
  return tree;
}

}  // namespace toccata
