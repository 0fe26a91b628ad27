#include "query/near_parts.hpp"

#include <algorithm>

namespace toccata {
namespace {

void start_tree(const PosedModel& model, std::vector<Aabb>& boxes, PartTree& tree) {
  boxes.clear();
  for (const PosedPart& part : model.parts) boxes.push_back(world_box(part.shape));
  tree.start(boxes);
}

}  // namespace

NearParts::NearParts(const PosedModel& a, const PosedModel& b, BoundOfBoxes bound, double limit, SearchScratch& scratch)
    : scratch_(scratch), bound_(bound) {
  start_tree(a, scratch.part_boxes[0], scratch.part_trees[0]);
  start_tree(b, scratch.part_boxes[1], scratch.part_trees[1]);
  scratch.part_pairs.clear();
  if (scratch.part_trees[0].is_empty() || scratch.part_trees[1].is_empty()) return;
  push({bound_(scratch.part_trees[0].node(0).box, scratch.part_trees[1].node(0).box), true, {0, 0}}, limit);
}

void NearParts::push(const PartPair& pair, double limit) {
  if (!(pair.bound <= limit)) return;
  scratch_.part_pairs.push_back(pair);
  std::push_heap(scratch_.part_pairs.begin(), scratch_.part_pairs.end());
}

/// Two leaves are the pairs of their parts; else the one of more parts is opened.
void NearParts::open(const ItemPair& pair, double limit) {
  PartTree &a = scratch_.part_trees[0], &b = scratch_.part_trees[1];
  const std::vector<Aabb>&boxes_a = scratch_.part_boxes[0], &boxes_b = scratch_.part_boxes[1];
  const PartTree::Node of_a = a.node(pair.first), of_b = b.node(pair.second);
  if (of_a.is_leaf() && of_b.is_leaf()) {
    for (Index i = of_a.first; i < of_a.last; ++i)
      for (Index j = of_b.first; j < of_b.last; ++j) {
        const ItemPair parts{a.part(i), b.part(j)};
        push({bound_(boxes_a[parts.first], boxes_b[parts.second]), false, parts}, limit);
      }
  } else if (!of_a.is_leaf() && (of_b.is_leaf() || of_a.count() >= of_b.count())) {
    const Index child = a.children(pair.first, boxes_a);
    for (const Index i : {child, child + 1}) push({bound_(a.node(i).box, of_b.box), true, {i, pair.second}}, limit);
  } else {
    const Index child = b.children(pair.second, boxes_b);
    for (const Index i : {child, child + 1}) push({bound_(of_a.box, b.node(i).box), true, {pair.first, i}}, limit);
  }
}

std::optional<ItemPair> NearParts::next(double limit) {
  std::vector<PartPair>& pairs = scratch_.part_pairs;
  while (!pairs.empty() && pairs.front().bound <= limit) {
    const PartPair next = pairs.front();
    std::pop_heap(pairs.begin(), pairs.end());
    pairs.pop_back();
    if (next.are_nodes) {
      open(next.items, limit);
      continue;
    }
    // What was kept of the last pair is of other parts.
    scratch_.convex.simplex_size = 0;
    return next.items;
  }
  return {};
}

}  // namespace toccata
