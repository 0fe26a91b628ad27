#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "math/vec3_coordinates.hpp"
#include "narrow/primitives/nearness.hpp"
#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/narrow/posed_shapes.hpp"

// The fifteen axes of two boxes under nearly rigid poses: edges stand for the face normals, and everything is read off
// the table of the cosines between the edges of the two (S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree", 1996). In
// doubles, with a bound on the error; with vector instructions, the same bits at every level.
namespace toccata {

/// By number, found without branches.

/// A box as the axes see it. Four doubles can be read from the start of each vector and of each row.
struct BoxView {
  const Mat3* axes;
  const RigidBox* box;

  [[nodiscard]] Vec3 axis(std::size_t i) const {
    const double Vec3::*const along = vec3_coordinates[i];
    return {axes->row[0].*along, axes->row[1].*along, axes->row[2].*along};
  }
  [[nodiscard]] double half_extent(std::size_t i) const { return box->half_extents.*vec3_coordinates[i]; }
};

[[nodiscard]] inline BoxView view_of(const PosedPolytope& box) { return {&box.pose().linear, &box.as_box()}; }
[[nodiscard]] inline BoxView view_of(const PosedBox& box) { return {&box.pose.linear, &box.rigid}; }

/// Rigid but for what a long product rounds, and squares neither over- nor underflow: numbers are as good as if
/// edges were normals. And thicker than rounding, so that there is an interior: the centre is in it.
[[nodiscard]] inline bool is_rigid_and_plain(const BoxView& box) {
  const auto [x, y, z] = box.box->half_extents;
  const double least = std::min({x, y, z}), slack = box.box->slack;
  return box.box->skew <= 0x1p-40 && slack < 0x1p150 && least > 2 * slack && least > 0x1p-200;
}

using FourDoubles = std::array<double, 4>;  // three and one that is not to be looked at

/// What two boxes have in common along each axis, which is of length 1 for faces and of the sine of their angle for
/// edge pairs: how far they reach along it together, less the way between their centres.
struct RigidBoxAxes {
  double error;              ///< of each overlap, corners' rounding included
  FourDoubles way_a, way_b;  ///< from A's centre to B's, along the edges of A and of B
  FourDoubles overlap_a, overlap_b;
  std::array<FourDoubles, 3> cosines;         ///< [edge of A][edge of B]
  std::array<FourDoubles, 3> turned_cosines;  ///< [edge of B][edge of A]
  std::array<FourDoubles, 3> edge_overlap;

  // The places of least depth, of equals the first. Depths are overlaps per length of the axis.
  Index least_face;   ///< of the three of A, then of B
  Index least_edges;  ///< 3 · edge of A + edge of B; a nearly parallel pair only where there is no other
  /// For boxes that are apart only this is filled in: an axis that parts them; a face as above, or 6 more than an edge
  /// pair.
  Index separating_axis;

  /// The square of the sine of the angle between edges.
  [[nodiscard]] double squared_sine(std::size_t i, std::size_t j) const {
    constexpr std::array<std::size_t, 5> next = {0, 1, 2, 0, 1};
    const double c = cosines[next[i + 1]][j], d = cosines[next[i + 2]][j];
    return c * c + d * d;
  }
};

/// Edges at a smaller angle make no axis: faces do as well.
inline constexpr double least_sine_of_edges = 0x1p-12;

enum class Storing { where_unsure, always };

/// Whether the boxes have a point in common; if so, their interiors have. Unknown where an infinite slack forbids it.
[[nodiscard]] Nearness nearness_of_rigid_boxes(const BoxView& a, const BoxView& b);

/// Likewise of boxes that nobody has posed. If they are found to meet or apart, both can be posed.
[[nodiscard]] Nearness nearness_of_boxes(const Box& a, const Pose& pose_a, const Box& b, const Pose& pose_b);

/// All of the axes, if the boxes are not certainly apart; else one that parts them.
[[nodiscard]] Nearness nearness_of_rigid_boxes(const BoxView& a, const BoxView& b, RigidBoxAxes& axes);

}  // namespace toccata
