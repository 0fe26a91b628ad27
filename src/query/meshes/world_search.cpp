#include "query/meshes/world_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/constants.hpp"
#include "math/vec3_measures.hpp"
#include "math/world_vertex.hpp"
#include "query/meshes/cull_bounds.hpp"
#include "query/meshes/wide_cull.hpp"
#include "trees/prism_directions.hpp"

namespace toccata {
namespace {

bool is_usable(const RegionDirection& d) {
  return is_finite(d.on_mesh) && std::isfinite(d.offset) && std::isfinite(d.region.low) &&
         std::isfinite(d.region.high) && std::isfinite(d.pad);
}

/// The rows of R are the forms, so nothing but the evaluation and the world vertices themselves is rounded.
RegionDirection along_axis(const PosedMesh& mesh, const Aabb& region, int axis) {
  return {mesh.pose().linear[axis],
          mesh.pose().offset[axis],
          {region.lower[axis], region.upper[axis]},
          culling_pad(world_sizes(mesh)[axis], 1)};
}

/// Along a direction in which the region lies in a range. As for two meshes, the region being the second: no coordinate
/// of it is greater than `reach`.
RegionDirection along(const PosedMesh& mesh, const Vec3& direction, const FormRange& region, const Vec3& reach) {
  const Vec3 size = magnitudes(direction);
  RegionDirection result;
  result.on_mesh = transpose(mesh.pose().linear) * direction;
  result.offset = dot(direction, mesh.pose().offset);
  result.region = region;
  result.pad =
      culling_pad(dot(size, world_sizes(mesh) + reach), 1 + sum_of_magnitudes(largest_coordinates(mesh)) +
                                                            sum_of_magnitudes(size) + sum_of_magnitudes(reach));
  return result;
}

void add_usable(const RegionDirection& direction, const PosedMesh& mesh, WideProbe& probe) {
  if (is_usable(direction)) add_axis(direction, mesh.model().wide_bvh(), probe);
}

void add_ranges(const RegionRanges& ranges, const PosedMesh& mesh, WideProbe& probe) {
  for (const RangeAlong& one : ranges.all())
    add_usable(along(mesh, one.direction, one.range, ranges.reach), mesh, probe);
}

/// The direction at right angles to a ray along `axis` and to an edge of the mesh's posed boxes: turned boxes that lie
/// beside the ray are told by it, while their world boxes meet the ray.
RegionDirection beside_ray(const PosedMesh& mesh, const Aabb& ray, int axis, const Vec3& edge) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double size = std::max(std::abs(edge[i]), std::abs(edge[j]));
  Vec3 direction;
  direction[i] = -edge[j] / size;
  direction[j] = edge[i] / size;
  return along(mesh, direction, range_of(direction, ray), largest_coordinates(ray));
}

/// What of a region lies in a box that it meets: a region may be infinite.
Aabb within(const Aabb& region, const Aabb& box) {
  Aabb part;
  for (int axis = 0; axis < 3; ++axis) {
    part.lower[axis] = std::max(region.lower[axis], box.lower[axis]);
    part.upper[axis] = std::min(region.upper[axis], box.upper[axis]);
  }
  return part;
}

void add_directions_beside(const PosedMesh& mesh, const Aabb& ray, int axis, WideProbe& probe) {
  for (int j = 0; j < 3; ++j) {
    const Vec3 edge = mesh.pose().linear.column(j);
    const bool gives_an_axis = edge[(axis + 1) % 3] == 0 || edge[(axis + 2) % 3] == 0;
    if (gives_an_axis) continue;  // it is there already, or nothing
    add_usable(beside_ray(mesh, ray, axis, edge), mesh, probe);
  }
}

/// Boxes of the local frame are compared with the region along the three world axes and, when it is a ray, along
/// directions beside it (docs/design/culling.md).
WideProbe probe_of(const PosedMesh& mesh, const Aabb& region) {
  const Aabb part = within(region, mesh.box());
  WideProbe probe;
  for (int axis = 0; axis < 3; ++axis) add_axis(along_axis(mesh, part, axis), mesh.model().wide_bvh(), probe);
  for (int axis = 0; axis < 3; ++axis)
    if (region.upper[axis] == infinity) add_directions_beside(mesh, part, axis, probe);
  return probe;
}

/// Everything below the plane, as far down as the mesh may reach. What is rounded is less than in `beside_ray`: the
/// normal is not.
RegionDirection below(const PosedMesh& mesh, const PosedHalfSpace& half_space) {
  const Vec3 normal = near_unit(half_space.normal), sizes = world_sizes(mesh), local = largest_coordinates(mesh);
  RegionDirection result;
  result.on_mesh = transpose(mesh.pose().linear) * normal;
  result.offset = dot(normal, mesh.pose().offset);
  double size = 0, rounded = 0, underflowed = 4 + ((local.x + local.y) + local.z);
  for (int k = 0; k < 3; ++k) {
    const double point = std::abs(half_space.point[k]);
    size += std::abs(normal[k]) * sizes[k];
    rounded += std::abs(normal[k]) * (sizes[k] + point);
    underflowed += sizes[k] + point;
  }
  result.region.high = dot(normal, half_space.point);
  result.region.low = std::min(-2 * size, result.region.high);
  result.pad = culling_pad(rounded, underflowed);
  return result;
}

/// Whatever the direction, no point of the triangle is outside of it.
RegionDirection along(const PosedMesh& mesh, const Vec3& direction, const Triangle& triangle) {
  const double p = dot(direction, triangle[0]), q = dot(direction, triangle[1]), r = dot(direction, triangle[2]);
  return along(mesh, direction, {std::min({p, q, r}), std::max({p, q, r})}, largest_coordinates(box_of(triangle)));
}

}  // namespace

