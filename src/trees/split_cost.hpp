#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "trees/float_box.hpp"

namespace toccata {

inline std::uint32_t blocks_for(std::uint32_t items) { return (items + 7) / 8; }

/// What looking into a part costs, for each time that its box is met. Rather than the number of its items (or of its
/// blocks, which is what makes full blocks cheap) it is the square root: the boxes of surfaces get smaller as there are
/// more of them. Measured over the powers from 0.35 to 1 on scanned and designed meshes.
inline float weight(std::uint32_t items) { return std::sqrt(static_cast<float>(8 * blocks_for(items) + items)); }

/// Whether the boxes of two sides are so large that splitting hardly pays. The heuristic then means nothing, and would
/// take items off one by one.
inline bool hardly_pays(float cost_of_left_box, float cost_of_right_box, const FloatBox& whole) {
  return cost_of_left_box + cost_of_right_box > 1.8F * visit_cost(whole);
}

/// As many whole blocks of items left as right, or as many items when there is one block only.
inline std::uint32_t half_of(std::uint32_t count) {
  const std::uint32_t blocks = blocks_for(count);
  return blocks > 1 ? blocks / 2 * 8 : count / 2;
}

inline int longest_axis(const FloatBox& middles) {
  const Float4 size = middles.upper - middles.lower;
  return size[0] >= size[1] ? (size[0] >= size[2] ? 0 : 2) : (size[1] >= size[2] ? 1 : 2);
}

/// Tells the slab of an item or a cell, along an axis.
struct Slabs {
  int axis;
  float origin;
  float scale;

  // A little less than the number of slabs: the greatest centre then is in the last of them.
  Slabs(const FloatBox& middles, int along, std::size_t count)
      : axis(along),
        origin(middles.lower[axis]),
        scale(0.99999F * static_cast<float>(count) / (middles.upper[axis] - origin)) {}

  /// Not where all centres coincide, or nearly so.
  [[nodiscard]] bool usable() const { return std::isfinite(scale); }

  [[nodiscard]] std::uint32_t of(const FloatBox& box) const {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>((box.middle(axis) - origin) * scale));
  }
};

}  // namespace toccata
