#pragma once

#include <cstdint>
#include <vector>

#include "core/no_index.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/trees/builders.hpp"

namespace toccata {

/// A node with two children, or the leaf of one item.
struct Fork {
  Index left = no_index;
  Index right = no_index;
  Index item = no_index;
  /// Set by `equal_regions`: with its parent it makes one node, whose region both cut.
  bool goes_on = false;

  [[nodiscard]] bool is_leaf() const { return item != no_index; }
};

/// A hierarchy with every item in a leaf of its own: what all methods make, before it gets its arity and leaf size.
struct BinaryShape {
  std::vector<Fork> forks;
  Index root = no_index;

  [[nodiscard]] Index add_leaf(Index item) {
    forks.push_back({no_index, no_index, item, false});
    return static_cast<Index>(forks.size() - 1);
  }
  [[nodiscard]] Index add_fork(Index left, Index right) {
    forks.push_back({left, right, no_index, false});
    return static_cast<Index>(forks.size() - 1);
  }
};

/// What the methods look at; at least one.
struct ShapeItems {
  std::vector<Triangle> triangles;
  std::vector<Aabb> boxes;
  std::vector<Vec3> centroids;
};

/// On up to `threads` threads; none of the shapes depends on how many. The arity is used by `equal_regions` alone: it
/// says into how many each is cut.
[[nodiscard]] BinaryShape shape_from_top(const ShapeItems& items, const BvhOptions& options, int arity);
[[nodiscard]] BinaryShape shape_by_heuristic(const ShapeItems& items);
[[nodiscard]] BinaryShape shape_by_agglomeration(const ShapeItems& items, int threads);
[[nodiscard]] BinaryShape shape_by_insertion(const ShapeItems& items);
[[nodiscard]] BinaryShape shape_by_codes(const ShapeItems& items, int threads);

/// An item and its place on the space-filling curve (G. M. Morton, "A computer oriented geodetic data base", 1966), of
/// 21 bits along every axis of the centroids' box.
struct CodedItem {
  std::uint64_t code = 0;
  Index item = 0;
  friend constexpr auto operator<=>(const CodedItem&, const CodedItem&) = default;
};
/// Ascending.
[[nodiscard]] std::vector<CodedItem> along_curve(const ShapeItems& items, int threads);

}  // namespace toccata
