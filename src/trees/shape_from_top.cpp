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

int longest_axis_of(const Vec3& size) {
  return size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
}

/// A box that is cut into so many parts of one volume; 1 is no longer cut.
struct EqualParts {
  Aabb box{};
  int parts = 1;
};

/// Cut across the longest axis, in halves or as near to them as whole parts are; the place and the two sides.
struct EvenCut {
  explicit EvenCut(const EqualParts& whole) : lower(whole), upper(whole) {
    const Vec3 size = whole.box.upper - whole.box.lower;
    axis = longest_axis_of(size);
    lower.parts = whole.parts / 2;
    upper.parts = whole.parts - lower.parts;
    place = whole.box.lower[axis] + size[axis] * lower.parts / whole.parts;
    lower.box.upper[axis] = upper.box.lower[axis] = place;
  }
  int axis = 0;
  double place = 0;
  EqualParts lower, upper;
};

/// A run of items that is to be split, and the fork it becomes. The forks below it have the numbers after it.
struct SplitRun {
  std::size_t first;
  std::size_t count;
  Index fork;
  int depth;
  EqualParts space{};
};

class TopDown {
 public:
  TopDown(const ShapeItems& items, BvhMethod method, int arity) : items_(items), method_(method), arity_(arity) {
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
    SplitPlace at;
    if (task.depth < greatest_split_depth) at = place_in(run, task.space);
    if (at.border == 0 || at.border == run.size()) at = {run.size() / 2};
    const Index left = task.fork + 1, right = task.fork + static_cast<Index>(2 * at.border);
    shape_.forks[task.fork] = {left, right, no_index, at.goes_on};
    return {{task.first, at.border, left, task.depth + 1, at.left},
            {task.first + at.border, task.count - at.border, right, task.depth + 1, at.right}};
  }

  /// How many come first, all or none where nothing parts them; and the space of both sides.
  struct SplitPlace {
    std::size_t border = 0;
    EqualParts left{};
    EqualParts right{};
    bool goes_on = false;  ///< cuts what the fork above was a part of
  };

  SplitPlace place_in(std::span<Index> run, const EqualParts& space) const {
    if (method_ == BvhMethod::mean) return {split_at_mean(run)};
    if (method_ == BvhMethod::median) return {split_at_median(run)};
    const SplitPlace further = split_evenly(run, space);
    if (further.border == 0) return split_evenly(run, {box_of_centroids(run), arity_});
    return {further.border, further.left, further.right, true};
  }

  /// Parts without a centroid are nobody's; where all are in one part, the border is 0.
  SplitPlace split_evenly(std::span<Index> run, EqualParts space) const {
    while (space.parts > 1) {
      const EvenCut cut(space);
      const auto before = [&](Index item) { return items_.centroids[item][cut.axis] < cut.place; };
      const auto border = static_cast<std::size_t>(std::partition(run.begin(), run.end(), before) - run.begin());
      if (border > 0 && border < run.size()) return {border, cut.lower, cut.upper};
      space = border == 0 ? cut.upper : cut.lower;
    }
    return {};
  }

  [[nodiscard]] Aabb box_of_centroids(std::span<const Index> run) const {
    Aabb box;
    for (const Index item : run) box = merge(box, items_.centroids[item]);
    return box;
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
    const Aabb centroids = box_of_centroids(run);
    const int axis = longest_axis_of(centroids.upper - centroids.lower);
    const auto middle = run.begin() + static_cast<std::ptrdiff_t>(run.size() / 2);
    std::nth_element(run.begin(), middle, run.end(), [&](Index i, Index j) {
      const double x = items_.centroids[i][axis], y = items_.centroids[j][axis];
      return x != y ? x < y : i < j;
    });
    return run.size() / 2;
  }

  const ShapeItems& items_;
  BvhMethod method_;
  int arity_;
  std::vector<Index> order_;
  BinaryShape shape_;
};

}  // namespace

BinaryShape shape_from_top(const ShapeItems& items, const BvhOptions& options, int arity) {
  return TopDown(items, options.method, arity).build(options.driver, options.threads);
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
