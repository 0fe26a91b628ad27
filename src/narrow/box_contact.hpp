#pragma once

#include <array>
#include <cstddef>

#include "narrow/box_parting.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Faces of boxes over each other, in the frame of one of them.
namespace toccata {

/// A corner of the part of one box's face that lies over a face of the other.
struct BoxContactPoint {
  double x = 0, y = 0;  ///< of its image in the reference face, along that box's two edges, from the face's middle
  double gap = 0;       ///< from there to the incident face, along the normal; negative: the boxes overlap there
  ConvexFeature on_reference{};
  ConvexFeature on_incident{};
};

/// At most eight of them.
struct BoxContact {
  std::array<BoxContactPoint, 8> points{};
  std::size_t count = 0;
  bool b_is_reference = false;
  std::array<int, 3> axis{};  ///< of the reference box: those of x and of y, and the one across the face
  Vec3 middle;                ///< of the reference face

  /// Half way between the two faces.
  [[nodiscard]] Vec3 position(const BoxContactPoint& p, const BoxView& reference, const Vec3& normal) const;
};

/// Empty when the direction of the axis is more than two degrees beside every face, or nothing lies over the face.
[[nodiscard]] BoxContact contact_of_faces(const BoxView& a, const BoxView& b, const ChosenBoxAxis& along);

/// Of boxes that have a point in common, in canonical order; without a point where it is left to others.
[[nodiscard]] Manifold manifold_of_rigid_boxes(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes);

}  // namespace toccata
