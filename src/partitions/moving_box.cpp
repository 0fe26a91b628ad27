#include "toccata/partitions/grid_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// Contains the true value; no farther off than some last places of the larger end.
struct Bracket {
  double lower, upper;
};

Bracket between(double begin, double end, double part) {
  const double low = std::min(begin, end), high = std::max(begin, end);
  const double value = begin * (1 - part) + end * part;
  const double error =
      0x1p-48 * std::max(std::abs(low), std::abs(high)) + 4 * std::numeric_limits<double>::denorm_min();
  return {std::clamp(value - error, low, high), std::clamp(value + error, low, high)};
}

/// Which part of the motion has passed, with a relative error of few last places; 0 to 1.
double part_at(const MovingBox& motion, double time) {
  const double duration = 0.5 * motion.until - 0.5 * motion.from;
  return std::clamp((0.5 * time - 0.5 * motion.from) / duration, 0.0, 1.0);
}

void require_box(const Aabb& box, const char* when) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(box.lower[axis]) || !std::isfinite(box.upper[axis]))
      throw Error(fmt::format("the box's {} at its {} is not finite", "xyz"[axis], when));
    if (box.lower[axis] > box.upper[axis])
      throw Error(fmt::format("at its {} the box's lower {} is above its upper one", when, "xyz"[axis]));
  }
}

}  // namespace

void require_motion(const MovingBox& motion) {
  require_box(motion.begin, "begin");
  require_box(motion.end, "end");
  if (!std::isfinite(motion.from) || !std::isfinite(motion.until) || motion.from > motion.until)
    throw Error(
        fmt::format("a motion from {} until {}: the times must be finite and ascending", motion.from, motion.until));
}

GridBox<4> swept(const MovingBox& motion, double from, double until) {
  GridBox<4> box;
  box.lower[3] = from;
  box.upper[3] = until;
  // So short that halves of its times may lose bits.
  const bool at_once = motion.until - motion.from < 0x1p-900;
  const double first = at_once ? 0 : part_at(motion, from), last = at_once ? 1 : part_at(motion, until);
  for (int axis = 0; axis < 3; ++axis) {
    const auto side = [&](double part, const Vec3 Aabb::*corner) {
      return between((motion.begin.*corner)[axis], (motion.end.*corner)[axis], part);
    };
    const auto i = static_cast<std::size_t>(axis);
    box.lower[i] = std::min(side(first, &Aabb::lower).lower, side(last, &Aabb::lower).lower);
    box.upper[i] = std::max(side(first, &Aabb::upper).upper, side(last, &Aabb::upper).upper);
  }
  return box;
}

}  // namespace toccata
