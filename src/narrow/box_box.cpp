#include "toccata/narrow/box_box.hpp"

#include "narrow/rigid_box_axes.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

bool overlap(const PosedBox& a, const PosedBox& b) {
  const Nearness nearness = nearness_of_rigid_boxes(view_of(a), view_of(b));
  if (nearness != Nearness::unknown) return nearness == Nearness::meet;
  return overlap(PosedConvex(a.shape, a.pose), PosedConvex(b.shape, b.pose));
}

}  // namespace toccata
