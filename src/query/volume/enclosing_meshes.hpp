#pragma once

#include <optional>

#include "query/posed_shape.hpp"

namespace toccata {

/// A solid as closed meshes in the world: one that lies within it and one that contains it, or one that is it. Without
/// any it has no volume.
struct EnclosingMeshes {
  std::optional<PosedMesh> within;
  std::optional<PosedMesh> around;  ///< none where `within` is the solid itself

  [[nodiscard]] const PosedMesh& outer() const { return around ? *around : *within; }
};

/// `near` is a box around all that matters, for a shape without end. The shape is a solid.
[[nodiscard]] EnclosingMeshes enclosing_meshes(const PosedShape& shape, const Aabb& near);

}  // namespace toccata
