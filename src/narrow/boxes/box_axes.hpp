#pragma once

#include <array>
#include <optional>

#include "toccata/narrow/posed_polytope.hpp"

// The fifteen axes along which two boxes can be separated: the normals of the three faces of each, and the cross
// products of their edges (S. Gottschalk, M. C. Lin, D. Manocha, "OBBTree", 1996). In doubles, with a bound on the
// error.
namespace toccata {

/// Made by Box, whatever its radius.
[[nodiscard]] bool is_box(const PosedPolytope& shape);

/// A box as a parallelepiped: the eight corners centre ± half[0] ± half[1] ± half[2]. World corners are rounded each by
/// itself, so they lie up to `bent` beside.
struct BoxFrame {
  Vec3 corner;  ///< number 0
  std::array<Vec3, 3> half;
  double size = 0;  ///< the sum of the magnitudes of all coordinates of `half`
  double bent = 0;
};

[[nodiscard]] BoxFrame box_frame(const PosedPolytope& box);

/// Two boxes seen along an axis.
struct BoxAxis {
  int edge_a = 0;    ///< 0 to 2 for a face of A or an edge pair; 3: a face of B
  int edge_b = 3;    ///< likewise
  Vec3 direction{};  ///< unit, from A to B
  double depth = 0;  ///< how far they overlap along it
};

class BoxAxes {
 public:
  BoxAxes(const PosedPolytope& a, const PosedPolytope& b);

  /// Whether the boxes, without radii, have a point in common, where the bounds on the errors leave no doubt.
  [[nodiscard]] std::optional<bool> meet() const;

  /// Products of three and squares of products of two lengths neither over- nor underflow. `least` is for such boxes.
  [[nodiscard]] bool is_of_plain_size() const;

  /// The axis along which the boxes overlap the least; edge pairs only where they have less than `edge_share` of the
  /// best face's depth. For boxes that meet.
  [[nodiscard]] BoxAxis least(double edge_share) const;

 private:
  [[nodiscard]] bool boxes_of_boxes_are_apart() const;
  [[nodiscard]] bool near_parallel_edges_do_not_matter(unsigned undecided) const;

  BoxFrame a_;
  BoxFrame b_;
  Vec3 way_;      ///< from the centre of A to that of B
  double error_;  ///< of a height along x × y, over |x|₁ |y|₁
};

}  // namespace toccata
