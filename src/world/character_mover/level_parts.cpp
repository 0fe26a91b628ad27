#include "world/character_mover/level_parts.hpp"

#include <utility>
#include <variant>

namespace toccata {
namespace {

LevelElement with_planes(LevelSet set, Index object, Index element, const Aabb& box) {
  const ThingPlanes planes = planes_of(set);
  return {ElementSet(std::move(set)), object, element, box, planes};
}

}  // namespace

std::vector<PosedPart> level_parts(const SearchedObjects& objects, Index object) {
  const InstanceView at = objects.at(object);
  return pose_model(at.model, at.pose, at.solid, objects.name_of(object)).parts;
}

LevelElement element_of(const PosedPart& part, Index object) {
  const Aabb box = world_box(part.shape);
  const Index element = part.first_element;
  if (const auto* polytope = std::get_if<PosedPolytope>(&part.shape))
    return with_planes(*polytope, object, element, box);
  if (const auto* quadric = std::get_if<PosedQuadric>(&part.shape)) return with_planes(*quadric, object, element, box);
  return with_planes(std::get<PosedHalfSpace>(part.shape), object, element, box);
}

LevelElement element_of(const Triangle& triangle, const TriangleFace& face, Index object, Index element,
                        const Aabb& box) {
  return {ElementSet(triangle), object, element, box, planes_of(triangle, face)};
}

LevelElement element_of(const PosedMesh& mesh, Index triangle, Index first_element, Index object) {
  const Triangle corners = mesh.triangle(triangle);
  return element_of(corners, face_of(corners), object, first_element + triangle, box_of(corners));
}

}  // namespace toccata
