#include "world/character_mover/level_parts.hpp"

#include <variant>

namespace toccata {

std::vector<PosedPart> level_parts(const SearchedObjects& objects, Index object) {
  const InstanceView at = objects.at(object);
  return pose_model(at.model, at.pose, at.solid, objects.name_of(object)).parts;
}

LevelElement element_of(const PosedPart& part, Index object) {
  const Aabb box = world_box(part.shape);
  if (const auto* polytope = std::get_if<PosedPolytope>(&part.shape))
    return {*polytope, object, part.first_element, box};
  if (const auto* quadric = std::get_if<PosedQuadric>(&part.shape)) return {*quadric, object, part.first_element, box};
  return {std::get<PosedHalfSpace>(part.shape), object, part.first_element, box};
}

LevelElement element_of(const PosedMesh& mesh, Index triangle, Index first_element, Index object) {
  const Triangle corners = mesh.triangle(triangle);
  return {PosedPolytope(corners), object, first_element + triangle, box_of(corners)};
}

}  // namespace toccata
