#include "toccata/methods/msp_tree.hpp"

#include "methods/bsp/bsp_point.hpp"
#include "methods/msp/msp_parts.hpp"

namespace toccata {
namespace {

/// The region within a plane that the point lies in.
MspChild region_of(const BspPointWalk& walk, const MspTree::Parts& parts, MspChild at) {
  while (!is_region(at)) {
    const MspNode& node = parts.nodes[static_cast<std::size_t>(at)];
    at = node.beside(walk.side_of(node.plane));
  }
  return at;
}

}  // namespace

MspTree::MspTree(const Model& solid, const BspOptions& options) {
  require_possible(options);
  require_solid_for_bsp(solid);
  auto parts = std::make_shared<Parts>(solid);
  build_msp(*parts, options);
  parts_ = std::move(parts);
}

// A region off the surface that lies in a plane is on the border of cells on both its sides, and they are of one kind:
// so the point goes on into one of them.
MspLocation MspTree::locate(const Vec3& point) const {
  require_finite_point(point);
  const BspTree::Parts& space = parts_->space;
  if (!space.frame.contains(point)) return {};
  const BspPointWalk walk(space, point);
  for (BspChild at = walk.descend(0);; at = walk.descend(space.nodes[static_cast<std::size_t>(at)].front())) {
    if (is_leaf(at)) return {located_by(winding_of_leaf(at)), 0, {}};
    const MspChild region = region_of(walk, *parts_, parts_->within[static_cast<std::size_t>(at)]);
    if (region == off_surface) continue;
    const TriangleFeature on = on_of_region(region);
    return {{Side::boundary, 0}, on.triangle, on.feature};
  }
}

const MspStatistics& MspTree::statistics() const { return parts_->statistics; }

}  // namespace toccata
