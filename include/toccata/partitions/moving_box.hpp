#pragma once

#include "toccata/partitions/grid_cells.hpp"

namespace toccata {

/// A box whose sides move evenly, from `begin` at the time `from` to `end` at `until`.
struct MovingBox {
  Aabb begin;
  Aabb end;
  double from = 0;
  double until = 1;
};

/// Throws Error when a number is not finite, a box has lower > upper, or from > until.
void require_motion(const MovingBox& motion);

/// In space and time: contains the box at all times from `from` to `until`, which lie within the motion's; larger than
/// the least such box by rounding alone.
[[nodiscard]] GridBox<4> swept(const MovingBox& motion, double from, double until);

}  // namespace toccata
