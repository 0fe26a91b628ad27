#include "toccata/trees/builders.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "bounds/point_clouds.hpp"
#include "toccata/core/error.hpp"
#include "trees/binary_shape.hpp"

namespace toccata {
namespace {

/// A power of two. Where things are all in one place, or nearly, it must not make the place itself too far away.
double factor_for(const Aabb& box) {
  const double farthest = std::max({std::abs(box.lower.x), std::abs(box.lower.y), std::abs(box.lower.z),
                                    std::abs(box.upper.x), std::abs(box.upper.y), std::abs(box.upper.z)});
  return std::min(CloudScale(box).factor, std::ldexp(1.0, 500 - std::ilogb(std::max(farthest, 0x1p-500))));
}

/// In a unit in which areas neither under- nor overflow; a power of two, so that nothing else changes.
ShapeItems items_of(std::span<const Triangle> triangles, int threads) {
  const double factor = factor_for(fit<Aabb>(triangles));
  ShapeItems items{std::vector<Triangle>(triangles.begin(), triangles.end()), std::vector<Aabb>(triangles.size()),
                   std::vector<Vec3>(triangles.size())};
  parallel_for(triangles.size(), threads, [&](std::size_t i) {
    Triangle& scaled = items.triangles[i];
    for (Vec3& corner : scaled.vertex) corner = factor * corner;
    items.boxes[i] = fit_aabb(scaled.vertex);
    items.centroids[i] = ((1.0 / 3) * scaled[0] + (1.0 / 3) * scaled[1]) + (1.0 / 3) * scaled[2];
  });
  return items;
}

BinaryShape binary_shape(const ShapeItems& items, const BvhOptions& options, int arity) {
  switch (options.method) {
    case BvhMethod::mean:
    case BvhMethod::median:
    case BvhMethod::equal_regions:
      return shape_from_top(items, options, arity);
    case BvhMethod::heuristic:
      return shape_by_heuristic(items);
    case BvhMethod::agglomeration:
      return shape_by_agglomeration(items, options.threads);
    case BvhMethod::insertion:
      return shape_by_insertion(items);
    case BvhMethod::morton:
      break;
  }
  return shape_by_codes(items, options.threads);
}

/// Parents before their children.
std::vector<Index> from_root(const BinaryShape& shape) {
  std::vector<Index> order{shape.root};
  for (std::size_t i = 0; i < order.size(); ++i)
    if (const Fork& fork = shape.forks[order[i]]; !fork.is_leaf()) {
      order.push_back(fork.left);
      order.push_back(fork.right);
    }
  return order;
}

std::vector<Index> counts_below(const BinaryShape& shape) {
  std::vector<Index> counts(shape.forks.size(), 1);
  const std::vector<Index> order = from_root(shape);
  for (std::size_t i = order.size(); i-- > 0;)
    if (const Fork& fork = shape.forks[order[i]]; !fork.is_leaf())
      counts[order[i]] = counts[fork.left] + counts[fork.right];
  return counts;
}

/// Gives a binary shape its arity and leaf size, and puts it into the order of trees.
class Arranger {
 public:
  Arranger(const BinaryShape& binary, Index arity, const BvhOptions& options)
      : binary_(binary),
        counts_(counts_below(binary)),
        arity_(arity),
        leaf_size_(std::max<Index>(options.leaf_size, 1)),
        by_regions_(options.method == BvhMethod::equal_regions) {}

  BvhShape arrange() {
    add_node();
    std::vector<Task> tasks{{binary_.root, 0}};
    while (!tasks.empty()) {
      const Task task = tasks.back();
      tasks.pop_back();
      if (counts_[task.fork] <= leaf_size_) {
        make_leaf(task);
        continue;
      }
      const std::vector<Index> children = children_of(task.fork);
      BvhNode<NoVolume>& node = shape_.nodes[task.node];
      node.first = static_cast<Index>(shape_.nodes.size());
      node.child_count = static_cast<Index>(children.size());
      const Index first = node.first;
      for (std::size_t i = 0; i < children.size(); ++i) add_node();
      // The last on the stack is the next: so items get into the order of the leaves.
      for (Index i = static_cast<Index>(children.size()); i-- > 0;) tasks.push_back({children[i], first + i});
    }
    return std::move(shape_);
  }

