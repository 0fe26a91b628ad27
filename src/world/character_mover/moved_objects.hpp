#pragma once

#include <optional>
#include <span>

#include "world/character_mover/mover_walk.hpp"

namespace toccata {

/// An object that has moved, by its index in the level.
struct MovedIndex {
  Index object = 0;
  Pose before;
};

/// Where a character stood before a step.
struct MoverStand {
  Index object = 0;
  Vec3 point{};
};

struct CarriedPlace {
  Vec3 position;
  bool crushed = false;
  bool cut_short = false;
};

/// The character after the object that it stands on has carried it, and others have pushed it.
[[nodiscard]] CarriedPlace carried_along(const Vec3& position, const std::optional<MoverStand>& stand,
                                         std::span<const MovedIndex> moved, const SearchedObjects& objects,
                                         MoverWalk& walk, const MoverBody& body, double gap);

}  // namespace toccata
