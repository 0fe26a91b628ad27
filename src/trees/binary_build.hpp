#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "trees/binary_split.hpp"
#include "trees/wide_collapse.hpp"

namespace toccata {

/// Splits a run of items, or of cells, from the top down, until `is_whole(part)`; reorders it. The nodes' costs are not
/// set. Children come after their parents.
template <typename Record, typename IsWhole>
std::vector<BinaryNode> build_binary(std::span<Record> records, const IsWhole& is_whole) {
  // Below this depth parts are halved: boxes spread over many orders of magnitude cannot make the tree a list.
  constexpr int greatest_heuristic_depth = 64;
  struct Task {
    std::uint32_t node;
    int depth;
    Part part;
  };
  std::vector<BinaryNode> nodes;
  std::vector<Task> tasks;
  nodes.reserve(records.size() / 2 + 1);
  const auto add = [&](const Part& part, int depth) {
    const auto number = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back({part.box, part.first, part.count});
    if (!is_whole(part)) tasks.push_back({number, depth, part});
  };
  add(part_of(records, 0, static_cast<std::uint32_t>(records.size())), 0);
  while (!tasks.empty()) {
    const Task task = tasks.back();
    tasks.pop_back();
    const SplitPart parts =
        task.depth < greatest_heuristic_depth ? split(records, task.part) : split_in_halves(records, task.part);
    nodes[task.node].children = static_cast<std::uint32_t>(nodes.size());
    add(parts.left, task.depth + 1);
    add(parts.right, task.depth + 1);
  }
  return nodes;
}

}  // namespace toccata
