#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"

namespace toccata {

/// The tree behind `RTree`: boxes by number, each in one leaf; nothing is checked here.
class RTreeNodes {
 public:
  static constexpr Index none = std::numeric_limits<Index>::max();
  static constexpr std::size_t most = 16;  ///< entries of a node
  static constexpr std::size_t least = 6;  ///< of all but the root

  /// A node. In a leaf (level 0) the children are numbers of boxes.
  struct Node {
    Index parent = none;
    std::uint32_t level = 0;
    std::uint32_t count = 0;
    std::array<Aabb, most> box;
    std::array<Index, most> child{};
  };

  /// All at once, in tiles; box i has the number i, empty ones are left out.
  void build(std::span<const Aabb> boxes);
  /// The number is not in the tree; the box is not empty.
  void insert(Index number, const Aabb& box);
  /// The number is in the tree.
  void remove(Index number);
  /// In its leaf, where its new box does not stick out of that: true; else it is put in anew.
  bool move(Index number, const Aabb& box);

  [[nodiscard]] bool contains(Index number) const { return number < leaf_of_.size() && leaf_of_[number] != none; }
  [[nodiscard]] const Aabb& box(Index number) const;
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Every number is less.
  [[nodiscard]] std::size_t numbers() const { return leaf_of_.size(); }
  [[nodiscard]] std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + (free_.capacity() + leaf_of_.capacity()) * sizeof(Index);
  }
  /// What should hold and does not; empty when all is well.
  [[nodiscard]] std::string complaint() const;

  /// Calls `found` with the number of each box that overlaps, and the box, in no order.
  template <class Found>
  void each_overlap(const Aabb& box, std::vector<Index>& waiting, const Found& found) const {
    waiting.assign(root_ == none ? 0 : 1, root_);
    while (!waiting.empty()) {
      const Node& node = nodes_[waiting.back()];
      waiting.pop_back();
      for (std::size_t i = 0; i < node.count; ++i) {
        if (!overlap(node.box[i], box)) continue;
        if (node.level > 0)
          waiting.push_back(node.child[i]);
        else
          found(node.child[i], node.box[i]);
      }
    }
  }

  /// Calls `found` once with the numbers of every two boxes that overlap, in no order: each node with itself, and
  /// with those that it overlaps.
  template <class Found>
  void each_pair(const Found& found) const {
    std::vector<std::array<Index, 2>> waiting;
    if (root_ != none) waiting.push_back({root_, root_});
    while (!waiting.empty()) {
      const auto [one, other] = waiting.back();
      waiting.pop_back();
      const Node &a = nodes_[one], &b = nodes_[other];
      for (std::size_t i = 0; i < a.count; ++i) {
        if (a.level > 0 && one == other) waiting.push_back({a.child[i], a.child[i]});
        for (std::size_t k = one == other ? i + 1 : 0; k < b.count; ++k) {
          if (!overlap(a.box[i], b.box[k])) continue;
          if (a.level > 0)
            waiting.push_back({a.child[i], b.child[k]});
          else
            found(a.child[i], b.child[k]);
        }
      }
    }
  }

  /// Calls `found` with each node, the root first.
  template <class Found>
  void each_node(const Found& found) const {
    std::vector<Index> waiting;
    if (root_ != none) waiting.push_back(root_);
    while (!waiting.empty()) {
      const Node& node = nodes_[waiting.back()];
      waiting.pop_back();
      found(node);
      if (node.level > 0) waiting.insert(waiting.end(), node.child.begin(), node.child.begin() + node.count);
    }
  }
  [[nodiscard]] static Aabb box_of(const Node& node);

 private:
  struct Entry {
    Aabb box;
    Index child;
  };

  [[nodiscard]] std::size_t entry_in(Index node, Index child) const;
  [[nodiscard]] std::string complaint_about(Index node) const;

  Index new_node(std::uint32_t level);
  void append(Index node, const Entry& entry);
  void erase_entry(Index node, std::size_t entry);
  void claim(Index node, Index child);

  void build_level(std::vector<Entry> entries, std::uint32_t level);
  void insert_at(const Entry& entry, std::uint32_t level);
  [[nodiscard]] Index choose(const Aabb& box, std::uint32_t level) const;
  void split(Index node, const Entry& entry);
  void grow_root(Index left, Index right);
  void refit_from(Index node);
  void condense_from(Index node);

  std::vector<Node> nodes_;
  std::vector<Index> free_;
  std::vector<Index> leaf_of_;  ///< by number
  Index root_ = none;
  std::size_t size_ = 0;
};

}  // namespace toccata
