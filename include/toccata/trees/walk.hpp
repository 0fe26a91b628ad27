#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"
#include "toccata/trees/bvh.hpp"

namespace toccata {

/// An item of the first tree and one of the second. Where a tree is walked with itself, these are two different items,
/// first < second.
struct ItemPair {
  Index first;
  Index second;
  friend constexpr auto operator<=>(const ItemPair&, const ItemPair&) = default;
};

/// What a walk cost: the terms of the cost function N_u·C_u + N_bv·C_bv + N_p·C_p (S. Gottschalk, M. Lin, D. Manocha,
/// "OBBTree", 1996, section 2). Volumes are never updated here, so N_u is 0.
struct WalkCounts {
  std::size_t volumes_updated = 0;
  std::size_t volume_tests = 0;
  std::size_t items = 0;  ///< items of one tree, pairs of items of two

  friend constexpr bool operator==(const WalkCounts&, const WalkCounts&) = default;
};

/// A branch-and-bound question about the items of one tree:
///  - bound(volume): the least cost anything inside could have; +∞ when nothing inside is of interest;
///  - limit(): the largest cost still of interest, finite; −1 ends the walk. It may only shrink;
///  - visit(items): leaves, in batches.
template <class Q, class Volume>
concept Question = requires(Q& question, const Volume& volume, std::span<const Index> items) {
  { question.bound(volume) } -> std::convertible_to<double>;
  { question.limit() } -> std::convertible_to<double>;
  question.visit(items);
};

/// The same about pairs of items of two trees, or of one tree with itself. It may also say which of two inner nodes
/// to split, split_first(a, b); else the one of the larger volume is.
template <class Q, class VolumeA, class VolumeB = VolumeA>
concept PairQuestion = requires(Q& question, const VolumeA& a, const VolumeB& b, std::span<const ItemPair> pairs) {
  { question.bound(a, b) } -> std::convertible_to<double>;
  { question.limit() } -> std::convertible_to<double>;
  question.visit(pairs);
};

namespace walking {

/// Collects leaves and hands them on in batches: small ones first, so that a question that needs one item ends soon.
template <class Item>
class Batch {
 public:
  template <class Q>
  void add(const Item& item, Q& question) {
    items_[count_++] = item;
    if (count_ >= size_) flush(question);
  }
  /// The same of `count` items at once: `list` is called with a function that takes each.
  template <class Q, class List>
  void add_all(std::size_t count, Q& question, const List& list) {
    if (count > items_.size() - count_) {
      list([&](const Item& item) { add(item, question); });
      return;
    }
    Item* place = items_.data() + count_;
    list([&](const Item& item) { *place++ = item; });
    count_ += count;
    if (count_ >= size_) flush(question);
  }
  template <class Q>
  void flush(Q& question) {
    // A walk that has ended wants no more items.
    if (count_ > 0 && question.limit() >= 0) question.visit(std::span<const Item>(items_.data(), count_));
    total_ += count_;
    count_ = 0;
    size_ = std::min(2 * size_, items_.size());
  }
  /// How many were added, after the last flush.
  [[nodiscard]] std::size_t total() const { return total_; }

 private:
  std::array<Item, 256> items_;
  std::size_t count_ = 0;
  std::size_t size_ = 16;
  std::size_t total_ = 0;
};

struct PendingNode {
  Index node;
  double bound;
};

struct PendingPair {
  Index a;
  Index b;
  double bound;
};

template <class Volume>
std::span<const Index> items_of(const BvhNode<Volume>& leaf, const std::vector<Index>& items) {
  return std::span(items).subspan(leaf.first, leaf.count);
}

// Which comparison decides matters for NaN: a bound that is not a number must not lose anything.
inline bool is_pruned(double bound, double limit) { return bound > limit; }

template <class VolumeA, class VolumeB, class Q>
bool splits_a(const BvhNode<VolumeA>& a, const BvhNode<VolumeB>& b, const Q& question) {
  if (a.is_leaf() || b.is_leaf()) return !a.is_leaf();
  if constexpr (requires { question.split_first(a.volume, b.volume); })
    return question.split_first(a.volume, b.volume);
  else
    return half_area(a.volume) >= half_area(b.volume);
}

enum class Order {
  as_found,     ///< (item of the first tree, item of the second)
  least_first,  ///< where a tree is walked with itself: the smaller item number first
};

/// One walk over pairs of nodes. The stack grows as needed; nothing is dropped.
template <Order order, class TreeA, class TreeB, class Q>
class PairWalk {
 public:
  PairWalk(const TreeA& a, const TreeB& b, Q& question) : a_(a), b_(b), question_(question) {}

  /// Tests two nodes and keeps them for later where they are of interest.
  void push(Index a, Index b) {
    ++counts_.volume_tests;
    const double bound = question_.bound(a_.nodes[a].volume, b_.nodes[b].volume);
    if (!is_pruned(bound, question_.limit())) stack_.push_back({a, b, bound});
  }

