#include "partitions/region_tree.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace toccata {
namespace {

class Build {
 public:
  Build(const PartitionItems& items, const RegionLimits& limits, const RegionSplit& split)
      : items_(items), limits_(limits), split_(split), copies_(items.size()) {}

  RegionTree run(const Aabb& root) {
    if (items_.size() == 0) return {};
    tree_.nodes.push_back({root});
    std::vector<Index> all(items_.size());
    for (Index item = 0; item < all.size(); ++item) all[item] = item;
    held_.push_back(std::move(all));
    for (Index node = 0; node < tree_.nodes.size(); ++node)
      if (!cut(node)) make_leaf(node);
    return std::move(tree_);
  }

 private:
  [[nodiscard]] bool may_be_cut(Index node) const {
    return held_[node].size() > limits_.leaf_items && tree_.nodes[node].depth < limits_.most_depth &&
           static_cast<double>(copies_) < limits_.most_copies * static_cast<double>(items_.size());
  }

  [[nodiscard]] std::vector<Index> those_in(const Aabb& box, std::span<const Index> items) const {
    std::vector<Index> found;
    for (const Index item : items)
      if (items_.meets(item, box)) found.push_back(item);
    return found;
  }

  bool cut(Index node) {
    if (!may_be_cut(node)) return false;
    const std::vector<Aabb> boxes = split_(tree_.nodes[node].box, held_[node]);
    std::vector<std::vector<Index>> parts;
    std::size_t sum = 0, most = 0;
    for (const Aabb& box : boxes) {
      parts.push_back(those_in(box, held_[node]));
      sum += parts.back().size();
      most = std::max(most, parts.back().size());
    }
    const std::size_t count = held_[node].size();
    // Nothing is won where most items are in most children.
    const bool parts_none = most == count && sum > count && limits_.cuts == RegionCuts::must_part;
    if (boxes.empty() || parts_none || 2 * sum > 5 * count) return false;
    copies_ += sum - count;
    tree_.nodes[node].first_child = static_cast<Index>(tree_.nodes.size());
    tree_.nodes[node].children = static_cast<Index>(boxes.size());
    for (std::size_t child = 0; child < boxes.size(); ++child) {
      tree_.nodes.push_back({boxes[child], 0, 0, 0, tree_.nodes[node].depth + 1});
      held_.push_back(std::move(parts[child]));
    }
    held_[node] = {};
    return true;
  }

  void make_leaf(Index node) {
    tree_.nodes[node].leaf = static_cast<Index>(tree_.leaves.size());
    tree_.leaves.items.insert(tree_.leaves.items.end(), held_[node].begin(), held_[node].end());
    tree_.leaves.first.push_back(tree_.leaves.items.size());
    held_[node] = {};
  }

  const PartitionItems& items_;
  const RegionLimits& limits_;
  const RegionSplit& split_;
  std::size_t copies_;
  RegionTree tree_;
  std::vector<std::vector<Index>> held_;  ///< by node, until it is cut or a leaf
};

}  // namespace

RegionTree build_regions(const PartitionItems& items, const Aabb& root, const RegionLimits& limits,
                         const RegionSplit& split) {
  return Build(items, limits, split).run(root);
}

std::vector<Index> RegionTree::candidates(const PartitionItems& items, const Aabb& box) const {
  std::vector<Index> found, waiting;
  if (!nodes.empty()) waiting.push_back(0);
  while (!waiting.empty()) {
    const Node& node = nodes[waiting.back()];
    waiting.pop_back();
    if (!overlap(node.box, box)) continue;
    for (Index child = 0; child < node.children; ++child) waiting.push_back(node.first_child + child);
    if (node.children > 0) continue;
    for (const Index item : leaves[node.leaf])
      if (overlap(items.boxes()[item], box)) found.push_back(item);
  }
  sort_unique(found);
  return found;
}

std::vector<IndexPair> RegionTree::candidate_pairs(const PartitionItems& items) const {
  const std::span<const Aabb> boxes = items.boxes();
  return pairs_sharing_lists(leaves, items.size(), {}, [&](Index a, Index b) { return overlap(boxes[a], boxes[b]); });
}

std::vector<PartitionCell> RegionTree::cells_at(Index depth) const {
  std::vector<PartitionCell> cells;
  std::vector<Index> cell_of(nodes.size());  // children come after their parent
  for (Index i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    if (node.depth == depth || (node.depth < depth && node.children == 0)) {
      cell_of[i] = static_cast<Index>(cells.size());
      cells.push_back({node.box, {}});
    }
    for (Index child = 0; child < node.children; ++child) cell_of[node.first_child + child] = cell_of[i];
    if (node.children > 0) continue;
    std::vector<Index>& items = cells[cell_of[i]].items;
    items.insert(items.end(), leaves[node.leaf].begin(), leaves[node.leaf].end());
  }
  for (PartitionCell& cell : cells) sort_unique(cell.items);
  std::erase_if(cells, [](const PartitionCell& cell) { return cell.items.empty(); });
  return cells;
}

Index RegionTree::greatest_depth() const {
  Index depth = 0;
  for (const Node& node : nodes) depth = std::max(depth, node.depth);
  return depth;
}

std::size_t RegionTree::bytes() const { return nodes.capacity() * sizeof(Node) + leaves.bytes(); }

}  // namespace toccata
