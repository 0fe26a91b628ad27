#include "reports/view/recorded_boxes.hpp"

#include <algorithm>
#include <cmath>

namespace toccata::io {
void widen(Aabb& around, const Aabb& box) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double end : {box.lower[axis], box.upper[axis]}) {
      if (is_empty(box) || !std::isfinite(end)) continue;
      around.lower[axis] = std::min(around.lower[axis], end);
      around.upper[axis] = std::max(around.upper[axis], end);
    }
}

Aabb bounds_of(const CrowdRecording& recording) {
  Aabb around;
  for (const CrowdRecording::Frame& frame : recording.frames())
    for (const Aabb& box : frame.boxes) widen(around, box);
  for (int axis = 0; axis < 3; ++axis)
    if (!(around.lower[axis] <= around.upper[axis])) around.lower[axis] = around.upper[axis] = 0;
  return around;
}

}  // namespace toccata::io
