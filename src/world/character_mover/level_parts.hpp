#pragma once

#include <vector>

#include "world/character_mover/mover_surroundings.hpp"

namespace toccata {

/// An object of a level as the shapes that it is the union of. Throws Error, naming it, for a pose it may not have.
[[nodiscard]] std::vector<PosedPart> level_parts(const SearchedObjects& objects, Index object);

/// A part that is no mesh.
[[nodiscard]] LevelElement element_of(const PosedPart& part, Index object);

/// A triangle in the world, with its box.
[[nodiscard]] LevelElement element_of(const Triangle& triangle, const TriangleFace& face, Index object, Index element,
                                      const Aabb& box);

/// A triangle of one that is.
[[nodiscard]] LevelElement element_of(const PosedMesh& mesh, Index triangle, Index first_element, Index object);

}  // namespace toccata
