#pragma once

#include <cstddef>
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

/// Two tubes of radius 1 wound around each other, half a turn apart. The second is the first moved up by half a pitch;
/// the flat top of each lies under the flat bottom of the other over its whole length, with triangles that are
/// translates of each other, so `gap` is the height of the air between them, in tube radii, everywhere: positive is
/// apart, negative overlaps. The sign survives rounding while gap · scale is above 8 units in the last place of
/// offset + 20 · scale.
[[nodiscard]] Scene interleaved_helices(double gap, const Placement& placement = {});

/// A star-shaped noise sphere within its own negative image: the surfaces coincide, the solids touch everywhere.
[[nodiscard]] Scene inside_negative_image(std::uint64_t seed, const Placement& placement = {});

/// How a mesh stands in the wall that has a hole of its form.
struct MouldShape {
  double factor = 1;    ///< of the mesh that stands in the hole, 1e-3 … 1e3; the hole is that of the mesh itself
  Vec3 about = {};      ///< the point, in the mesh's coordinates, that stays where it is when it is scaled
  double margin = 0.5;  ///< the wall around the mesh, more than 0, in the mesh's units
};

/// Any mesh in the hole that it leaves in a wall thicker than itself. With the factor 1 every triangle lies on its
/// twin. With 0.999 a closed mesh is apart from the wall if it is star-shaped about `about`, as a noise sphere is about
/// the origin; one that is not, as the bunny, cuts the wall. Throws Error for numbers out of range.
[[nodiscard]] Scene inside_negative_image(const TriangleMesh& mesh, const MouldShape& shape = {},
                                          const Placement& placement = {});

/// A star-shaped noise sphere and its copy scaled by `factor` about the centre: 0.999 lies inside, 1.001 around.
[[nodiscard]] Scene nested_shells(double factor, std::uint64_t seed, const Placement& placement = {});

/// Two unit boxes side by side with `gap` between their faces, which is −1 … 10⁹: positive is apart, 0 touches to
/// the bit, negative overlaps. The sign survives rounding while |gap| · scale is above 4 units in the last place of
/// offset + 2 · scale.
[[nodiscard]] Scene boxes_face_to_face(double gap = 0, const Placement& placement = {});
/// The same of two fields: each is one mesh of `per_side`² unit boxes, half an edge apart from each other, and every
/// box of the one faces a box of the other over the gap. `per_side` is 1 … 1000; the sign survives while |gap| · scale
/// is above 4 units in the last place of offset + 2 · scale · per_side.
[[nodiscard]] Scene fields_of_boxes(double gap, int per_side, const Placement& placement = {});
/// Two aligned boxes that share half their volume, and whose triangles nowhere cross.
[[nodiscard]] Scene boxes_sharing_half(const Placement& placement = {});
[[nodiscard]] Scene equal_boxes(const Placement& placement = {});

/// Three gears: two in mesh that do not touch, and a third whose teeth meet the first one's head on.
[[nodiscard]] Scene gear_train();
/// A robot arm with its tree of joints on a table, beside a workpiece: the base and the workpiece stand on the table,
/// the gripper runs into it. The arm's links are one group.
[[nodiscard]] Scene robot_arm();
/// A shelf with 40 parts a millimetre above its boards. Among them one clash, one part inside another, and one part
/// that stands on its board. The boards and sides are one group.
[[nodiscard]] Scene shelf_of_parts(std::uint64_t seed = 1);
/// A torus knot that passes through one ring freely, and is cut by a second.
[[nodiscard]] Scene knot_through_ring();

/// `count` small meshes, of a few kinds shared by all, scattered so that some collide.
[[nodiscard]] Scene many_parts(std::size_t count, std::uint64_t seed);

/// The same parts below trees of nodes that are bad hierarchies: a node for every kind of part, which lies all over
/// the place; each part one step deeper than the part before it; all parts side by side. Every part has a node of its
/// own with its pose, the other nodes are where the world is.
[[nodiscard]] Scene parts_by_kind(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene parts_in_a_chain(std::size_t count, std::uint64_t seed);
[[nodiscard]] Scene parts_side_by_side(std::size_t count, std::uint64_t seed);

struct NamedScene {
  std::string name;
  std::string description;
};

/// The scenes that `./toccata demo` shows, in its order.
[[nodiscard]] const std::vector<NamedScene>& demo_scenes();

/// One of them by name. Throws Error naming the closest when there is none.
[[nodiscard]] Scene demo_scene(std::string_view name);

}  // namespace toccata
