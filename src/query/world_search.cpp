#include "query/world_search.hpp"

#include <limits>

#include "query/cull_bounds.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {
namespace {

/// Compares boxes of the local frame with a world region along the three world axes: the rows of R are the forms, so
/// nothing but the evaluation and the world vertices themselves is rounded (docs/design/culling.md).
class RegionSearch {
 public:
  RegionSearch(const PosedMesh& mesh, const Aabb& region, const std::function<bool(Index)>& visit)
      : mesh_(mesh), region_(region), visit_(visit) {
    const Vec3 sizes = world_sizes(mesh);
    for (int axis = 0; axis < 3; ++axis) pads_[axis] = 16 * unit_roundoff * sizes[axis] + 8 * smallest_double;
  }

  double bound(const Aabb& node) const {
    for (int axis = 0; axis < 3; ++axis) {
      const Range range = range_of(mesh_.pose().linear[axis], node);
      const double offset = mesh_.pose().offset[axis];
      if (is_certain((range.low + offset) - region_.upper[axis], pads_[axis]) ||
          is_certain(region_.lower[axis] - (range.high + offset), pads_[axis]))
        return std::numeric_limits<double>::infinity();
    }
    return 0;
  }
  double limit() const { return ended_ ? -1 : 0; }
  void visit(std::span<const Index> triangles) {
    for (const Index triangle : triangles) {
      if (!overlap(box_of(mesh_.triangle(triangle)), region_)) continue;
      ended_ = !visit_(triangle);
      if (ended_) return;
    }
  }

 private:
  const PosedMesh& mesh_;
  const Aabb& region_;
  const std::function<bool(Index)>& visit_;
  Vec3 pads_;
  bool ended_ = false;
};

}  // namespace

void visit_triangles_near(const PosedMesh& mesh, const Aabb& region, const std::function<bool(Index)>& visit) {
  RegionSearch question(mesh, region, visit);
  if (overlap(mesh.box(), region)) walk(mesh.model().tree(), question);
}

}  // namespace toccata
