#include "query/meshes/posed_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "narrow/pose_checks.hpp"
#include "query/meshes/cull_bounds.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// No world vertex can be infinite where these sums are far from it.
bool may_overflow(const Pose& pose, const Aabb& vertices) {
  if (is_empty(vertices)) return false;
  const Vec3 sizes = world_sizes(pose, vertices);
  return !(std::max({sizes.x, sizes.y, sizes.z}) < 0.5 * std::numeric_limits<double>::max());
}

void require_finite_vertices(const PosedMesh& mesh, std::string_view who) {
  const std::size_t count = mesh.model().mesh().vertices().size();
  for (std::size_t i = 0; i < count; ++i)
    if (!is_finite(mesh.vertex(static_cast<Index>(i))))
      refuse_vertex(i, mesh.model().mesh().vertices()[i], mesh.pose(), who);
}

/// Around the world vertices of what lies in a box of the local frame (docs/design/culling.md, the region search).
Aabb world_box(const Pose& pose, const Aabb& local) {
  if (is_empty(local)) return {};
  const Vec3 sizes = world_sizes(pose, local);
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    const FormRange range = range_of(pose.linear[axis], local);
    const double pad = 16 * unit_roundoff * sizes[axis] + 8 * smallest_double;
    const double low = (range.low + pose.offset[axis]) - pad, high = (range.high + pose.offset[axis]) + pad;
    // World vertices are finite, so a side that overflowed is the greatest double.
    box.lower[axis] = std::isfinite(low) ? low : -std::numeric_limits<double>::max();
    box.upper[axis] = std::isfinite(high) ? high : std::numeric_limits<double>::max();
  }
  return box;
}

}  // namespace

PosedMesh::PosedMesh(const Model& model, const Pose& pose, std::string_view who) : model_(model), pose_(pose) {
  if (!model.has_mesh())
    throw Error(fmt::format("{}: this is asked of meshes, and it is a {}", who, name_of(model.shape())));
  require_finite(pose, who);
  if (may_overflow(pose, model.bounds())) require_finite_vertices(*this, who);
  box_ = world_box(pose, model.wide_bvh().box);
}

std::optional<Aabb> rigid_world_box(const Model& model, const Pose& pose) {
  const Aabb& vertices = model.bounds();
  if (!is_surely_finite(vertices.lower) || !is_surely_finite(vertices.upper)) return {};
  return world_box(pose, model.wide_bvh().box);
}

std::vector<Triangle> PosedMesh::triangles() const {
  std::vector<Triangle> triangles;
  triangles.reserve(model_.mesh().triangle_count());
  for (Index i = 0; i < model_.mesh().triangle_count(); ++i) triangles.push_back(triangle(i));
  return triangles;
}

}  // namespace toccata
