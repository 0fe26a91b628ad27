#include "partitions/r_tree_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "partitions/r_tree_split.hpp"

namespace toccata {
namespace {

/// Boxes without end have differences that are no numbers: these are no better than any.
bool is_less(double a, double b) { return a < b || (std::isnan(b) && !std::isnan(a)); }

}  // namespace

Aabb RTreeNodes::box_of(const Node& node) {
  Aabb box;
  for (std::size_t i = 0; i < node.count; ++i) box = merge(box, node.box[i]);
  return box;
}

std::size_t RTreeNodes::entry_in(Index node, Index child) const {
  const Node& in = nodes_[node];
  return static_cast<std::size_t>(std::find(in.child.begin(), in.child.begin() + in.count, child) - in.child.begin());
}

const Aabb& RTreeNodes::box(Index number) const {
  const Index leaf = leaf_of_[number];
  return nodes_[leaf].box[entry_in(leaf, number)];
}

Index RTreeNodes::new_node(std::uint32_t level) {
  Index node = static_cast<Index>(nodes_.size());
  if (free_.empty()) {
    nodes_.emplace_back();
  } else {
    node = free_.back();
    free_.pop_back();
    nodes_[node] = {};
  }
  nodes_[node].level = level;
  return node;
}

/// Tells the child who holds it.
void RTreeNodes::claim(Index node, Index child) {
  (nodes_[node].level == 0 ? leaf_of_[child] : nodes_[child].parent) = node;
}

void RTreeNodes::append(Index node, const Entry& entry) {
  Node& to = nodes_[node];
  to.box[to.count] = entry.box;
  to.child[to.count++] = entry.child;
  claim(node, entry.child);
}

void RTreeNodes::erase_entry(Index node, std::size_t entry) {
  Node& from = nodes_[node];
  --from.count;
  from.box[entry] = from.box[from.count];
  from.child[entry] = from.child[from.count];
}

void RTreeNodes::build(std::span<const Aabb> boxes) {
  nodes_.clear();
  free_.clear();
  leaf_of_.assign(boxes.size(), none);
  root_ = none;
  std::vector<Entry> entries;
  for (Index number = 0; number < boxes.size(); ++number)
    if (!is_empty(boxes[number])) entries.push_back({boxes[number], number});
  size_ = entries.size();
  if (size_ > 0) build_level(std::move(entries), 0);
}

/// As few nodes as hold the entries, each as full as the others.
void RTreeNodes::build_level(std::vector<Entry> entries, std::uint32_t level) {
  const std::size_t count = entries.size(), tiles = (count + most - 1) / most;
  std::vector<std::size_t> first(tiles + 1);
  for (std::size_t tile = 0; tile <= tiles; ++tile) first[tile] = tile * count / tiles;
  std::vector<Aabb> boxes(count);
  std::vector<Index> order(count);
  for (Index i = 0; i < count; ++i) {
    boxes[i] = entries[i].box;
    order[i] = i;
  }
  sort_into_tiles(boxes, order, first);
  std::vector<Entry> above;
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    const Index node = new_node(level);
    for (std::size_t i = first[tile]; i < first[tile + 1]; ++i) append(node, entries[order[i]]);
    above.push_back({box_of(nodes_[node]), node});
  }
  if (tiles > 1) return build_level(std::move(above), level + 1);
  root_ = above.front().child;
}

void RTreeNodes::insert(Index number, const Aabb& box) {
  if (leaf_of_.size() <= number) leaf_of_.resize(number + std::size_t{1}, none);
  if (root_ == none) root_ = new_node(0);
  insert_at({box, number}, 0);
  ++size_;
}

void RTreeNodes::insert_at(const Entry& entry, std::uint32_t level) {
  const Index node = choose(entry.box, level);
  if (nodes_[node].count == most) return split(node, entry);
  append(node, entry);
  refit_from(node);
}

/// Down to the level, each time where the area grows least, of equal growth where it is least (A. Guttman, "R-trees: a
/// dynamic index structure for spatial searching", 1984, section 3.2).
Index RTreeNodes::choose(const Aabb& box, std::uint32_t level) const {
  Index node = root_;
  while (nodes_[node].level > level) {
    const Node& at = nodes_[node];
    std::size_t best = 0;
    double best_growth = 0, best_area = 0;
    for (std::size_t i = 0; i < at.count; ++i) {
      const double area = half_area(at.box[i]), growth = half_area(merge(at.box[i], box)) - area;
      if (i > 0 && !is_less(growth, best_growth) && !(growth == best_growth && area < best_area)) continue;
      best = i;
      best_growth = growth;
      best_area = area;
    }
    node = at.child[best];
  }
  return node;
}

