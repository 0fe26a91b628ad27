#include <algorithm>
#include <cmath>

#include "toccata/bounds/obb.hpp"
#include "toccata/trees/builders.hpp"
#include "trees/binary_shape.hpp"

namespace toccata {
namespace {

// Below this depth nodes are halved: centroids over many orders of magnitude cannot make the tree a list.
constexpr int greatest_split_depth = 64;

// Runs that are not larger become a task each for one thread.
constexpr std::size_t most_of_a_task = 4096;

/// A run of items that is to be split, and the fork it becomes. The forks below it have the numbers after it.
struct SplitRun {
  std::size_t first;
  std::size_t count;
  Index fork;
  int depth;
};

class TopDown {
 public:
  TopDown(const ShapeItems& items, BvhMethod method) : items_(items), method_(method) {
    for (Index i = 0; i < items.boxes.size(); ++i) order_.push_back(i);
  }

  /// Runs of one depth side by side, each on one thread; none touches what is another's.
  BinaryShape build(BvhDriver driver, int threads) {
    shape_.forks.resize(2 * order_.size() - 1);
    shape_.root = 0;
    std::vector<SplitRun> tasks{{0, order_.size(), 0, 0}};
    while (!tasks.empty()) {
      std::vector<Halves> halves(tasks.size());
      parallel_for(tasks.size(), threads, [&](std::size_t i) {
        if (tasks[i].count > most_of_a_task)
          halves[i] = split(tasks[i]);
        else if (driver == BvhDriver::recursive)
          build_recursively(tasks[i]);
        else
          build_iteratively(tasks[i]);
      });
      tasks.clear();
      for (const Halves& each : halves)
        if (each.left.count > 0) tasks.insert(tasks.end(), {each.left, each.right});
    }
    return std::move(shape_);
  }

 private:
  void build_recursively(const SplitRun& task) {
    if (is_leaf(task)) return;
    const auto [left, right] = split(task);
    build_recursively(left);
    build_recursively(right);
  }

  void build_iteratively(const SplitRun& all) {
    std::vector<SplitRun> tasks{all};
    while (!tasks.empty()) {
      const SplitRun task = tasks.back();
      tasks.pop_back();
      if (is_leaf(task)) continue;
      const auto [left, right] = split(task);
      tasks.push_back(right);
      tasks.push_back(left);
    }
  }

  struct Halves {
    SplitRun left{};
    SplitRun right{};
  };

  /// If it is one, takes note of its item.
  bool is_leaf(const SplitRun& task) {
    if (task.count == 1) shape_.forks[task.fork].item = order_[task.first];
    return task.count == 1;
  }

  /// So many items have one fork less than twice as many, in which a part's come right after its parent's.
  Halves split(const SplitRun& task) {
    const auto run = std::span(order_).subspan(task.first, task.count);
    std::size_t border = 0;
    if (task.depth < greatest_split_depth)
      border = method_ == BvhMethod::mean ? split_at_mean(run) : split_at_median(run);
    if (border == 0 || border == run.size()) border = run.size() / 2;
    const Index left = task.fork + 1, right = task.fork + static_cast<Index>(2 * border);
    shape_.forks[task.fork] = {left, right, no_index};
    return {{task.first, border, left, task.depth + 1},
            {task.first + border, task.count - border, right, task.depth + 1}};
  }

  /// How many come first; all or none when no axis parts them.
  std::size_t split_at_mean(std::span<Index> run) const {
    std::vector<Triangle> below;
    below.reserve(run.size());
    for (const Index item : run) below.push_back(items_.triangles[item]);
    const PrincipalAxes spread = principal_axes(below);
    for (int axis = 0; axis < 3; ++axis) {
      const auto before = [&](Index item) { return dot(spread.axes[axis], items_.centroids[item] - spread.mean) < 0; };
      const auto border = std::partition(run.begin(), run.end(), before);
      if (border != run.begin() && border != run.end()) return static_cast<std::size_t>(border - run.begin());
    }
    return 0;
  }

  std::size_t split_at_median(std::span<Index> run) const {
    Aabb centroids;
    for (const Index item : run) centroids = merge(centroids, items_.centroids[item]);
    const Vec3 size = centroids.upper - centroids.lower;
    const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    const auto middle = run.begin() + static_cast<std::ptrdiff_t>(run.size() / 2);
    std::nth_element(run.begin(), middle, run.end(), [&](Index i, Index j) {
      const double x = items_.centroids[i][axis], y = items_.centroids[j][axis];
      return x != y ? x < y : i < j;
    });
    return run.size() / 2;
  }

  const ShapeItems& items_;
  BvhMethod method_;
  std::vector<Index> order_;
  BinaryShape shape_;
};

}  // namespace

BinaryShape shape_from_top(const ShapeItems& items, const BvhOptions& options) {
  return TopDown(items, options.method).build(options.driver, options.threads);
}

BinaryShape shape_by_heuristic(const ShapeItems& items) {
  const Bvh<Aabb> tree = build_bvh(items.boxes, {.leaf_size = 1});
  BinaryShape shape;
  for (const BvhNode<Aabb>& node : tree.nodes)
    shape.forks.push_back(node.is_leaf() ? Fork{no_index, no_index, tree.items[node.first]}
                                         : Fork{node.first, node.first + 1, no_index});
  shape.root = 0;
  return shape;
}

}  // namespace toccata
