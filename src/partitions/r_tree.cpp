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

std::vector<PartitionCell> RTree::cells() const {
  std::vector<PartitionCell> cells;
  state_->nodes.each_node([&](const RTreeNodes::Node& node) {
    if (node.level > 0 || node.count == 0) return;
    PartitionCell cell{RTreeNodes::box_of(node), {node.child.begin(), node.child.begin() + node.count}};
    std::sort(cell.items.begin(), cell.items.end());
    cells.push_back(std::move(cell));
  });
  return cells;
}

std::size_t RTree::bytes() const { return state_->nodes.bytes(); }
std::string RTree::complaint() const { return state_->nodes.complaint(); }

}  // namespace toccata