  void push_untested(Index a, Index b) { stack_.push_back({a, b, 0}); }

  WalkCounts run() {
    while (!stack_.empty() && question_.limit() >= 0) {
      const PendingPair pair = stack_.back();
      stack_.pop_back();
      if (!is_pruned(pair.bound, question_.limit())) expand(pair.a, pair.b);
    }
    batch_.flush(question_);
    counts_.items = batch_.total();
    return counts_;
  }

 private:
  void expand(Index a, Index b) {
    if (order == Order::least_first && a == b)
      expand_self(a);
    else
      expand_pair(a, b);
  }

  // Children are pushed last first, so that the first is on top of the stack.
  void expand_pair(Index number_a, Index number_b) {
    const auto& a = a_.nodes[number_a];
    const auto& b = b_.nodes[number_b];
    if (a.is_leaf() && b.is_leaf())
      add_all(items_of(a, a_.items), items_of(b, b_.items));
    else if (splits_a(a, b, question_))
      for (Index i = a.child_count; i-- > 0;) push(a.first + i, number_b);
    else
      for (Index i = b.child_count; i-- > 0;) push(number_a, b.first + i);
  }

  /// A node with itself: each child with itself, and each two children.
  void expand_self(Index number) {
    const auto& node = a_.nodes[number];
    if (node.is_leaf()) {
      const auto items = items_of(node, a_.items);
      batch_.add_all(items.size() * (items.size() - 1) / 2, question_, [&](const auto& take) {
        for (std::size_t i = 0; i < items.size(); ++i)
          for (std::size_t j = i + 1; j < items.size(); ++j) take(pair_of(items[i], items[j]));
      });
      return;
    }
    for (Index i = node.child_count; i-- > 0;) {
      for (Index j = node.child_count; j-- > i + 1;) push(node.first + i, node.first + j);
      push_untested(node.first + i, node.first + i);
    }
  }

  void add_all(std::span<const Index> a, std::span<const Index> b) {
    batch_.add_all(a.size() * b.size(), question_, [&](const auto& take) {
      for (const Index i : a)
        for (const Index j : b) take(pair_of(i, j));
    });
  }

  static ItemPair pair_of(Index i, Index j) {
    return order == Order::as_found ? ItemPair{i, j} : ItemPair{std::min(i, j), std::max(i, j)};
  }

  const TreeA& a_;
  const TreeB& b_;
  Q& question_;
  std::vector<PendingPair> stack_;
  Batch<ItemPair> batch_;
  WalkCounts counts_;
};

}  // namespace walking

/// Asks a question about the items of one tree. Depth first, first child first.
template <class Volume, int Arity, Question<Volume> Q>
WalkCounts walk(const Bvh<Volume, Arity>& tree, Q& question) {
  WalkCounts counts;
  walking::Batch<Index> batch;
  std::vector<walking::PendingNode> stack;
  const auto push = [&](Index node) {
    ++counts.volume_tests;
    const double bound = question.bound(tree.nodes[node].volume);
    if (!walking::is_pruned(bound, question.limit())) stack.push_back({node, bound});
  };
  if (!tree.nodes.empty()) push(0);
  while (!stack.empty() && question.limit() >= 0) {
    const walking::PendingNode pending = stack.back();
    stack.pop_back();
    if (walking::is_pruned(pending.bound, question.limit())) continue;
    const BvhNode<Volume>& node = tree.nodes[pending.node];
    for (Index i = node.child_count; i-- > 0;) push(node.first + i);
    if (node.is_leaf())
      batch.add_all(node.count, question, [&](const auto& take) {
        for (const Index item : walking::items_of(node, tree.items)) take(item);
      });
  }
  batch.flush(question);
  counts.items = batch.total();
  return counts;
}

/// Asks a question about the pairs (item of a, item of b). The larger of two volumes is split.
template <class VolumeA, int ArityA, class VolumeB, int ArityB, PairQuestion<VolumeA, VolumeB> Q>
WalkCounts walk_pair(const Bvh<VolumeA, ArityA>& a, const Bvh<VolumeB, ArityB>& b, Q& question) {
  walking::PairWalk<walking::Order::as_found, Bvh<VolumeA, ArityA>, Bvh<VolumeB, ArityB>, Q> search(a, b, question);
  if (!a.nodes.empty() && !b.nodes.empty()) search.push(0, 0);
  return search.run();
}

/// Asks a question about each two different items of one tree, each unordered pair once, the smaller number first.
template <class Volume, int Arity, PairQuestion<Volume> Q>
WalkCounts walk_self(const Bvh<Volume, Arity>& tree, Q& question) {
  walking::PairWalk<walking::Order::least_first, Bvh<Volume, Arity>, Bvh<Volume, Arity>, Q> search(tree, tree,
                                                                                                   question);
  if (!tree.nodes.empty()) search.push_untested(0, 0);
  return search.run();
}

}  // namespace toccata
