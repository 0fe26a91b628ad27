#pragma once

#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// A tree over the boxes of a model's parts, made anew for a question as far as it is asked for: halves of them by
/// their middles along the longest axis, down to a few. It keeps its memory.
class PartTree {
 public:
  struct Node {
    Aabb box;
    Index first = 0;  ///< of its parts, in the tree's order
    Index last = 0;   ///< beyond them
    Index child = 0;  ///< the first of two, which lie side by side; 0: not made so far

    [[nodiscard]] Index count() const { return last - first; }
    [[nodiscard]] bool is_leaf() const { return count() <= most_in_leaf; }
  };

  /// Boxes may be empty, or without an end. They have to stay as they are.
  void start(const std::vector<Aabb>& boxes);

  /// The root is node 0; there is none for no boxes.
  [[nodiscard]] const Node& node(Index number) const { return nodes_[number]; }
  [[nodiscard]] bool is_empty() const { return nodes_.empty(); }
  /// The number of the part at a place of the tree's order.
  [[nodiscard]] Index part(Index place) const { return order_[place]; }

  /// The first of the two children of what is no leaf.
  Index children(Index number, const std::vector<Aabb>& boxes);

 private:
  static constexpr Index most_in_leaf = 8;

  void halve(const Node& node);
  void add(Index first, Index last, const std::vector<Aabb>& boxes);

  std::vector<Node> nodes_;
  std::vector<Index> order_;
  std::vector<Vec3> middles_;  ///< of the boxes; of none until they are needed
};

}  // namespace toccata
