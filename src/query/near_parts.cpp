#include "query/near_parts.hpp"

#include <algorithm>

#include "bounds/box_bounds.hpp"

namespace toccata {
namespace {

void put_boxes(const PosedModel& model, std::vector<Aabb>& boxes) {
  boxes.clear();
  for (const PosedPart& part : model.parts) boxes.push_back(world_box(part.shape));
}

/// A mesh without triangles has no box.
double gap_of(const Aabb& a, const Aabb& b) { return is_empty(a) ? box_gap(b, a) : box_gap(a, b); }

}  // namespace

NearParts::NearParts(const PosedModel& a, const PosedModel& b, double limit, SearchScratch& scratch)
    : scratch_(scratch) {
  auto& [boxes_a, boxes_b] = scratch.part_boxes;
  put_boxes(a, boxes_a);
  put_boxes(b, boxes_b);
  std::vector<PartPair>& pairs = scratch.part_pairs;
  pairs.clear();
  for (Index i = 0; i < boxes_a.size(); ++i)
    for (Index j = 0; j < boxes_b.size(); ++j)
      if (const double gap = gap_of(boxes_a[i], boxes_b[j]); gap <= limit) pairs.push_back({gap, {i, j}});
  std::make_heap(pairs.begin(), pairs.end());
}

std::optional<ItemPair> NearParts::next(double limit) {
  std::vector<PartPair>& pairs = scratch_.part_pairs;
  if (pairs.empty() || !(pairs.front().gap <= limit)) return {};
  const ItemPair parts = pairs.front().parts;
  std::pop_heap(pairs.begin(), pairs.end());
  pairs.pop_back();
  // What was kept of the last pair is of other parts.
  scratch_.convex.simplex_size = 0;
  return parts;
}

}  // namespace toccata
