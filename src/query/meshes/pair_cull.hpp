#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "query/meshes/cull_bounds.hpp"
#include "query/meshes/posed_mesh.hpp"

namespace toccata {

/// A world direction L along which boxes of two meshes are compared: for local points x of A and y of B,
/// L · (world point of x − world point of y) is on_a · x − on_b · y + offset, up to `pad`.
struct CullDirection {
  Vec3 world;
  Vec3 on_a;
  Vec3 on_b;
  double offset = 0;
  double pad = 0;
};

/// Tells that two nodes of two posed meshes, each box in its own local frame, have no world point in common. It may
/// fail to tell, but is never wrong: the pads cover every rounding (docs/design/culling.md). Both poses are general.
class PairCull {
 public:
  /// `pad_scale` is for tests, which show that without the pads pairs are lost.
  PairCull(const PosedMesh& a, const PosedMesh& b, double pad_scale = 1);

  [[nodiscard]] bool disjoint(const Aabb& node_a, const Aabb& node_b) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (separated(directions_[i], node_a, node_b)) return true;
    return false;
  }

  /// Which of two nodes to split: the one that is larger in the world, roughly.
  [[nodiscard]] bool a_is_larger(const Aabb& node_a, const Aabb& node_b) const {
    return area_scale_a_ * half_area(node_a) >= area_scale_b_ * half_area(node_b);
  }

  [[nodiscard]] std::span<const CullDirection> directions() const { return {directions_.data(), count_}; }

 private:
  [[nodiscard]] static bool separated(const CullDirection& direction, const Aabb& node_a, const Aabb& node_b) {
    const FormRange a = range_of(direction.on_a, node_a);
    const FormRange b = range_of(direction.on_b, node_b);
    return is_certain((a.low + direction.offset) - b.high, direction.pad) ||
           is_certain((b.low - direction.offset) - a.high, direction.pad);
  }

  void add_box_normals(const PosedMesh& of, const PosedMesh& a, const PosedMesh& b);
  [[nodiscard]] double pad_of(const Vec3& world) const;
  void add(const Vec3& world, const PosedMesh& a, const PosedMesh& b);

  std::array<CullDirection, 9> directions_{};
  std::size_t count_ = 0;
  double pad_scale_ = 1;
  Vec3 world_sizes_;        ///< of both meshes together
  double coordinates_ = 0;  ///< the largest of each mesh and axis, added up
  double area_scale_a_ = 1;
  double area_scale_b_ = 1;
};

}  // namespace toccata
