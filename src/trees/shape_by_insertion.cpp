#include "trees/binary_shape.hpp"

namespace toccata {
namespace {

class Inserter {
 public:
  explicit Inserter(const ShapeItems& items) : items_(items) {}

  BinaryShape build() {
    for (Index item = 0; item < items_.boxes.size(); ++item) insert(item);
    return std::move(shape_);
  }

 private:
  [[nodiscard]] double growth(Index fork, const Aabb& box) const {
    return half_area(merge(boxes_[fork], box)) - half_area(boxes_[fork]);
  }

  /// What a new fork in the place of this one costs, with it and the item as children.
  [[nodiscard]] double joining(Index fork, const Aabb& box) const { return half_area(merge(boxes_[fork], box)); }

  Index add_leaf(Index item) {
    boxes_.push_back(items_.boxes[item]);
    return shape_.add_leaf(item);
  }

  void insert(Index item) {
    const Aabb& box = items_.boxes[item];
    if (shape_.root == no_index) {
      shape_.root = add_leaf(item);
      return;
    }
    // Down to where it is cheaper to stay than to go on, growing the boxes on the way.
    Index here = shape_.root, parent = no_index;
    while (!shape_.forks[here].is_leaf()) {
      const Fork& fork = shape_.forks[here];
      const double left = growth(fork.left, box), right = growth(fork.right, box);
      const double below = growth(here, box) + std::min(left, right);
      if (joining(here, box) < below) break;
      boxes_[here] = merge(boxes_[here], box);
      parent = here;
      // Between equal ones it goes to the smaller, so that boxes that coincide do not make a list.
      here = left < right || (left == right && counts_[fork.left] <= counts_[fork.right]) ? fork.left : fork.right;
      ++counts_[parent];
    }
    join(here, parent, item);
  }

  void join(Index here, Index parent, Index item) {
    counts_.resize(boxes_.size(), 1);
    const Index leaf = add_leaf(item);
    const Index fork = shape_.add_fork(here, leaf);
    boxes_.push_back(merge(boxes_[here], boxes_[leaf]));
    counts_.resize(boxes_.size(), 1);
    counts_[fork] = counts_[here] + 1;
    if (parent == no_index)
      shape_.root = fork;
    else if (shape_.forks[parent].left == here)
      shape_.forks[parent].left = fork;
    else
      shape_.forks[parent].right = fork;
  }

  const ShapeItems& items_;
  BinaryShape shape_;
  std::vector<Aabb> boxes_;    // of the forks
  std::vector<Index> counts_;  // of the items below them
};

}  // namespace

BinaryShape shape_by_insertion(const ShapeItems& items) { return Inserter(items).build(); }

}  // namespace toccata
