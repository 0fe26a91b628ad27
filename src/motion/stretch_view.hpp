#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "motion/moving_part.hpp"
#include "toccata/trees/wide_bvh.hpp"
#include "trees/swept_walk.hpp"

namespace toccata {

/// One of two things whose boxes are compared: a mesh with its tree, or a convex shape, which is one item.
struct SweptThing {
  SweptThing(const MovingPart& moving, const TimeStretch& stretch);

  /// A box of the tree, block · 8 + lane, or all of it.
  static constexpr std::uint32_t whole = 0xFFFFFFFF;

  [[nodiscard]] bool is_empty() const { return tree != nullptr && tree->blocks.empty(); }
  [[nodiscard]] bool is_item(std::uint32_t at) const;
  [[nodiscard]] Index item(std::uint32_t at) const;
  [[nodiscard]] std::uint32_t block_below(std::uint32_t at) const;

  /// Half of a box's diagonal in the world, or how far all of it is from the axis at most, and how far the points of
  /// its core are.
  struct Extent {
    double radius;
    double reach;
  };
  [[nodiscard]] Extent extent(std::uint32_t at) const;

  const MovingPart* part;
  const WideBvh* tree;  ///< null of a convex shape
  PartMotion motion;

 private:
  Mat3 linear_;  ///< of a point in the tree's units, to the world when the move began
  Vec3 origin_;
};

/// How high things lie along a direction at the two ends of a stretch.
struct HeightsAtEnds {
  std::array<HeightRange, 2> at;
};

/// The same of all boxes of a block, at the beginning and at the end of the stretch.
struct BlockHeights {
  using Lanes = std::array<double, WideBlock::width>;
  std::array<Lanes, 2> low;
  std::array<Lanes, 2> high;
};

/// Two things in a stretch of time, seen along directions.
class StretchView {
 public:
  StretchView(const SweptThing& a, const SweptThing& b, const TimeStretch& stretch);

  static constexpr std::size_t most_directions = 13;
  using Heights = std::array<HeightsAtEnds, most_directions>;

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const TimeStretch& stretch() const { return stretch_; }

  /// More than all that is rounded can change a difference of heights by.
  [[nodiscard]] double pad(std::size_t direction) const { return directions_[direction].pad; }

  /// The heights of a box of a thing, the first or the second.
  [[nodiscard]] HeightsAtEnds heights(std::size_t direction, std::size_t side, std::uint32_t at) const;
  [[nodiscard]] Heights heights(std::size_t side, std::uint32_t at) const;
  [[nodiscard]] BlockHeights block_heights(std::size_t direction, std::size_t side, std::uint32_t block) const;

  /// A triangle of a thing that is a mesh, in the world at one of the ends.
  [[nodiscard]] Triangle triangle(std::size_t side, std::size_t end, Index number) const;

 private:
  /// How high things are along a direction. For a tree, a point q in its units is at the height form · q + offset.
  struct Along {
    std::array<Vec3, 2> form{};
    std::array<double, 2> offset{};
    HeightsAtEnds whole;
    double size = 0;  ///< what is rounded is off by units in the last place of
  };
  struct Direction {
    std::array<Along, 2> side;
    double pad = 0;
  };
  struct Posed;

  void add(const Posed& posed, const std::array<Vec3, 2>& direction_at_ends);
  static Along along(const SweptThing& thing, const std::array<Pose, 2>& poses,
                     const std::array<const PosedShape*, 2>& shapes, const std::array<Vec3, 2>& direction_at_ends);

  const SweptThing& a_;
  const SweptThing& b_;
  TimeStretch stretch_;
  std::array<std::array<Pose, 2>, 2> poses_;  ///< of either thing at the ends
  std::array<Direction, most_directions> directions_;
  std::size_t count_ = 0;
};

}  // namespace toccata