WideProbe probe_of(const PosedMesh& mesh, const Triangle& triangle) {
  WideProbe probe;
  for (const Vec3& direction : prism_directions(triangle.vertex))
    add_usable(along(mesh, direction, triangle), mesh, probe);
  // One without area has no normals, but a box.
  if (probe.count < 4)
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
      add_usable(along(mesh, axis, triangle), mesh, probe);
  return probe;
}

void visit_triangles_near(const PosedMesh& mesh, const PosedHalfSpace& half_space, FunctionRef<bool(Index)> visit) {
  WideProbe probe;
  add_usable(below(mesh, half_space), mesh, probe);
  walk_probe(mesh.model().wide_bvh(), probe, visit);
}

void visit_triangles_in(const PosedMesh& mesh, const RegionRanges& ranges, FunctionRef<bool(Index)> visit) {
  WideProbe probe;
  add_ranges(ranges, mesh, probe);
  walk_probe(mesh.model().wide_bvh(), probe, visit);
}

void visit_triangles_near(const PosedMesh& mesh, const Aabb& region, FunctionRef<bool(Index)> visit) {
  visit_triangles_near(mesh, region, {}, visit);
}

void visit_triangles_near(const PosedMesh& mesh, const Aabb& region, const RegionRanges& body,
                          FunctionRef<bool(Index)> visit) {
  if (!overlap(mesh.box(), region)) return;
  WideProbe probe = probe_of(mesh, region);
  add_ranges(body, mesh, probe);
  walk_probe(mesh.model().wide_bvh(), probe,
             [&](Index triangle) { return !overlap(box_of(mesh.triangle(triangle)), region) || visit(triangle); });
}

void visit_world_triangles(const PosedMesh& mesh, const Aabb& region, FunctionRef<void(const MeshTriangle&)> visit) {
  if (!overlap(mesh.box(), region)) return;
  const std::span<const Vec3> vertices = mesh.model().mesh().vertices();
  const auto triangles = mesh.model().mesh().triangles();
  walk_probe(mesh.model().wide_bvh(), probe_of(mesh, region), [&](Index number) {
    const auto& corner = triangles[number];
    const auto place = [&](Index i) { return world_vertex(mesh.pose(), vertices[corner[i]]); };
    const Triangle corners{{place(0), place(1), place(2)}};
    const Aabb box = box_of(corners);
    if (overlap(box, region)) visit({number, corners, box});
    return true;
  });
}

}  // namespace toccata
