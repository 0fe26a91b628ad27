#include "toccata/partitions/r_tree.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "partitions/r_tree_nodes.hpp"
#include "toccata/core/error.hpp"

namespace toccata {

class RTree::State {
 public:
  RTreeNodes nodes;
};

namespace {

void require_box(Index number, const Aabb& box) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(box.lower[axis] <= box.upper[axis]))
      throw Error(
          fmt::format("box {}: its {} is not a number, or its lower one is above its upper one", number, "xyz"[axis]));
}

void require_number(const RTreeNodes& nodes, Index number) {
  if (!nodes.contains(number)) throw Error(fmt::format("there is no box {}: it was removed, or never put in", number));
}

}  // namespace

RTree::RTree() : state_(std::make_unique<State>()) {}
RTree::RTree(std::span<const Aabb> boxes) : RTree() {
  for (Index number = 0; number < boxes.size(); ++number) require_box(number, boxes[number]);
  state_->nodes.build(boxes);
}
RTree::RTree(const RTree& other) : state_(std::make_unique<State>(*other.state_)) {}
RTree::RTree(RTree&&) noexcept = default;
RTree& RTree::operator=(RTree other) noexcept {
  state_ = std::move(other.state_);
  return *this;
}
RTree::~RTree() = default;

void RTree::insert(Index number, const Aabb& box) {
  require_box(number, box);
  if (contains(number)) throw Error(fmt::format("box {} is there already: move it", number));
  state_->nodes.insert(number, box);
}
void RTree::remove(Index number) {
  require_number(state_->nodes, number);
  state_->nodes.remove(number);
}
void RTree::move(Index number, const Aabb& box) {
  require_box(number, box);
  require_number(state_->nodes, number);
  state_->nodes.move(number, box);
}

std::size_t RTree::size() const { return state_->nodes.size(); }
bool RTree::contains(Index number) const { return state_->nodes.contains(number); }
const Aabb& RTree::box(Index number) const {
  require_number(state_->nodes, number);
  return state_->nodes.box(number);
}

std::vector<Index> RTree::candidates(const Aabb& box) const {
  if (is_empty(box)) return {};  // its comparisons with a box without ends would find it
  std::vector<Index> found, waiting;
  state_->nodes.each_overlap(box, waiting, [&](Index number, const Aabb&) { found.push_back(number); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<IndexPair> RTree::candidate_pairs() const {
  std::vector<IndexPair> pairs;
  state_->nodes.each_pair([&](Index a, Index b) { pairs.push_back({std::min(a, b), std::max(a, b)}); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<PartitionCell> RTree::cells() const { return cells_at(greatest_depth()); }

std::vector<PartitionCell> RTree::cells_at(Index depth) const {
  const std::uint32_t height = greatest_depth(), level = height - std::min<std::uint32_t>(depth, height);
  std::vector<PartitionCell> cells;
  // A node is followed by all that is below it, before its next sibling.
  state_->nodes.each_node([&](const RTreeNodes::Node& node) {
    if (node.level == level && node.count > 0) cells.push_back({RTreeNodes::box_of(node), {}});
    if (node.level > 0 || node.count == 0) return;
    std::vector<Index>& items = cells.back().items;
    items.insert(items.end(), node.child.begin(), node.child.begin() + node.count);
  });
  for (PartitionCell& cell : cells) std::sort(cell.items.begin(), cell.items.end());
  return cells;
}

Index RTree::greatest_depth() const {
  Index height = 0;
  state_->nodes.each_node([&](const RTreeNodes::Node& node) { height = std::max(height, Index{node.level}); });
  return height;
}

std::size_t RTree::bytes() const { return state_->nodes.bytes(); }
std::string RTree::complaint() const { return state_->nodes.complaint(); }

}  // namespace toccata
