#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/query/scene_index.hpp"
#include "toccata/world/character_mover.hpp"

#include "support/mesh_soups.hpp"

// Levels for characters to walk in, made of a seed, and the judge of a step.
namespace toccata::test {

/// flat: one plane of triangles, many of them slivers, with T-junctions; room: a room of six walls of many triangles
/// with boxes and ramps in it; stairs: of meshes and of boxes; terrain: a height field with steep and gentle parts;
/// wedge: planes that meet in acute corners; soup: triangles without order; shapes: half-space, spheres, cylinders,
/// cones, ellipsoids, hulls and compounds; env: the planning scene of the data folder, where there is one.
inline constexpr std::array<std::string_view, 8> level_families{"flat",  "room", "stairs", "terrain",
                                                                "wedge", "soup", "shapes", "env"};

struct MoverLevelCase {
  SceneIndex level;
  std::vector<Vec3> starts;  ///< of the lowest point of a character, in the air or on the ground
  Vec3 lower, upper;         ///< what is solid all around keeps what is in it; equal: nothing does
};

[[nodiscard]] MoverLevelCase random_level(std::string_view family, Random& random);

/// A character that stands with its lowest point at its position.
[[nodiscard]] Model random_character(Random& random);

/// A rectangle from a corner along two sides, cut into triangles at random: with `seams`, in strips whose cuts do not
/// meet those of the next.
[[nodiscard]] TriangleMesh seamed_rectangle(const Vec3& corner, const Vec3& side, const Vec3& other, Random& random);

/// The least distance from all models of a level, by asking each; infinite where there is none.
[[nodiscard]] double distance_from_level(const SceneIndex& level, const Model& shape, const Pose& pose);

/// Is any model of the level no farther than that? Each is asked by itself, and answers exactly.
[[nodiscard]] bool is_within(const SceneIndex& level, const Model& shape, const Pose& pose, double distance);

/// What is wrong with how a character gets out of what it is in at a pose; empty if nothing is. It ends outside by the
/// skin, or says that it does not; and goes no farther than a few times the way to some place that is free.
[[nodiscard]] std::string fault_of_recovery(const SceneIndex& level, const Model& shape, const Pose& pose,
                                            const MoverOptions& options);

/// What is wrong with a step; empty if nothing is.
[[nodiscard]] std::string fault_of_step(const MoverLevelCase& level, const Model& shape, const MoverState<Index>& from,
                                        const Vec3& motion, const MoverOptions& options, const MoverStep<Index>& step);

/// Walks at random for some steps and tells the first fault.
[[nodiscard]] std::string fault_of_walk(const MoverLevelCase& level, Random& random, int steps);

}  // namespace toccata::test
