#pragma once

#include <optional>

#include "narrow/boxes/rigid_box_axes.hpp"
#include "narrow/convex/core_separation.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {

/// Which of two boxes counts as the first, whose numbers are computed, and exchanged for the other order so that both
/// have the same bits; nothing where the centres do not tell.
[[nodiscard]] std::optional<bool> is_order_of_centres(const BoxView& a, const BoxView& b);

/// One of the fifteen axes of two boxes under nearly rigid poses.
struct ChosenBoxAxis {
  std::size_t edge_a = 0;  ///< 0 to 2 for a face of A or an edge pair; 3: a face of B
  std::size_t edge_b = 3;  ///< likewise
  Vec3 direction{};        ///< unit, from A to B
  double depth = 0;        ///< how far the boxes overlap along it, but for rounding
  double sine = 1;         ///< of the angle between the edges
};

/// Whether the axis is that of an edge of each, not of a face.
[[nodiscard]] inline bool is_of_edges(const ChosenBoxAxis& axis) { return axis.edge_a != 3 && axis.edge_b != 3; }

/// The axis along which the boxes overlap the least; edge pairs only where they have less than `edge_share` of the best
/// face's depth. Among equals faces of A come first, then faces of B. For boxes that are not certainly apart.
[[nodiscard]] ChosenBoxAxis least_axis(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes, double edge_share);

/// The points of the two edges that an edge axis is made of that are nearest to each other.
struct EdgePoints {
  Vec3 on_a;
  Vec3 on_b;
};

[[nodiscard]] EdgePoints points_of_edges(const BoxView& a, const BoxView& b, const ChosenBoxAxis& axis);

/// The corner of a box, by number, that is farthest along a direction.
[[nodiscard]] Index farthest_corner(const BoxView& box, const Vec3& direction);

/// What the axes tell of two boxes, once for all ways in which their depth may be found.
struct OverlappingBoxes {
  Nearness nearness = Nearness::unknown;
  RigidBoxAxes axes;    ///< of boxes that are not certainly apart
  ChosenBoxAxis least;  ///< of boxes that certainly meet
};

/// Nothing when the boxes are not certain to meet, or the bracket would be wider than it may be for boxes grown by
/// `reach` in sum. For boxes without radii that are certainly apart, it is a direction that parts them, with their
/// corners that are farthest along it. In canonical order of the two.
[[nodiscard]] std::optional<CoreSeparation> part_rigid_boxes(const BoxView& a, const BoxView& b, double reach,
                                                             OverlappingBoxes& found);

/// The penetration of boxes in canonical order for which `part_rigid_boxes` has nothing.
[[nodiscard]] std::optional<Penetration> penetration_of_close_boxes(const PosedPolytope& a, const PosedPolytope& b,
                                                                    const OverlappingBoxes& found);

/// In any order; nothing where one is no box, too.
[[nodiscard]] std::optional<Penetration> penetration_of_boxes(const PosedPolytope& a, const PosedPolytope& b);

}  // namespace toccata
