#include "query/posed_mesh.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

}  // namespace

PosedMesh::PosedMesh(const Model& model, const Pose& pose, std::string_view who) : model_(model), pose_(pose) {
  require_finite(pose, who);
  vertices_ = transform(pose, model_.mesh().vertices());
  std::span<const Index> unused = model_.unused_vertices();
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    if (!is_finite(vertices_[i])) refuse_vertex(*this, i, who);
    if (!unused.empty() && unused.front() == i)
      unused = unused.subspan(1);
    else
      box_ = merge(box_, vertices_[i]);
  }
}

}  // namespace toccata
