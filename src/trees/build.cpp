#include "toccata/trees/build.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace toccata {
namespace {

constexpr std::size_t bin_count = 16;

// Below this depth nodes are halved instead: boxes spread over many orders of magnitude cannot make the tree a list.
constexpr int greatest_heuristic_depth = 64;

struct Item {
  Aabb box;
  Vec3 centre;
  Index number;
};

Vec3 centre_of(const Aabb& box) { return 0.5 * box.lower + 0.5 * box.upper; }

/// What is known of a run of items: what a node needs, and where to split it.
struct Run {
  std::size_t first = 0;
  std::size_t count = 0;
  Aabb box;
  Aabb centres;
};

struct Task {
  Index node;
  int depth;
  Run run;
};

struct Bin {
  Aabb box;
  std::size_t count = 0;
};

using Bins = std::array<Bin, bin_count>;

/// Tells the slab of a centre.
class Slabs {
 public:
  explicit Slabs(const Aabb& centres) {
    const Vec3 size = centres.upper - centres.lower;
    axis_ = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    origin_ = centres.lower[axis_];
    scale_ = static_cast<double>(bin_count) / size[axis_];
  }

  /// Not where all centres coincide, or lie too near or too far apart for the arithmetic.
  [[nodiscard]] bool usable() const { return std::isfinite(scale_) && scale_ > 0; }

  [[nodiscard]] std::size_t of(const Vec3& centre) const {
    return std::min(static_cast<std::size_t>((centre[axis_] - origin_) * scale_), bin_count - 1);
  }

 private:
  int axis_ = 0;
  double origin_ = 0;
  double scale_ = 0;
};

double cost(const Bin& side) { return half_area(side.box) * static_cast<double>(side.count); }

void merge_into(Bin& side, const Bin& bin) {
  side.box = merge(side.box, bin.box);
  side.count += bin.count;
}

/// The first bin of the right side, where the cost is least; the first of equals.
std::size_t best_split(const Bins& bins) {
  std::array<double, bin_count> right_cost{};
  Bin right;
  for (std::size_t i = bin_count - 1; i > 0; --i) {
    merge_into(right, bins[i]);
    right_cost[i] = cost(right);
  }
  Bin left;
  std::size_t best = 1;
  double best_cost = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < bin_count; ++i) {
    merge_into(left, bins[i - 1]);
    const double both = cost(left) + right_cost[i];
    // Flat boxes cost nothing anywhere, so an empty side must not win.
    if (left.count == 0 || both >= best_cost) continue;
    best_cost = both;
    best = i;
  }
  return best;
}

class Builder {
 public:
  Builder(std::span<const Aabb> boxes, Index leaf_size) : leaf_size_(std::max<Index>(leaf_size, 1)) {
    items_.reserve(boxes.size());
    for (const Aabb& box : boxes) items_.push_back({box, centre_of(box), static_cast<Index>(items_.size())});
  }

  Tree<Aabb> build() {
    if (items_.empty()) return {};
    tree_.nodes.reserve(items_.size());
    add_node({0, items_.size(), {}, {}}, 0);
    while (!tasks_.empty()) {
      const Task task = tasks_.back();
      tasks_.pop_back();
      split(task);
    }
    tree_.items.reserve(items_.size());
    for (const Item& item : items_) tree_.items.push_back(item.number);
    return std::move(tree_);
  }

 private:
  std::span<Item> items_of(const Run& run) { return std::span(items_).subspan(run.first, run.count); }

  /// Adds the node of a run, and the task to split it when it is no leaf.
  void add_node(Run run, int depth) {
    for (const Item& item : items_of(run)) {
      run.box = merge(run.box, item.box);
      run.centres = merge(run.centres, item.centre);
    }
    const Index number = static_cast<Index>(tree_.nodes.size());
    const bool leaf = run.count <= leaf_size_;
    tree_.nodes.push_back({run.box, static_cast<Index>(run.first), leaf ? static_cast<Index>(run.count) : 0, 0});
    if (!leaf) tasks_.push_back({number, depth, run});
  }

  void split(const Task& task) {
    const std::size_t left = left_count(task);
    TreeNode<Aabb>& node = tree_.nodes[task.node];
    node.first = static_cast<Index>(tree_.nodes.size());
    node.child_count = 2;
    add_node({task.run.first, left, {}, {}}, task.depth + 1);
    add_node({task.run.first + left, task.run.count - left, {}, {}}, task.depth + 1);
  }

  /// Moves the items of the left child to the front and counts them: at least one, and not all.
  std::size_t left_count(const Task& task) {
    const std::size_t half = task.run.count / 2;
    const Slabs slabs(task.run.centres);
    if (!slabs.usable() || task.depth >= greatest_heuristic_depth) return half;
    const auto items = items_of(task.run);
    Bins bins;
    for (const Item& item : items) {
      Bin& bin = bins[slabs.of(item.centre)];
      bin.box = merge(bin.box, item.box);
      ++bin.count;
    }
    const std::size_t border = best_split(bins);
    const auto middle =
        std::partition(items.begin(), items.end(), [&](const Item& item) { return slabs.of(item.centre) < border; });
    const auto left = static_cast<std::size_t>(middle - items.begin());
    return left == 0 || left == items.size() ? half : left;
  }

  Index leaf_size_;
  std::vector<Item> items_;
  std::vector<Task> tasks_;
  Tree<Aabb> tree_;
};

}  // namespace

Tree<Aabb> build_tree(std::span<const Aabb> boxes, const BuildOptions& options) {
  return Builder(boxes, options.leaf_size).build();
}

}  // namespace toccata
