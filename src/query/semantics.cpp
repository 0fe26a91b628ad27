#include "query/semantics.hpp"

#include <fmt/format.h>

#include "toccata/core/error.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata {

bool taken_as_solid(const Model& model, const Pose& pose, Solid solid, std::string_view who) {
  if (solid == Solid::none) return false;
  if (std::holds_alternative<HeightField>(model.shape())) {
    if (solid == Solid::automatic) return false;
    throw Error(
        fmt::format("{}: a height field is a surface; it cannot be asked about as a solid (use solid = auto)", who));
  }
  if (!model.closed()) {
    if (solid == Solid::automatic) return false;
    throw Error(
        fmt::format("{}: the mesh is open ({} edges are not used equally often in both directions), so it encloses no "
                    "solid; close it, or take it as a surface (solid = auto or none)",
                    who, inspect(model.mesh()).unbalanced_edges));
  }
  if (is_singular(pose.linear))
    throw Error(
        fmt::format("{}: the pose is singular (its 3×3 part has determinant 0) and flattens the solid; give another "
                    "pose, or take the mesh as a surface (solid = none)",
                    who));
  return true;
}

}  // namespace toccata
