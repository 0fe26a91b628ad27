#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "narrow/box_parting.hpp"
#include "toccata/narrow/convex_convex.hpp"

// Faces of boxes over each other, in the frame of one of them.
namespace toccata {

/// A face of a box: across an axis, at its low or its high end.
struct BoxFace {
  int axis = 0;
  bool low = false;
  [[nodiscard]] Index number() const { return static_cast<Index>(2 * axis + (low ? 0 : 1)); }
};

/// The reference face is that of the axis, or turns most along it; the incident one is the other box's.
struct BoxFacePair {
  BoxFace reference;
  BoxFace incident;
  bool b_is_reference = false;
};

/// A corner of the part of the incident face that lies over the reference face.
struct BoxContactCorner {
  double x, y;  ///< of its image in the reference face, along that box's two edges, from the face's middle
  double gap;   ///< from there to the incident face, along the normal; negative: the boxes overlap there
  /// The side that leaves it: a half-edge of the incident face, or `of_reference` more than one of the reference face.
  std::uint8_t side;
  static constexpr std::uint8_t of_reference = 32;
};

struct BoxContact {
  static constexpr std::size_t capacity = 12;
  std::array<BoxContactCorner, capacity> corners;
  std::size_t count = 0;
  BoxFacePair faces{};
};

/// Where two faces of boxes lie over each other; empty when the axis is more than two degrees beside every face, or
/// nothing does (I. E. Sutherland, G. W. Hodgman, "Reentrant polygon clipping", 1974).
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

struct BoxManifold {
  Nearness nearness = Nearness::unknown;
  Manifold manifold{};
  [[nodiscard]] bool is_decided() const {
    return nearness == Nearness::apart || (nearness == Nearness::meet && manifold.count > 0);
  }
};

/// In canonical order. Where it is not decided, `manifold` holds if the boxes meet after all and it has a point.
[[nodiscard]] BoxManifold manifold_of_rigid_boxes(const BoxView& a, const BoxView& b);

}  // namespace toccata
