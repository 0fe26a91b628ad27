#include "query/world_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "query/cull_bounds.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A world direction along which the mesh and the region are compared: for a local point x, its world point along the
/// direction is on_mesh · x + offset, up to `pad`.
struct RegionDirection {
  Vec3 on_mesh;
  double offset = 0;
  Range region{};
  double pad = 0;
};

bool is_usable(const RegionDirection& d) {
  return is_finite(d.on_mesh) && std::isfinite(d.offset) && std::isfinite(d.region.low) &&
         std::isfinite(d.region.high) && std::isfinite(d.pad);
}

/// The rows of R are the forms, so nothing but the evaluation and the world vertices themselves is rounded.
RegionDirection along_axis(const PosedMesh& mesh, const Aabb& region, int axis) {
  return {mesh.pose().linear[axis],
          mesh.pose().offset[axis],
          {region.lower[axis], region.upper[axis]},
          16 * unit_roundoff * world_sizes(mesh)[axis] + 8 * smallest_double};
}

/// The direction at right angles to a ray along `axis` and to an edge of the mesh's posed boxes: turned boxes that lie
/// beside the ray are told by it, while their world boxes meet the ray. As for two meshes, the ray being the second.
RegionDirection beside_ray(const PosedMesh& mesh, const Aabb& ray, int axis, const Vec3& edge) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double size = std::max(std::abs(edge[i]), std::abs(edge[j]));
  Vec3 direction;
  direction[i] = -edge[j] / size;
  direction[j] = edge[i] / size;

  const Mat3& linear = mesh.pose().linear;
  const Vec3 sizes = world_sizes(mesh), largest = largest_coordinates(mesh);
  RegionDirection result;
  result.on_mesh = {dot(direction, linear.column(0)), dot(direction, linear.column(1)),
                    dot(direction, linear.column(2))};
  result.offset = dot(direction, mesh.pose().offset);
  double rounded = 0, underflowed = 1 + ((largest.x + largest.y) + largest.z);
  for (const int k : {i, j}) {
    const double p = direction[k] * ray.lower[k], q = direction[k] * ray.upper[k];
    const double reach = std::max(std::abs(ray.lower[k]), std::abs(ray.upper[k]));
    result.region.low += std::min(p, q);
    result.region.high += std::max(p, q);
    rounded += std::abs(direction[k]) * (sizes[k] + reach);
    underflowed += std::abs(direction[k]) + reach;
  }
  result.pad = 16 * unit_roundoff * rounded + 8 * smallest_double * underflowed;
  return result;
}

/// Compares boxes of the local frame with a world region along the three world axes and, when it is a ray, along
/// directions beside it (docs/design/culling.md).
class RegionSearch {
 public:
  RegionSearch(const PosedMesh& mesh, const Aabb& region, const std::function<bool(Index)>& visit)
      : mesh_(mesh), region_(region), visit_(visit) {
    for (int axis = 0; axis < 3; ++axis) directions_[count_++] = along_axis(mesh, region, axis);
    for (int axis = 0; axis < 3; ++axis)
      if (region.upper[axis] == infinity) add_directions_beside(axis);
  }

  double bound(const Aabb& node) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (separated(directions_[i], node)) return infinity;
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
  void add_directions_beside(int axis) {
    for (int j = 0; j < 3; ++j) {
      const Vec3 edge = mesh_.pose().linear.column(j);
      const bool gives_an_axis = edge[(axis + 1) % 3] == 0 || edge[(axis + 2) % 3] == 0;
      if (gives_an_axis) continue;  // it is there already, or nothing
      const RegionDirection direction = beside_ray(mesh_, region_, axis, edge);
      if (is_usable(direction)) directions_[count_++] = direction;
    }
  }

  static bool separated(const RegionDirection& direction, const Aabb& node) {
    const Range range = range_of(direction.on_mesh, node);
    return is_certain((range.low + direction.offset) - direction.region.high, direction.pad) ||
           is_certain(direction.region.low - (range.high + direction.offset), direction.pad);
  }

  const PosedMesh& mesh_;
  const Aabb& region_;
  const std::function<bool(Index)>& visit_;
  std::array<RegionDirection, 6> directions_{};  ///< a region has one infinite side at most
  std::size_t count_ = 0;
  bool ended_ = false;
};

}  // namespace

void visit_triangles_near(const PosedMesh& mesh, const Aabb& region, const std::function<bool(Index)>& visit) {
  RegionSearch question(mesh, region, visit);
  if (overlap(mesh.box(), region)) walk(mesh.model().tree(), question);
}

}  // namespace toccata
