#include "toccata/broad/box_bvh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/box_bounds.hpp"
#include "math/constants.hpp"
#include "toccata/trees/builders.hpp"
#include "toccata/trees/walk.hpp"
#include "trees/best_first_walk.hpp"
#include "trees/refit_nodes.hpp"

namespace toccata {
namespace {

bool has_ends(const Aabb& box) { return is_finite(box.lower) && is_finite(box.upper); }

// The comparisons of `overlap` find an empty box in one that has no end on any side.
bool meet(const Aabb& a, const Aabb& b) { return !is_empty(a) && overlap(a, b); }

/// Boxes that overlap one.
class OverlapQuestion {
 public:
  OverlapQuestion(const Aabb& box, BoxBvh::See see) : box_(box), see_(see) {}
  double bound(const Aabb& node) const { return meet(node, box_) ? 0 : infinity; }
  double limit() const { return has_ended_ ? -1 : 0; }
  void visit(std::span<const Index> items) {
    for (const Index item : items)
      if (!has_ended_ && !see_(item)) has_ended_ = true;
  }

 private:
  const Aabb& box_;
  BoxBvh::See see_;
  bool has_ended_ = false;
};

/// Boxes in the order of what they cost.
template <class Cost>
class LeastFirst {
 public:
  LeastFirst(const Cost& cost, double limit, BoxBvh::SeeNear see) : cost_(cost), limit_(limit), see_(see) {}
  double bound(const Aabb& node) const { return cost_(node); }
  // An infinite bound is beyond an infinite limit.
  double limit() const { return std::min(limit_, std::numeric_limits<double>::max()); }
  void visit(std::span<const Index> items) {
    for (const Index item : items) limit_ = std::min(limit_, see_(item));
  }

 private:
  const Cost& cost_;
  double limit_;
  BoxBvh::SeeNear see_;
};

}  // namespace

void BoxBvh::update(std::span<const Aabb> boxes) {
  boxes_.assign(boxes.begin(), boxes.end());
  sort_out();
  constexpr std::size_t few = 16;
  const auto news = static_cast<std::size_t>(
      std::count_if(outside_.begin(), outside_.end(), [&](Index number) { return has_ends(boxes_[number]); }));
  if (news > few + tree_.items.size() / few) return build();
  if (tree_.nodes.empty()) return;
  refit();
  if (mean_octave() > built_octave_ + 1) build();
}

void BoxBvh::refit() {
  refit_nodes(tree_,
              [&](std::span<const Index> items) { return items[0] < boxes_.size() ? boxes_[items[0]] : Aabb{}; });
}

/// The logarithm of the areas of the nodes around several boxes, in the mean. Their sum would tell of the largest
/// alone: of the ground, and not of all that moves upon it.
double BoxBvh::mean_octave() const {
  double sum = 0, count = 0;
  for (const BvhNode<Aabb>& node : tree_.nodes) {
    if (node.is_leaf()) continue;
    sum += std::clamp(std::ilogb(half_area(node.volume)), -1100, 1100);
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

/// Puts down who is not in the tree.
void BoxBvh::sort_out() {
  in_tree_.resize(std::max(in_tree_.size(), boxes_.size()));
  outside_.clear();
  for (Index i = 0; i < boxes_.size(); ++i)
    if (!in_tree_[i] && !is_empty(boxes_[i])) outside_.push_back(i);
}

void BoxBvh::build() {
  in_tree_.assign(boxes_.size(), false);
  std::vector<Index> numbers;
  std::vector<Aabb> items;
  for (Index i = 0; i < boxes_.size(); ++i) {
    in_tree_[i] = has_ends(boxes_[i]);
    if (!in_tree_[i]) continue;
    numbers.push_back(i);
    items.push_back(boxes_[i]);
  }
  tree_ = build_bvh(items, {.leaf_size = 1});
  for (Index& item : tree_.items) item = numbers[item];
  built_octave_ = mean_octave();
  sort_out();
}

void BoxBvh::visit_overlapping(const Aabb& box, See see) const {
  if (is_empty(box)) return;
  OverlapQuestion question(box, see);
  for (const Index& number : outside_)
    if (meet(boxes_[number], box)) question.visit({&number, 1});
  walk(tree_, question);
}

std::vector<Index> BoxBvh::overlapping(const Aabb& box) const {
  std::vector<Index> found;
  visit_overlapping(box, [&](Index number) {
    found.push_back(number);
    return true;
  });
  std::sort(found.begin(), found.end());
  return found;
}

template <class Question>
void BoxBvh::walk_by(Question& question) const {
  std::vector<LooseItem> loose;
  loose.reserve(outside_.size());
  for (const Index number : outside_) loose.push_back({number, question.bound(boxes_[number])});
  walk_best_first(tree_, question, loose);
}

void BoxBvh::visit_nearest(const Aabb& from, double limit, SeeNear see) const {
  const auto cost = [&](const Aabb& box) { return box_gap(from, box); };
  LeastFirst question(cost, limit, see);
  walk_by(question);
}

void BoxBvh::visit_along(const Aabb& moving, const Vec3& motion, double limit, SeeNear see) const {
  const auto cost = [&](const Aabb& box) { return box_entry(moving, motion, box); };
  LeastFirst question(cost, std::min(limit, 1.0), see);
  walk_by(question);
}

std::size_t BoxBvh::bytes() const {
  return boxes_.capacity() * sizeof(Aabb) + tree_.nodes.capacity() * sizeof(tree_.nodes[0]) +
         (tree_.items.capacity() + outside_.capacity()) * sizeof(Index) + in_tree_.capacity() / 8;
}

}  // namespace toccata
