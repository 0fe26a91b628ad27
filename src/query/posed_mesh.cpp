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
  const auto local = model_.mesh().vertices();
  vertices_.reserve(local.size());
  for (const Vec3& vertex : local) {
    vertices_.push_back(transform(pose, vertex));
    if (!is_finite(vertices_.back())) refuse_vertex(*this, vertices_.size() - 1, who);
  }
  for (const auto& corners : model_.mesh().triangles())
    for (const Index corner : corners) box_ = merge(box_, vertices_[corner]);
}

}  // namespace toccata
