#include "trees/wide_collapse.hpp"

#include <algorithm>
#include <cstddef>

#include "trees/wide_boxes.hpp"

namespace toccata {
namespace {

constexpr std::uint32_t block_width = WideBlock::width;

bool is_made_elsewhere(const BinaryNode& node) { return node.count == BinaryNode::made_elsewhere; }

void set_bottom_cost(BinaryNode& node) {
  const float cost = visit_cost(node.box);
  for (std::uint32_t lanes = 1; lanes <= block_width; ++lanes) node.cost[lanes - 1] = lanes >= node.count ? 0 : cost;
}

void set_inner_cost(BinaryNode& node, std::span<const BinaryNode> nodes) {
  const auto& left = nodes[node.children].cost;
  const auto& right = nodes[node.children + 1].cost;
  for (std::uint32_t lanes = 2; lanes <= block_width; ++lanes) {
    float best = FloatBox::infinity;
    for (std::uint32_t to_left = 1; to_left < lanes; ++to_left) {
      const float both = left[to_left - 1] + right[lanes - to_left - 1];
      if (both >= best) continue;
      best = both;
      node.left_lanes[lanes - 1] = static_cast<std::uint8_t>(to_left);
    }
    node.cost[lanes - 1] = best;
  }
  // The node's own block is spread over eight lanes.
  node.left_lanes[0] = node.left_lanes[block_width - 1];
  node.cost[0] = visit_cost(node.box) + node.cost[block_width - 1];
  for (std::uint32_t lanes = 2; lanes <= block_width; ++lanes) {
    if (node.cost[lanes - 1] < node.cost[0]) continue;
    node.cost[lanes - 1] = node.cost[0];
    node.left_lanes[lanes - 1] = 0;
  }
}

/// A lane of a block: a node that has a block of its own, here or elsewhere, or an item.
struct Lane {
  std::uint32_t number;
  bool is_item;
};

struct Lanes {
  std::array<Lane, block_width> lane;
  std::uint32_t count = 0;

  void add_items(const BinaryNode& node) {
    for (std::uint32_t i = 0; i < node.count; ++i) lane[count++] = {node.first + i, true};
  }
};

/// A node that still is to be spread over some lanes.
struct Spread {
  std::uint32_t node;
  std::uint32_t lanes;
};

/// The lanes of the block of a node.
Lanes lanes_of(std::span<const BinaryNode> nodes, std::uint32_t root) {
  Lanes lanes;
  // Every entry stands for at least one lane.
  std::array<Spread, block_width + 1> stack;
  std::size_t size = 0;
  const auto open = [&](const BinaryNode& node, std::uint32_t among, std::uint32_t left) {
    stack[size++] = {node.children + 1, among - left};
    stack[size++] = {node.children, left};
  };
  if (nodes[root].is_bottom()) {
    lanes.add_items(nodes[root]);
  } else {
    open(nodes[root], block_width, nodes[root].left_lanes[0]);
  }
  while (size > 0) {
    const Spread spread = stack[--size];
    const BinaryNode& node = nodes[spread.node];
    if (node.is_bottom() && node.count <= spread.lanes) {
      lanes.add_items(node);
    } else if (node.is_bottom() || spread.lanes == 1 || node.left_lanes[spread.lanes - 1] == 0) {
      lanes.lane[lanes.count++] = {spread.node, false};
    } else {
      open(node, spread.lanes, node.left_lanes[spread.lanes - 1]);
    }
  }
  return lanes;
}

void fill(WideBlock& block, const BlockPlan& plan, std::span<const BinaryNode> nodes,
          std::span<const FloatItem> items) {
  const Lanes lanes = lanes_of(nodes, plan.node);
  std::array<FloatBox, block_width> boxes;
  boxes.fill(FloatBox{Float4{}, Float4{}});
  auto next_child = static_cast<std::int32_t>(plan.first_child);
  for (std::uint32_t i = 0; i < lanes.count; ++i) {
    const Lane lane = lanes.lane[i];
    boxes[i] = lane.is_item ? static_cast<const FloatBox&>(items[lane.number]) : nodes[lane.number].box;
    block.child[i] = lane.is_item                            ? ~static_cast<std::int32_t>(lane.number)
                     : is_made_elsewhere(nodes[lane.number]) ? static_cast<std::int32_t>(nodes[lane.number].first)
                                                             : next_child++;
  }
  block.count = lanes.count;
  set_boxes(block, boxes);
}

}  // namespace

void set_costs(std::span<BinaryNode> nodes) {
  for (std::size_t i = nodes.size(); i > 0; --i) {
    BinaryNode& node = nodes[i - 1];
    if (node.is_bottom()) {
      set_bottom_cost(node);
    } else {
      set_inner_cost(node, nodes);
    }
  }
}

std::vector<BlockPlan> plan_blocks(std::span<const BinaryNode> nodes) {
  std::vector<BlockPlan> plans{{0, 0}};
  plans.reserve(nodes.size() / 2 + 1);
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t block = open.back();
    open.pop_back();
    const Lanes lanes = lanes_of(nodes, plans[block].node);
    plans[block].first_child = static_cast<std::uint32_t>(plans.size());
    for (const Lane& lane : std::span(lanes.lane).first(lanes.count))
      if (!lane.is_item && !is_made_elsewhere(nodes[lane.number])) plans.push_back({lane.number, 0});
    for (auto child = static_cast<std::uint32_t>(plans.size()); child > plans[block].first_child; --child)
      open.push_back(child - 1);
  }
  return plans;
}

void fill_blocks(std::span<WideBlock> blocks, std::span<const BlockPlan> plans, std::span<const BinaryNode> nodes,
                 std::span<const FloatItem> items) {
  for (std::size_t i = 0; i < plans.size(); ++i) fill(blocks[i], plans[i], nodes, items);
}

}  // namespace toccata
