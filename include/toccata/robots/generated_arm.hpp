#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "toccata/query/check_all.hpp"
#include "toccata/robots/robot.hpp"

// A robot and a room made from numbers, with the same bits on every platform: for tests, benchmarks and the guide.
namespace toccata {

struct GeneratedArmShape {
  int subdivisions = 3;  ///< 0 … 6: a link is a bumpy, long ball of 20 · 4ⁿ triangles
  std::uint64_t seed = 1;
};

/// Seven joints that turn, about vertical and level axes by turns, and eight links of one mesh each: 1.3 m when it is
/// stretched out. "base", "link 1" … "link 7"; "joint 1" … "joint 7".
[[nodiscard]] RobotDescription generated_arm(const GeneratedArmShape& shape = {});

struct GeneratedRoomShape {
  std::size_t boxes = 100;  ///< turned any way
  bool meshes = true;       ///< a torus knot, a bumpy ball and a gear
  std::uint64_t seed = 1;
};

/// What stands around such an arm, and does not touch it where all positions are 0.
[[nodiscard]] std::vector<SceneInstance> generated_room(const GeneratedRoomShape& shape = {});

}  // namespace toccata
