#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "toccata/trees/walk.hpp"

namespace toccata {

/// An item that is in no tree, and the least cost that it could have.
struct LooseItem {
  Index item;
  double bound;
};

namespace walking {

/// One walk in the order of the bounds. What waits is a heap, the least bound on top.
template <class Volume, int Arity, class Q>
class BestFirstWalk {
 public:
  BestFirstWalk(const Bvh<Volume, Arity>& tree, std::span<const LooseItem> loose, Q& question)
      : tree_(tree), loose_(loose), question_(question) {
    waiting_.reserve(64);
    for (Index i = 0; i < loose.size(); ++i) wait({node_count() + i, loose[i].bound});
    if (!tree.nodes.empty()) wait(bounded(0));
  }

  WalkCounts run() {
    while (!waiting_.empty() && question_.limit() >= 0) {
      const PendingNode next = take();
      if (is_pruned(next.bound, question_.limit())) break;
      see(next.node);
    }
    return counts_;
  }

 private:
  [[nodiscard]] Index node_count() const { return static_cast<Index>(tree_.nodes.size()); }

  static bool comes_later(const PendingNode& a, const PendingNode& b) {
    return a.bound != b.bound ? a.bound > b.bound : a.node > b.node;
  }

  PendingNode bounded(Index node) {
    ++counts_.volume_tests;
    return {node, question_.bound(tree_.nodes[node].volume)};
  }

  void wait(const PendingNode& node) {
    if (is_pruned(node.bound, question_.limit())) return;
    waiting_.push_back(node);
    std::push_heap(waiting_.begin(), waiting_.end(), comes_later);
  }

  PendingNode take() {
    std::pop_heap(waiting_.begin(), waiting_.end(), comes_later);
    const PendingNode least = waiting_.back();
    waiting_.pop_back();
    return least;
  }

  void see(Index number) {
    if (number >= node_count()) return visit({&loose_[number - node_count()].item, 1});
    // The least child goes on at once where nothing that waits comes before it.
    while (true) {
      const BvhNode<Volume>& node = tree_.nodes[number];
      if (node.is_leaf()) return visit(items_of(node, tree_.items));
      PendingNode least = bounded(node.first);
      for (Index i = 1; i < node.child_count; ++i) {
        PendingNode child = bounded(node.first + i);
        if (comes_later(least, child)) std::swap(least, child);
        wait(child);
      }
      if (!waiting_.empty() && comes_later(least, waiting_.front())) return wait(least);
      if (is_pruned(least.bound, question_.limit())) return;
      number = least.node;
    }
  }

  void visit(std::span<const Index> items) {
    counts_.items += items.size();
    question_.visit(items);
  }

  const Bvh<Volume, Arity>& tree_;
  std::span<const LooseItem> loose_;
  Q& question_;
  std::vector<PendingNode> waiting_;
  WalkCounts counts_;
};

}  // namespace walking

/// Asks a question about the items of one tree, and about some that are in no tree, in the order of their bounds: of a
/// tree with one item in each leaf exactly those are visited whose bound is at most the limit as it is at the end,
/// whatever the shape of the tree. Volumes below another have no lesser bounds, and none is NaN.
template <class Volume, int Arity, Question<Volume> Q>
WalkCounts walk_best_first(const Bvh<Volume, Arity>& tree, Q& question, std::span<const LooseItem> loose = {}) {
  return walking::BestFirstWalk<Volume, Arity, Q>(tree, loose, question).run();
}

}  // namespace toccata
