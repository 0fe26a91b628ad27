#pragma once

#include "toccata/bounds/aabb.hpp"
#include "trees/float_box.hpp"

namespace toccata {

/// The coordinates of a wide tree: x = origin + unit · q.
struct WideFrame {
  Vec3 origin;
  double unit = 1;     ///< a power of two
  double inverse = 1;  ///< 1 / unit
};

/// The frame for what lies within a box that is not empty: coordinates q from −1 to 1.
[[nodiscard]] WideFrame frame_around(const Aabb& box);

/// The least box of floats that contains the box (nearly always: it may be one float wider where the box's corner less
/// the origin is no double).
[[nodiscard]] FloatBox to_frame(const WideFrame& frame, const Aabb& box);

[[nodiscard]] inline FloatItem item_in(const WideFrame& frame, const Aabb& box, std::uint32_t number) {
  FloatItem item{to_frame(frame, box)};
  item.set_number(number);
  return item;
}

}  // namespace toccata
