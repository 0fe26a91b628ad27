#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/shapes/scene.hpp"

namespace toccata {

/// Where and how large a hard case is made: every coordinate is multiplied by `scale` and the whole moved by `offset`
/// along each axis, both by the objects' poses.
struct Placement {
  double scale = 1;
  double offset = 0;
};

/// Two tubes wound around each other, half a turn apart, of tube radius 1. The gap between their surfaces is `gap`: the
/// second tube is turned so that it is `gap` (in units of the radius) short of touching the first, or for a negative
/// gap is pushed into it.
[[nodiscard]] Scene interleaved_helices(double gap, const Placement& placement = {});

/// A star-shaped noise sphere within its own negative image: the surfaces coincide, the solids touch everywhere.
[[nodiscard]] Scene inside_negative_image(std::uint64_t seed, const Placement& placement = {});

/// A star-shaped noise sphere and its copy scaled by `factor` about the centre: 0.999 lies inside, 1.001 around.
[[nodiscard]] Scene nested_shells(double factor, std::uint64_t seed, const Placement& placement = {});

[[nodiscard]] Scene boxes_face_to_face(const Placement& placement = {});
/// Two aligned boxes that share half their volume, and whose triangles nowhere cross.
[[nodiscard]] Scene boxes_sharing_half(const Placement& placement = {});
[[nodiscard]] Scene equal_boxes(const Placement& placement = {});

/// Two gears in mesh, on parallel axes. Their teeth are `clearance` apart at the tightest place; 0 lets them touch.
[[nodiscard]] Scene gear_pair();
/// A robot arm of five links on a base over a table with a box on it: the gripper runs into the table.
[[nodiscard]] Scene robot_arm();
/// A shelf with about 40 parts on its boards, each standing on its board; two of them clash, and one is inside another.
[[nodiscard]] Scene shelf_of_parts(std::uint64_t seed = 1);
/// A torus knot that passes through a ring without touching it, and a second ring that it cuts.
[[nodiscard]] Scene knot_through_ring();

/// `count` small meshes, of a few kinds shared by all, scattered so that some collide.
[[nodiscard]] Scene many_parts(std::size_t count, std::uint64_t seed);

struct NamedScene {
  std::string name;
  std::string description;
};

/// The scenes that `./toccata demo` shows, in its order.
[[nodiscard]] const std::vector<NamedScene>& demo_scenes();

/// One of them by name. Throws Error naming the closest when there is none.
[[nodiscard]] Scene demo_scene(std::string_view name);

}  // namespace toccata
