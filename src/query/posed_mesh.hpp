#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/model.hpp"

namespace toccata {

/// A model with its pose applied: the world vertices of docs/truth.md, computed once and used by every question.
class PosedMesh {
 public:
  /// Throws Error when the pose or a world vertex is not finite; `who` names the model in the message.
  PosedMesh(const Model& model, const Pose& pose, std::string_view who = "the model");

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const Pose& pose() const { return pose_; }

  /// In the world, by the numbers of the mesh's vertices; unused vertices included.
  [[nodiscard]] std::span<const Vec3> vertices() const { return vertices_; }

  /// In the world.
  [[nodiscard]] Triangle triangle(Index number) const {
    const auto& corner = model_.mesh().triangles()[number];
    return {{vertices_[corner[0]], vertices_[corner[1]], vertices_[corner[2]]}};
  }

  /// Around all triangles, in the world, exact.
  [[nodiscard]] const Aabb& box() const { return box_; }

 private:
  Model model_;
  Pose pose_;
  std::vector<Vec3> vertices_;
  Aabb box_;
};

/// Around one world triangle, exact.
[[nodiscard]] constexpr Aabb box_of(const Triangle& triangle) {
  return merge(merge({triangle[0], triangle[0]}, triangle[1]), triangle[2]);
}

}  // namespace toccata
