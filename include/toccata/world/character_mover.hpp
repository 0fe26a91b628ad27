#pragma once

#include <optional>
#include <span>
#include <vector>

#include "toccata/math/pose.hpp"
#include "toccata/query/object_queries.hpp"

// A character that walks: a convex shape that goes where it is told, as far as a level lets it, and slides along what
// it meets. It has no mass, and nothing is kept between two steps but the state that the caller has.
namespace toccata {

/// Lengths are in world units.
struct MoverOptions {
  Vec3 up{0, 0, 1};               ///< of any length above 0
  double skin = 0.01;             ///< how far the shape stays from everything
  double max_slope_degrees = 45;  ///< the steepest ground that is walked on, from level: 0 to less than 90
  double step_height = 0.3;       ///< the highest step that is walked up; 0: none
  double snap_distance = 0.3;     ///< how far below a walker ground is looked for, as on stairs and slopes that go down
  int max_slides = 8;             ///< how often the way may bend in one step, at least 1
};

/// Something that the character stands on, or met on its way. World coordinates.
template <class Id>
struct MoverContact {
  Id object{};
  Index element = 0;  ///< as in Model: the triangle of a mesh
  Vec3 point{};       ///< the object's point that is nearest to the shape
  Vec3 normal{};      ///< unit, from there to the shape
  friend bool operator==(const MoverContact&, const MoverContact&) = default;
};

/// Where the character is: all that is known of it from one step to the next.
template <class Id>
struct MoverState {
  Pose pose{};                               ///< of the shape; the mover changes its offset alone
  std::optional<MoverContact<Id>> ground{};  ///< none: it is in the air
  friend bool operator==(const MoverState&, const MoverState&) = default;
};

/// An object of the level that was somewhere else before the step: a platform, a lift, a door.
template <class Id>
struct MovedObject {
  Id object{};
  Pose before{};  ///< where it was; where it is now, the level knows
};

template <class Id>
struct MoverStep {
  MoverState<Id> state;
  Vec3 moved{};                            ///< by how much in all
  Vec3 carried{};                          ///< by how much of it on or by objects that moved
  Vec3 pushed_out{};                       ///< and out of what it began in, or nearer to than it stays
  std::vector<MoverContact<Id>> contacts;  ///< met by its own motion, in the order in which they were
  bool met_wall = false;                   ///< one of them is too steep to be walked on
  bool met_ceiling = false;                ///< or faces down as ground faces up
  bool stepped = false;                    ///< up a step
  bool tight = false;                      ///< it is still nearer than that to something, as in a way too narrow
  bool stuck = false;                      ///< it still overlaps something: there was no way out
  bool crushed = false;                    ///< something that moved its way could not push it aside
  bool cut_short = false;                  ///< it may not have gone as far as it can; the contacts show what stopped it
  friend bool operator==(const MoverStep&, const MoverStep&) = default;
};

/// One step: the character goes from a state by `motion` (world, what it wants to go in this step, falling included) in
/// a level, which is a SceneIndex or WorldQueries. The shape is any but a half-space, a mesh, a height field or a
/// compound; the level is anything. What is held:
///
///  - it comes no nearer to anything than 7/8 of the skin, or than it was, at any moment of the way, however long that
///    is. This is proved at every part of the way (docs/guide/character-mover.md), so nothing tunnels. Where it cannot
///    be proved, as far from the origin that the skin is lost in the rounding, the character stops, what it could not
///    be proved to pass is told as a contact, and the step is `cut_short`. It is that also where the way bends more
///    often than `max_slides`. What pushes or carries it may pass through it where something else is in the way; then
///    it is `crushed`;
///  - on ground, a motion that has no part along `up` is walked: its level part alone counts, over slopes up to the
///    greatest, up steps, and down by `snap_distance` at most; the ground that it stands on at the end is in the state.
///    Any other motion is a jump or a fall, which slides along everything. Steeper slopes are walls to what would
///    climb;
///  - it gains no more height in a step than the motion, the slopes and one step give, but for what carries it and
///    pushes it out;
///  - the answer has the same bits on every thread, each time.
///
/// Before it goes it is carried by the object of `moved` that it stands on, pushed by others of them that come its way,
/// and pushed out of what it overlaps or is too near to; by nothing that the filter refuses. A mesh that is taken as
/// solid is left by its surface.
///
/// Throws Error when a number is not finite, the motion too long to be added, an option is out of its range, the shape
/// is of another kind, or an object of `moved` is not in the level; like `distance` for the poses; and naming the
/// object when one of `moved` pushes it that is larger or smaller than it was, or mirrored (RigidMotion::between).
template <class Objects>
[[nodiscard]] MoverStep<typename Objects::Id> move_character(
    const ObjectQueries<Objects>& level, const Model& shape, const MoverState<typename Objects::Id>& from,
    const Vec3& motion, const MoverOptions& options = {}, const typename Objects::Filter& filter = {},
    std::span<const MovedObject<typename Objects::Id>> moved = {});

/// The vector nearest to `velocity` that goes into none of the planes: v · n ≥ 0 for every normal. So a velocity loses
/// what goes into the contacts of a step. Normals are of length 1. Throws Error for a number that is not finite.
[[nodiscard]] Vec3 velocity_along(const Vec3& velocity, std::span<const Vec3> normals);

}  // namespace toccata
