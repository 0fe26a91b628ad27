#pragma once

#include <array>
#include <cstddef>

#include "toccata/motion/time_of_impact.hpp"

// Both questions are one. The differences face − vertex are a triangle, those of two edges a parallelogram, and the two
// features meet when this polygon contains the origin. Its corners move linearly, as differences of what moves
// linearly.
namespace toccata {

/// The corner head − tail.
struct MovingCorner {
  const MovingPoint* head;
  const MovingPoint* tail;
};

/// Convex and flat at every time; corners in cyclic order.
template <std::size_t Count>
using MovingPolygon = std::array<MovingCorner, Count>;

inline MovingPolygon<3> differences(const VertexFace& pair) {
  const auto corner = [&](std::size_t i) { return MovingCorner{&pair.face[i], &pair.vertex}; };
  return {corner(0), corner(1), corner(2)};
}

inline MovingPolygon<4> differences(const EdgeEdge& pair) {
  const auto corner = [&](std::size_t i, std::size_t j) { return MovingCorner{&pair.a[i], &pair.b[j]}; };
  return {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
}

/// Times are told by cells of this length.
inline constexpr unsigned contact_level = 40;
inline constexpr double cell_length = 0x1p-40;

/// For finite coordinates, which are not checked.
[[nodiscard]] std::optional<TimeOfImpact> time_of_finite(const MovingPolygon<3>& polygon);
[[nodiscard]] std::optional<TimeOfImpact> time_of_finite(const MovingPolygon<4>& polygon);

/// The last stage: by signs of polynomials with integers. For all finite doubles, and slow.
[[nodiscard]] std::optional<TimeOfImpact> time_of_impact_by_integers(std::span<const MovingCorner> polygon);

}  // namespace toccata