void RTreeNodes::split(Index node, const Entry& entry) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < most; ++i) entries.push_back({nodes_[node].box[i], nodes_[node].child[i]});
  entries.push_back(entry);
  std::vector<Aabb> boxes;
  for (const Entry& each : entries) boxes.push_back(each.box);
  const NodeSplit shared = split_of(boxes, least);
  const Index other = new_node(nodes_[node].level);
  nodes_[node].count = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) append(i < shared.first ? node : other, entries[shared.order[i]]);
  if (node == root_) return grow_root(node, other);
  const Index parent = nodes_[node].parent;
  nodes_[parent].box[entry_in(parent, node)] = box_of(nodes_[node]);
  const Entry beside{box_of(nodes_[other]), other};
  if (nodes_[parent].count == most) return split(parent, beside);
  append(parent, beside);
  refit_from(parent);
}

void RTreeNodes::grow_root(Index left, Index right) {
  root_ = new_node(nodes_[left].level + 1);
  append(root_, {box_of(nodes_[left]), left});
  append(root_, {box_of(nodes_[right]), right});
}

/// Upward until nothing changes.
void RTreeNodes::refit_from(Index node) {
  for (; node != root_; node = nodes_[node].parent) {
    const Index parent = nodes_[node].parent;
    Aabb& box = nodes_[parent].box[entry_in(parent, node)];
    const Aabb now = box_of(nodes_[node]);
    if (box == now) return;
    box = now;
  }
}

void RTreeNodes::remove(Index number) {
  const Index leaf = leaf_of_[number];
  erase_entry(leaf, entry_in(leaf, number));
  leaf_of_[number] = none;
  --size_;
  condense_from(leaf);
}

bool RTreeNodes::move(Index number, const Aabb& box) {
  const Index leaf = leaf_of_[number];
  const std::size_t entry = entry_in(leaf, number);
  const Index parent = nodes_[leaf].parent;
  if (leaf == root_ || toccata::contains(nodes_[parent].box[entry_in(parent, leaf)], box)) {
    nodes_[leaf].box[entry] = box;
    refit_from(leaf);
    return true;
  }
  remove(number);
  insert(number, box);
  return false;
}

/// Nodes that hold too few are taken out, and what they held is put in again where it belongs now (Guttman, section
/// 3.3).
void RTreeNodes::condense_from(Index node) {
  std::vector<std::pair<std::uint32_t, Entry>> homeless;  // with the level that they go into
  while (node != root_) {
    const Index parent = nodes_[node].parent;
    if (nodes_[node].count >= least) {
      refit_from(node);
      break;
    }
    for (std::size_t i = 0; i < nodes_[node].count; ++i)
      homeless.push_back({nodes_[node].level, {nodes_[node].box[i], nodes_[node].child[i]}});
    erase_entry(parent, entry_in(parent, node));
    free_.push_back(node);
    node = parent;
  }
  // The highest first: those below find their place among them.
  for (auto entry = homeless.rbegin(); entry != homeless.rend(); ++entry) insert_at(entry->second, entry->first);
  while (nodes_[root_].level > 0 && nodes_[root_].count == 1) {
    free_.push_back(root_);
    root_ = nodes_[root_].child[0];
  }
}

std::string RTreeNodes::complaint_about(Index node) const {
  const Node& at = nodes_[node];
  if (at.count > most || (node != root_ && at.count < least))
    return fmt::format("node {} has {} entries", node, at.count);
  for (std::size_t i = 0; i < at.count; ++i) {
    const Index child = at.child[i];
    if (at.level == 0) {
      if (leaf_of_[child] != node) return fmt::format("box {} is not where it is said to be", child);
      continue;
    }
    if (nodes_[child].parent != node || nodes_[child].level + 1 != at.level)
      return fmt::format("node {} is not below {}", child, node);
    if (box_of(nodes_[child]) != at.box[i]) return fmt::format("the box around node {} is not the least", child);
  }
  return {};
}

std::string RTreeNodes::complaint() const {
  std::size_t found = 0, seen = 0;
  std::vector<Index> waiting;
  if (root_ != none) waiting.push_back(root_);
  while (!waiting.empty()) {
    const Index node = waiting.back();
    waiting.pop_back();
    ++seen;
    if (std::string wrong = complaint_about(node); !wrong.empty()) return wrong;
    const Node& at = nodes_[node];
    if (at.level == 0)
      found += at.count;
    else
      waiting.insert(waiting.end(), at.child.begin(), at.child.begin() + at.count);
  }
  const auto held = static_cast<std::size_t>(
      std::count_if(leaf_of_.begin(), leaf_of_.end(), [](Index leaf) { return leaf != none; }));
  if (found != size_ || held != size_) return fmt::format("{} boxes in the tree, {} of {}", found, held, size_);
  return seen + free_.size() == nodes_.size() ? "" : "a node is lost";
}

}  // namespace toccata
