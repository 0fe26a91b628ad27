#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "narrow/boxes/box_overlay.hpp"
#include "narrow/boxes/box_separation.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Faces of boxes over each other, in the frame of one of them.
namespace toccata {

/// A face of a box: across an axis, at its low or its high end. Seen from outside of a high face, or from within
/// through a low one, x and y are the next two axes, and corners and sides are numbered as those of a SeenFace.
struct BoxFace {
  std::size_t axis = 0;
  bool low = false;
  [[nodiscard]] Index number() const { return static_cast<Index>(2 * axis + (low ? 0 : 1)); }
};

/// The reference face is that of the axis, or turns most along it; the incident one is the other box's.
struct BoxFacePair {
  BoxFace reference;
  BoxFace incident;
  bool b_is_reference = false;
};

/// The incident face over the reference face; gaps are along the normal, negative where the boxes overlap.
struct BoxContact {
  BoxFacePair faces;
  BoxOverlay overlay;
};

/// Where two faces of boxes lie over each other; without points when the axis is more than two degrees beside every
/// face, or nothing does.
[[nodiscard]] BoxContact contact_of_faces(const BoxView& a, const BoxView& b, const RigidBoxAxes& axes,
                                          const ChosenBoxAxis& along);

/// The reference face seen from the world.
class BoxFacePlane {
 public:
  BoxFacePlane(const BoxView& box, const BoxFace& face);
  [[nodiscard]] Vec3 at(double x, double y) const { return middle_ + (x * along_x_ + y * along_y_); }

 private:
  Vec3 along_x_, along_y_, middle_;
};

}  // namespace toccata