 private:
  struct Task {
    Index fork;
    Index node;
  };

  void add_node() { shape_.nodes.emplace_back(); }

  /// The children of a fork that has more items than a leaf may have: the child with the most items gives way to its
  /// own children, as long as there is room. With regions those give way that are cut further into the same parts.
  [[nodiscard]] std::vector<Index> children_of(Index fork) const {
    std::vector<Index> children{binary_.forks[fork].left, binary_.forks[fork].right};
    const auto rank = [&](Index i) { return by_regions_ && !binary_.forks[i].goes_on ? 0 : counts_[i]; };
    while (children.size() < arity_) {
      const auto opened =
          std::max_element(children.begin(), children.end(), [&](Index i, Index j) { return rank(i) < rank(j); });
      if (rank(*opened) <= leaf_size_) break;
      const Fork& parts = binary_.forks[*opened];
      *opened = parts.left;
      children.insert(opened + 1, parts.right);
    }
    return children;
  }

  void make_leaf(const Task& task) {
    BvhNode<NoVolume>& node = shape_.nodes[task.node];
    node.first = static_cast<Index>(shape_.items.size());
    node.count = counts_[task.fork];
    std::vector<Index> open{task.fork};
    while (!open.empty()) {
      const Fork& fork = binary_.forks[open.back()];
      open.pop_back();
      if (fork.is_leaf()) {
        shape_.items.push_back(fork.item);
      } else {
        open.push_back(fork.right);
        open.push_back(fork.left);
      }
    }
  }

  const BinaryShape& binary_;
  std::vector<Index> counts_;
  Index arity_;
  Index leaf_size_;
  bool by_regions_;
  BvhShape shape_;
};

}  // namespace

BvhShape build_bvh_shape(std::span<const Triangle> triangles, int arity, const BvhOptions& options) {
  if (arity < 2 || arity > 8)
    throw Error("a tree has 2 to 8 children a node, not " + std::to_string(arity) + "; choose another arity");
  if (triangles.empty()) return {};
  const BinaryShape binary = binary_shape(items_of(triangles, options.threads), options, arity);
  return Arranger(binary, static_cast<Index>(arity), options).arrange();
}

std::vector<ItemRun> item_runs(const BvhShape& shape) {
  std::vector<ItemRun> runs(shape.nodes.size());
  for (std::size_t i = shape.nodes.size(); i-- > 0;) {
    const BvhNode<NoVolume>& node = shape.nodes[i];
    if (node.is_leaf()) {
      runs[i] = {node.first, node.count};
      continue;
    }
    runs[i].first = runs[node.first].first;
    for (Index k = 0; k < node.child_count; ++k) runs[i].count += runs[node.first + k].count;
  }
  return runs;
}

BvhBalance balance_of(const BvhShape& shape, int arity) {
  BvhBalance balance;
  balance.nodes = shape.nodes.size();
  std::vector<int> depths(shape.nodes.size(), 0);
  double sum = 0;
  for (std::size_t i = 0; i < shape.nodes.size(); ++i) {
    const BvhNode<NoVolume>& node = shape.nodes[i];
    for (Index k = 0; k < node.child_count; ++k) depths[node.first + k] = depths[i] + 1;
    if (!node.is_leaf()) continue;
    balance.least_depth = balance.leaves == 0 ? depths[i] : std::min(balance.least_depth, depths[i]);
    balance.greatest_depth = std::max(balance.greatest_depth, depths[i]);
    ++balance.leaves;
    sum += depths[i];
  }
  if (balance.leaves > 0) balance.mean_depth = sum / static_cast<double>(balance.leaves);
  for (std::size_t room = 1; room < balance.leaves; room *= static_cast<std::size_t>(arity)) ++balance.best_depth;
  return balance;
}

}  // namespace toccata
