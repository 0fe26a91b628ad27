#include <algorithm>
#include <utility>

#include "methods/bsp/bsp_choice.hpp"
#include "methods/bsp/bsp_parts.hpp"
#include "methods/bsp/bsp_windings.hpp"

namespace toccata {
namespace {

/// What is still to be cut: the fragments within a cell, and which child of which node it will be.
struct CellToCut {
  std::vector<PooledFragment> fragments;
  std::size_t parent = 0;
  bool in_front = false;
  std::size_t depth = 0;  ///< nodes above it
  std::size_t mark = 0;   ///< of the pool, behind its fragments
};

/// A cell in which no surface is left. It is bounded by a fragment of this triangle, and lies on that side of it.
struct EmptyCell {
  Index triangle = 0;
  bool in_front = false;
};

class BspBuilder {
 public:
  BspBuilder(BspTree::Parts& parts, const BspOptions& options, BspCellVisitor visit)
      : parts_(parts),
        options_(options),
        visit_(visit),
        fragments_(parts.planes, parts.frame),
        choice_(parts.frame, parts.planes, fragments_, options) {}

  void run();

 private:
  void cut(CellToCut cell);
  void append_node(BspPlane plane, const RoundedBspPlane& rounded);
  void keep(const PooledFragment& fragment);
  void append_child(std::vector<PooledFragment> inside, bool in_front, const CellToCut& parent);
  void attach(std::size_t node, bool in_front, BspChild child);
  void name_leaves();
  void finish();

  BspTree::Parts& parts_;
  const BspOptions& options_;
  BspCellVisitor visit_;
  BspFragments fragments_;
  BspChoice choice_;
  std::vector<CellToCut> waiting_;
  std::vector<EmptyCell> empty_;
  std::size_t depths_ = 0;  ///< of all empty cells together
};

void BspBuilder::run() {
  CellToCut all;
  for (Index t = 0; t < parts_.planes.triangle_count(); ++t) all.fragments.push_back(fragments_.whole(t));
  all.mark = fragments_.mark();
  waiting_.push_back(std::move(all));
  while (!waiting_.empty()) {
    CellToCut cell = std::move(waiting_.back());
    waiting_.pop_back();
    fragments_.forget_after(cell.mark);
    cut(std::move(cell));
  }
  finish();
}

void BspBuilder::cut(CellToCut cell) {
  const BspPlane plane = choice_.of(cell.fragments, [](const PooledFragment& fragment) { return fragment.triangle; });
  const std::size_t node = parts_.nodes.size();
  const RoundedBspPlane rounded = parts_.planes.rounded(plane);
  append_node(plane, rounded);
  if (node > 0) attach(cell.parent, cell.in_front, static_cast<BspChild>(node));
  std::vector<PooledFragment> front, back, within;
  for (const PooledFragment& fragment : cell.fragments) {
    const SplitFragment split = fragments_.split(fragment, plane, rounded);
    if (split.front.count != 0) front.push_back(split.front);
    if (split.back.count != 0) back.push_back(split.back);
    if (split.within.count != 0) within.push_back(split.within);
    if (split.front.count == 0 && split.back.count == 0) keep(fragment);
    parts_.statistics.splits += split.front.count != 0 && split.back.count != 0;
  }
  const Index triangles = parts_.planes.triangle_count();
  require_growth_allowed(triangles + static_cast<double>(parts_.statistics.splits), triangles, options_);
  visit_({node, cell.depth, within}, fragments_, choice_);
  // The last is done first: nodes in front follow their parent in memory.
  cell.parent = node;
  append_child(std::move(back), false, cell);
  append_child(std::move(front), true, cell);
}

void BspBuilder::append_node(BspPlane plane, const RoundedBspPlane& rounded) {
  parts_.nodes.push_back({as_floats(rounded), {}, plane});
  parts_.first_fragment.push_back(static_cast<Index>(parts_.fragments.size()));
  parts_.statistics.axis_nodes += parts_.planes.is_axis(plane);
}

void BspBuilder::keep(const PooledFragment& fragment) {
  parts_.fragments.push_back({fragment.triangle, static_cast<Index>(parts_.corners.size())});
  for (std::size_t i = 0; i < fragment.count; ++i)
    parts_.corners.push_back(parts_.frame.world(fragments_.corner(fragment, i).place));
}

/// A plane across an axis has something on both sides, so an empty cell lies beside a plane of a triangle, and a
/// fragment of that triangle is on its border.
void BspBuilder::append_child(std::vector<PooledFragment> inside, bool in_front, const CellToCut& parent) {
  const std::size_t depth = parent.depth + 1;
  if (!inside.empty()) {
    waiting_.push_back({std::move(inside), parent.parent, in_front, depth, fragments_.mark()});
    return;
  }
  attach(parent.parent, in_front, -1 - static_cast<BspChild>(empty_.size()));
  empty_.push_back({parts_.nodes[parent.parent].plane, in_front});
  depths_ += depth;
  parts_.statistics.depth = std::max(parts_.statistics.depth, depth);
}

void BspBuilder::attach(std::size_t node, bool in_front, BspChild child) {
  parts_.nodes[node].child[in_front ? 1 : 0] = child;
}

/// Puts the winding numbers in the place of the numbers of empty cells.
void BspBuilder::name_leaves() {
  const std::vector<int> in_front = windings_in_front(parts_.model);
  const auto named = [&](BspChild child) {
    if (!is_leaf(child)) return child;
    const EmptyCell& cell = empty_[static_cast<std::size_t>(-1 - child)];
    return leaf_of_winding(in_front[cell.triangle] + (cell.in_front ? 0 : 1));
  };
  for (BspNode& node : parts_.nodes)
    for (BspChild& child : node.child) child = named(child);
}

void BspBuilder::finish() {
  name_leaves();
  BspStatistics& statistics = parts_.statistics;
  statistics.triangles = parts_.planes.triangle_count();
  statistics.nodes = parts_.nodes.size();
  statistics.leaves = empty_.size();
  statistics.fragments = parts_.fragments.size();
  statistics.mean_depth = static_cast<double>(depths_) / static_cast<double>(empty_.size());
  parts_.first_fragment.push_back(static_cast<Index>(parts_.fragments.size()));
  parts_.fragments.push_back({0, static_cast<Index>(parts_.corners.size())});
  parts_.nodes.shrink_to_fit();
  parts_.fragments.shrink_to_fit();
  parts_.corners.shrink_to_fit();
  statistics.bytes = parts_.nodes.size() * (sizeof(BspNode) + sizeof(Index)) +
                     parts_.fragments.size() * sizeof(StoredFragment) + parts_.corners.size() * sizeof(Vec3) +
                     parts_.planes.bytes();
}

}  // namespace

void build_bsp(BspTree::Parts& parts, const BspOptions& options, BspCellVisitor visit) {
  BspBuilder(parts, options, visit).run();
}

}  // namespace toccata
