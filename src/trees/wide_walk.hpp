#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/trees/walk.hpp"
#include "toccata/trees/wide_bvh.hpp"
#include "trees/wide_probe.hpp"

namespace toccata {

/// How blocks of one tree ("its own") are compared with boxes of another: constants of a query. For a point q of the
/// own tree and a point p of the other, each in its tree's units, every axis has a number that is the same for both
/// where the two are one point of the world: own · q and offset + other · p. The pads cover all that was rounded on the
/// way to the constants; what floats round during the walk is the walk's business (docs/design/fast-core.md).
///
/// Axes 0, 1 and 2 follow the own coordinates (own · q is q_i, and `slanted` is not looked at); the rest are slanted.
/// Axis by axis in one column, so that all are computed at once. A pad of +∞ turns an axis off.
struct WideAxes {
  static constexpr std::size_t straight = 3;
  static constexpr std::size_t most = 16;

  alignas(64) std::array<std::array<double, most>, 3> other{};
  alignas(64) std::array<double, most> offset{};
  alignas(64) std::array<std::array<float, most>, 3> other_size{};  ///< |other|, rounded up
  alignas(64) std::array<float, most> pad{};
  alignas(64) std::array<float, most> own_size{};  ///< twice the sum of |own|; 2 for the first three
  std::array<SlantedForm, most> slanted{};
  std::size_t count = straight;

  /// What a length of 1 of the other tree is in the own one, roughly: the larger of two boxes is split.
  float other_is_larger_by = 1;
};

/// The constants for both directions: blocks of a against boxes of b, and blocks of b against boxes of a.
struct WideCull {
  WideAxes of_a;
  WideAxes of_b;
};

/// What a walk finds: pairs (item of the first tree, item of the second), in batches. Where a tree is walked with
/// itself, these are two different items, the lesser first.
class WideVisitor {
 public:
  /// Says whether it wants more.
  virtual bool visit(std::span<const ItemPair> pairs) = 0;

  /// Whether an item can be told from boxes of the other tree by more than its own box. Then what is smaller than the
  /// box of a single item is compared with the item's region.
  [[nodiscard]] virtual bool has_regions() const { return false; }
  /// That region, for boxes of the other tree: it holds the item of tree `side`.
  [[nodiscard]] virtual WideProbe region_of(std::size_t /*side*/, Index /*item*/) { return {}; }

 protected:
  ~WideVisitor() = default;
};

/// The scratch memory of a walk: pairs (a block, a box of the other tree) that are still to be compared, and pairs of
/// items that were found. It grows as needed and keeps its size, so that a second walk allocates nothing.
struct WideFrontier {
  std::vector<std::uint32_t> blocks;  ///< block · 2 + which tree it is of
  std::vector<std::uint32_t> boxes;   ///< block · 8 + lane, of the other tree
  std::size_t size = 0;
  std::vector<std::uint32_t> below;  ///< block · 2 + which tree it is of: its boxes are smaller than the item
  std::vector<Index> beside;         ///< at this place of the other tree
  std::size_t below_count = 0;
  std::array<std::vector<Index>, 2> places;  ///< of found items, in the item orders of the trees
  std::size_t pair_count = 0;
  std::vector<ItemPair> pairs;
  std::size_t batch = 0;  ///< so many pairs are handed on at once
  bool ended = false;
  bool within_one = false;   ///< of one tree with itself: the lesser item first
  bool has_regions = false;  ///< of the visitor
  WalkCounts counts;

  /// Gets at least the other's memory.
  void grow_like(const WideFrontier& other);
};

/// The blocks first, first + 1, … before `last` of a tree.
struct BlockRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

/// A walk over pairs of boxes of two trees, or of one with itself (I. Wald et al.; block-wise, so that the processor
/// works on many pairs at once). Same pairs, same order and same counts for every SIMD level.
class WideWalk {
 public:
  /// The trees and constants must outlive the walk.
  WideWalk(const WideBvh& a, const WideBvh& b, const WideCull& cull) : trees_{&a, &b}, axes_{&cull.of_a, &cull.of_b} {}

  static constexpr std::size_t largest_batch = 256;

  /// Sets the frontier to all pairs of items. Batches begin small where one pair may be enough.
  void start(WideFrontier& frontier, std::size_t first_batch) const;

  /// Walks on until the frontier has at least so many entries, breadth first; or to the end.
  void spread(WideFrontier& frontier, std::size_t entries, WideVisitor& visitor) const;

  /// Walks to the end.
  void run(WideFrontier& frontier, WideVisitor& visitor) const;

  /// Both trees being one: visits each unordered pair of different items whose boxes meet once.
  void run_self(WideFrontier& frontier, std::size_t first_batch, WideVisitor& visitor) const;

  /// The part of it that begins in these blocks, where two items first have different lanes: ranges that together are
  /// all blocks visit each pair once.
  void run_self(WideFrontier& frontier, std::size_t first_batch, BlockRange blocks, WideVisitor& visitor) const;

  [[nodiscard]] const WideBvh& tree(std::size_t side) const { return *trees_[side]; }
  [[nodiscard]] const WideAxes& axes(std::size_t side) const { return *axes_[side]; }

 private:
  std::array<const WideBvh*, 2> trees_;
  std::array<const WideAxes*, 2> axes_;
};

}  // namespace toccata
