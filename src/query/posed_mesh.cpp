#include "query/posed_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "query/cull_bounds.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

void require_finite(const Pose& pose, std::string_view who) {
  if (is_finite(pose)) return;
  throw Error(fmt::format("{}: the pose ({}) has a number that is not finite", who, fmt::join(pose.numbers(), ", ")));
}

[[noreturn]] void refuse_vertex(const PosedMesh& mesh, std::size_t number, std::string_view who) {
  const Vec3& local = mesh.model().mesh().vertices()[number];
  throw Error(
      fmt::format("{}: vertex {} ({}, {}, {}) is not finite in the world under the pose ({}); use smaller "
                  "coordinates or a smaller scale",
                  who, number, local.x, local.y, local.z, fmt::join(mesh.pose().numbers(), ", ")));
}

/// No world vertex can be infinite where these sums are far from it.
bool may_overflow(const Pose& pose, const Aabb& vertices) {
  if (is_empty(vertices)) return false;
  const Vec3 sizes = world_sizes(pose, vertices);
  return !(std::max({sizes.x, sizes.y, sizes.z}) < 0.5 * std::numeric_limits<double>::max());
}

void require_finite_vertices(const PosedMesh& mesh, std::string_view who) {
  const std::size_t count = mesh.model().mesh().vertices().size();
  for (std::size_t i = 0; i < count; ++i)
    if (!is_finite(mesh.vertex(static_cast<Index>(i)))) refuse_vertex(mesh, i, who);
}

/// Around the world vertices of what lies in a box of the local frame (docs/design/culling.md, the region search).
Aabb world_box(const Pose& pose, const Aabb& local) {
  if (is_empty(local)) return {};
  const Vec3 sizes = world_sizes(pose, local);
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    const Range range = range_of(pose.linear[axis], local);
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
  require_finite(pose, who);
  if (may_overflow(pose, model.vertex_box())) require_finite_vertices(*this, who);
  box_ = world_box(pose, model.wide_tree().box);
}

std::vector<Triangle> PosedMesh::triangles() const {
  std::vector<Triangle> triangles;
  triangles.reserve(model_.mesh().triangle_count());
  for (Index i = 0; i < model_.mesh().triangle_count(); ++i) triangles.push_back(triangle(i));
  return triangles;
}

}  // namespace toccata
