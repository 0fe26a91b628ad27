#include "broad/float_boxes.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"

namespace toccata {
namespace {

constexpr std::size_t vector_slack = 16;  ///< the floats of the widest vector

/// Where nothing is finite there is nothing to take from the middle.
void widen(double& lower, double& upper, double from, double to) {
  if (std::fabs(from) <= greatest_double) {
    lower = std::min(lower, from);
    upper = std::max(upper, from);
  }
  if (std::fabs(to) <= greatest_double) {
    lower = std::min(lower, to);
    upper = std::max(upper, to);
  }
}

}  // namespace

FloatFrame::FloatFrame(const Aabb& around) {
  const auto middle = [](double lower, double upper) { return lower <= upper ? 0.5 * lower + 0.5 * upper : 0; };
  const auto reach = [](double lower, double upper) { return lower <= upper ? 0.5 * upper - 0.5 * lower : 0; };
  middle_ = {middle(around.lower.x, around.upper.x), middle(around.lower.y, around.upper.y),
             middle(around.lower.z, around.upper.z)};
  const double largest = std::max({reach(around.lower.x, around.upper.x), reach(around.lower.y, around.upper.y),
                                   reach(around.lower.z, around.upper.z), 0x1p-1000});
  scale_ = std::ldexp(1.0, -std::ilogb(largest));
}

Aabb finite_bounds(std::span<const Aabb> boxes) {
  Aabb bounds;
  for (const Aabb& box : boxes) {
    if (is_empty(box)) continue;
    const Vec3 &lower = box.lower, &upper = box.upper;
    // Nothing times what is not finite is no number.
    if (0 * lower.x + 0 * lower.y + 0 * lower.z + 0 * upper.x + 0 * upper.y + 0 * upper.z == 0) {
      bounds = merge(bounds, box);
      continue;
    }
    widen(bounds.lower.x, bounds.upper.x, box.lower.x, box.upper.x);
    widen(bounds.lower.y, bounds.upper.y, box.lower.y, box.upper.y);
    widen(bounds.lower.z, bounds.upper.z, box.lower.z, box.upper.z);
  }
  return bounds;
}

void ColumnStore::resize(std::size_t count) {
  if (count + vector_slack <= stride_) return;
  stride_ = std::max(count, stride_ + stride_ / 4) + vector_slack;
  floats_ = std::make_unique<float[]>(6 * stride_);
  numbers_ = std::make_unique<Index[]>(stride_);
}

}  // namespace toccata
