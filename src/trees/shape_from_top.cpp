#include <algorithm>
#include <cmath>

#include "toccata/bounds/principal_axes.hpp"
#include "toccata/trees/build.hpp"
#include "trees/binary_shape.hpp"

namespace toccata {
namespace {

// Below this depth nodes are halved: centroids over many orders of magnitude cannot make the tree a list.
constexpr int greatest_split_depth = 64;

/// A run of items that is to be split, and the fork it becomes.
struct Task {
  std::size_t first;
  std::size_t count;
  Index fork;
  int depth;
};

class TopDown {
 public:
  TopDown(const ShapeItems& items, TreeMethod method) : items_(items), method_(method) {
    for (Index i = 0; i < items.boxes.size(); ++i) order_.push_back(i);
  }

  BinaryShape build(TreeDriver driver) {
    shape_.forks.reserve(2 * order_.size());
    shape_.root = place(order_.front());
    const Task all{0, order_.size(), shape_.root, 0};
    if (driver == TreeDriver::recursive)
      build_recursively(all);
    else
      build_iteratively(all);
    return std::move(shape_);
  }

 private:
  void build_recursively(const Task& task) {
    if (task.count == 1) return;
    const auto [left, right] = split(task);
    build_recursively(left);
    build_recursively(right);
  }

  void build_iteratively(const Task& all) {
    std::vector<Task> tasks{all};
    while (!tasks.empty()) {
      const Task task = tasks.back();
      tasks.pop_back();
      if (task.count == 1) continue;
      const auto [left, right] = split(task);
      tasks.push_back(right);
      tasks.push_back(left);
    }
  }

  struct Halves {
    Task left;
    Task right;
  };

  Index place(Index item) { return shape_.add_leaf(item); }

  /// The task's fork gets two children, leaves of the first items of their runs as long as they are not split.
  Halves split(const Task& task) {
    const auto run = std::span(order_).subspan(task.first, task.count);
    std::size_t border = 0;
    if (task.depth < greatest_split_depth)
      border = method_ == TreeMethod::mean ? split_at_mean(run) : split_at_median(run);
    if (border == 0 || border == run.size()) border = run.size() / 2;
    const Index left = place(run.front()), right = place(run[border]);
    shape_.forks[task.fork] = {left, right, no_index};
    return {{task.first, border, left, task.depth + 1},
            {task.first + border, task.count - border, right, task.depth + 1}};
  }

  /// How many come first; all or none when no axis parts them.
  std::size_t split_at_mean(std::span<Index> run) {
    below_.clear();
    for (const Index item : run) below_.push_back(items_.triangles[item]);
    const PrincipalAxes spread = principal_axes(below_);
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
  TreeMethod method_;
  std::vector<Index> order_;
  std::vector<Triangle> below_;
  BinaryShape shape_;
};

}  // namespace

BinaryShape shape_from_top(const ShapeItems& items, TreeMethod method, TreeDriver driver) {
  return TopDown(items, method).build(driver);
}

BinaryShape shape_by_heuristic(const ShapeItems& items) {
  const Tree<Aabb> tree = build_tree(items.boxes, {.leaf_size = 1});
  BinaryShape shape;
  for (const TreeNode<Aabb>& node : tree.nodes)
    shape.forks.push_back(node.is_leaf() ? Fork{no_index, no_index, tree.items[node.first]}
                                         : Fork{node.first, node.first + 1, no_index});
  shape.root = 0;
  return shape;
}

}  // namespace toccata
