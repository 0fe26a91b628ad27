#pragma once

#include "query/meshes/posed_mesh.hpp"

namespace toccata {

/// More than the distance of any point of one mesh from any of the other can have changed by between two places that
/// the two were at, as world points and as rounded; +∞ where nothing is known.
///
/// It is the least of three bounds on the change of the distance |Pp − Qq|: how far Pp and Qq have moved in the world,
/// and, where P (or Q) is a rotation, how far the other has moved as seen from it. A point moves by an affine function
/// of where it is, so a corner of the box around all moves farthest.
[[nodiscard]] double relative_motion(const Model& a, const Model& b, const Pose& a_before, const Pose& b_before,
                                     const Pose& a_after, const Pose& b_after);

}  // namespace toccata
