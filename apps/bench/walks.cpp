#include "walks.hpp"

#include <limits>

namespace toccata::bench {
namespace {

constexpr double out = std::numeric_limits<double>::infinity();

/// Pairs of items whose boxes overlap.
struct PairsOf {
  std::span<const Aabb> a;
  std::span<const Aabb> b;
  std::vector<ItemPair> found{};

  double bound(const Aabb& x, const Aabb& y) const { return overlap(x, y) ? 0 : out; }
  double limit() const { return 0; }
  void visit(std::span<const ItemPair> pairs) {
    for (const ItemPair& pair : pairs)
      if (overlap(a[pair.first], b[pair.second])) found.push_back(pair);
  }
};

/// Items whose boxes overlap one.
struct ItemsIn {
  std::span<const Aabb> boxes;
  Aabb wanted;
  std::vector<ItemPair> found{};

  double bound(const Aabb& box) const { return overlap(box, wanted) ? 0 : out; }
  double limit() const { return 0; }
  void visit(std::span<const Index> items) {
    for (const Index item : items)
      if (overlap(boxes[item], wanted)) found.push_back({item, 0});
  }
};

Walked generic_two_trees(const BoxBvh& a, const BoxBvh& b) {
  PairsOf question{a.boxes, b.boxes};
  const WalkCounts counts = walk_pair(a.tree, b.tree, question);
  return {std::move(question.found), counts};
}

Walked generic_self(const BoxBvh& a) {
  PairsOf question{a.boxes, a.boxes};
  const WalkCounts counts = walk_self(a.tree, question);
  return {std::move(question.found), counts};
}

Walked generic_one_tree(const BoxBvh& a, const Aabb& wanted) {
  ItemsIn question{a.boxes, wanted};
  const WalkCounts counts = walk(a.tree, question);
  return {std::move(question.found), counts};
}

using Node = BvhNode<Aabb>;

Walked by_hand_two_trees(const BoxBvh& a, const BoxBvh& b) {
  Walked walked;
  std::vector<ItemPair> stack;
  const auto consider = [&](Index i, Index j) {
    ++walked.counts.volume_tests;
    if (overlap(a.tree.nodes[i].volume, b.tree.nodes[j].volume)) stack.push_back({i, j});
  };
  consider(0, 0);
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    const Node &x = a.tree.nodes[i], &y = b.tree.nodes[j];
    if (x.is_leaf() && y.is_leaf()) {
      for (Index k = x.first; k < x.first + x.count; ++k)
        for (Index l = y.first; l < y.first + y.count; ++l) {
          const ItemPair pair{a.tree.items[k], b.tree.items[l]};
          ++walked.counts.items;
          if (overlap(a.boxes[pair.first], b.boxes[pair.second])) walked.found.push_back(pair);
        }
    } else if (y.is_leaf() || (!x.is_leaf() && half_area(x.volume) >= half_area(y.volume))) {
      consider(x.first + 1, j);
      consider(x.first, j);
    } else {
      consider(i, y.first + 1);
      consider(i, y.first);
    }
  }
  return walked;
}

Walked by_hand_self(const BoxBvh& a) {
  Walked walked;
  std::vector<ItemPair> stack{{0, 0}};
  const auto consider = [&](Index i, Index j) {
    ++walked.counts.volume_tests;
    if (overlap(a.tree.nodes[i].volume, a.tree.nodes[j].volume)) stack.push_back({i, j});
  };
  const auto compare = [&](Index k, Index l) {
    const ItemPair pair{std::min(a.tree.items[k], a.tree.items[l]), std::max(a.tree.items[k], a.tree.items[l])};
    ++walked.counts.items;
    if (overlap(a.boxes[pair.first], a.boxes[pair.second])) walked.found.push_back(pair);
  };
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    const Node &x = a.tree.nodes[i], &y = a.tree.nodes[j];
    if (i == j && x.is_leaf()) {
      for (Index k = x.first; k < x.first + x.count; ++k)
        for (Index l = k + 1; l < x.first + x.count; ++l) compare(k, l);
    } else if (i == j) {
      stack.push_back({x.first + 1, x.first + 1});
      consider(x.first, x.first + 1);
      stack.push_back({x.first, x.first});
    } else if (x.is_leaf() && y.is_leaf()) {
      for (Index k = x.first; k < x.first + x.count; ++k)
        for (Index l = y.first; l < y.first + y.count; ++l) compare(k, l);
    } else if (y.is_leaf() || (!x.is_leaf() && half_area(x.volume) >= half_area(y.volume))) {
      consider(x.first + 1, j);
      consider(x.first, j);
    } else {
      consider(i, y.first + 1);
      consider(i, y.first);
    }
  }
  return walked;
}

Walked by_hand_one_tree(const BoxBvh& a, const Aabb& wanted) {
  Walked walked;
  std::vector<Index> stack;
  const auto consider = [&](Index i) {
    ++walked.counts.volume_tests;
    if (overlap(a.tree.nodes[i].volume, wanted)) stack.push_back(i);
  };
  consider(0);
  while (!stack.empty()) {
    const Node& node = a.tree.nodes[stack.back()];
    stack.pop_back();
    if (node.is_leaf()) {
      for (Index k = node.first; k < node.first + node.count; ++k) {
        ++walked.counts.items;
        if (overlap(a.boxes[a.tree.items[k]], wanted)) walked.found.push_back({a.tree.items[k], 0});
      }
    } else {
      consider(node.first + 1);
      consider(node.first);
    }
  }
  return walked;
}

}  // namespace

Walked walked(Walk walk, Method method, const BoxBvh& a, const BoxBvh& b) {
  const bool generic = method == Method::generic;
  switch (walk) {
    case Walk::two_trees:
      return generic ? generic_two_trees(a, b) : by_hand_two_trees(a, b);
    case Walk::self:
      return generic ? generic_self(a) : by_hand_self(a);
    case Walk::one_tree:
      break;
  }
  const Aabb& wanted = b.tree.nodes.front().volume;
  return generic ? generic_one_tree(a, wanted) : by_hand_one_tree(a, wanted);
}

}  // namespace toccata::bench
