#include "toccata/narrow/convex_separating_axes.hpp"

#include "narrow/box_axes.hpp"

namespace toccata {

bool overlap_by_separating_axes(const PosedConvex& a, const PosedConvex& b, ConvexWorkspace* workspace) {
  if (is_box(a) && is_box(b) && a.radius() == 0 && b.radius() == 0) {
    const std::optional<bool> meet = BoxAxes(a, b).meet();
    if (meet && workspace != nullptr) ++workspace->counts.closed_forms;
    if (meet) return *meet;
  }
  return overlap(a, b, workspace);
}

}  // namespace toccata
