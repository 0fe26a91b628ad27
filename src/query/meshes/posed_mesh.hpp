#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/model.hpp"

namespace toccata {

/// A model with its pose applied: the world vertices of docs/truth.md, each computed when it is asked for, so that a
/// posed mesh costs nothing to make and holds no memory of its own.
class PosedMesh {
 public:
  /// Throws Error when the pose or a world vertex is not finite; `who` names the model in the message.
  PosedMesh(const Model& model, const Pose& pose, std::string_view who = "the model");

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const Pose& pose() const { return pose_; }

  /// In the world.
  [[nodiscard]] Vec3 vertex(Index number) const { return transform(pose_, model_.mesh().vertices()[number]); }

  /// All of them; unused ones included.
  [[nodiscard]] std::vector<Vec3> vertices() const { return transform(pose_, model_.mesh().vertices()); }

  /// In the world.
  [[nodiscard]] Triangle triangle(Index number) const {
    const auto& corner = model_.mesh().triangles()[number];
    return {{vertex(corner[0]), vertex(corner[1]), vertex(corner[2])}};
  }

  [[nodiscard]] std::vector<Triangle> triangles() const;

  /// Contains all world triangles; in the world. Empty for a mesh without any.
  [[nodiscard]] const Aabb& box() const { return box_; }

 private:
  Model model_;
  Pose pose_;
  Aabb box_;
};

/// The box of `PosedMesh(model, pose)` in less time, by a pose of which the caller knows that it is surely rigid and
/// finite (narrow/pose_checks.hpp); none where more has to be looked at.
[[nodiscard]] std::optional<Aabb> rigid_world_box(const Model& model, const Pose& pose);

/// Around one world triangle, exact.
[[nodiscard]] constexpr Aabb box_of(const Triangle& triangle) {
  return merge(merge({triangle[0], triangle[0]}, triangle[1]), triangle[2]);
}

}  // namespace toccata
