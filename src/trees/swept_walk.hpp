#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "toccata/core/function_ref.hpp"
#include "toccata/trees/walk.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

struct HeightRange {
  double low = 0;
  double high = 0;
};

/// A direction along which two things are compared of which the first moves, upwards.
struct SweptDirection {
  /// For a thing that is a tree: its point q, in its units, is at the height form · q + offset when the way begins.
  std::array<Vec3, 2> form{};
  std::array<double, 2> offset{};
  std::array<HeightRange, 2> whole;  ///< of each thing, when the way begins; it may be infinite
  /// More than all that is not exact makes of the difference of two heights, at any time of the way.
  double pad = 0;
  double per_speed = 0;  ///< 1 / what the first rises by on the whole way; positive and finite
};

/// The scratch memory of a walk: what is still to be looked at, as a heap. It keeps its size.
struct SweptFrontier {
  struct Entry {
    double time;                      ///< they do not meet before
    std::array<std::uint32_t, 2> at;  ///< of each tree the box: block · 8 + lane, or the whole
  };
  std::vector<Entry> waiting;
  WalkCounts counts;
};

/// Directions that tell boxes from an item better than its own box does, where they are small beside it. On the item's
/// side, `whole` is that of the item.
class SweptItems {
 public:
  [[nodiscard]] virtual std::span<const SweptDirection> directions_beside(std::size_t side, Index item) = 0;

 protected:
  ~SweptItems() = default;
};

/// A walk over two trees of which the first moves straight on, or over one and a thing that is a single item: what may
/// meet first comes first.
class SweptWalk {
 public:
  /// A tree is null where the thing is one item, of number 0; else it is not empty.
  SweptWalk(std::array<const WideBvh*, 2> trees, std::span<const SweptDirection> directions,
            SweptItems* items = nullptr)
      : trees_(trees), directions_(directions), items_(items) {}

  static constexpr std::size_t most_directions = 13;

  /// Calls `see(items)`, which returns the latest time of the way that is still of interest, for all pairs of items
  /// that may meet by the limit as it is at the end.
  void run(SweptFrontier& frontier, double limit, FunctionRef<double(ItemPair)> see) const;

 private:
  static constexpr std::uint32_t whole = 0xFFFFFFFF;
  using Heights = std::array<HeightRange, most_directions>;
  using Times = std::array<double, WideBlock::width>;

  [[nodiscard]] bool is_item(std::size_t side, std::uint32_t at) const;
  [[nodiscard]] Index item(std::size_t side, std::uint32_t at) const;
  [[nodiscard]] std::uint32_t block_below(std::size_t side, std::uint32_t at) const;
  [[nodiscard]] Heights heights(std::size_t side, std::uint32_t at) const;
  [[nodiscard]] double extent(const Heights& heights) const;
  [[nodiscard]] std::span<const SweptDirection> directions_beside(const SweptFrontier::Entry& entry, std::size_t side,
                                                                  const std::array<Heights, 2>& along) const;
  [[nodiscard]] Times times(std::size_t side, const WideBlock& block, const Heights& other,
                            std::span<const SweptDirection> beside) const;
  void expand(const SweptFrontier::Entry& entry, double limit, SweptFrontier& frontier) const;

  std::array<const WideBvh*, 2> trees_;
  std::span<const SweptDirection> directions_;
  SweptItems* items_;
};

}  // namespace toccata
