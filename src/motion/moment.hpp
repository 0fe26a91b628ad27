#pragma once

#include <optional>

#include "motion/moving_polygon.hpp"
#include "toccata/math/predicates.hpp"

namespace toccata {

/// Where a vertex and the corners of a face, or the ends of two edges, are at one time: exactly these doubles.
template <std::size_t Count>
struct Moment {
  std::array<Vec3, 4> position;

  /// The exact sign of the volume of the first three differences and the origin, up to one sign for all times.
  [[nodiscard]] Sign volume_sign() const { return orient3d(position[0], position[1], position[2], position[3]); }
  /// Whether the two features have a point in common; exact.
  [[nodiscard]] bool is_contact() const;
};

template <>
bool Moment<3>::is_contact() const;
template <>
bool Moment<4>::is_contact() const;

/// Nothing where a position at the time, which lies in [0, 1], is not certainly a double.
template <std::size_t Count>
[[nodiscard]] std::optional<Moment<Count>> moment_at(const MovingPolygon<Count>& polygon, double time);
template <>
std::optional<Moment<3>> moment_at(const MovingPolygon<3>& polygon, double time);
template <>
std::optional<Moment<4>> moment_at(const MovingPolygon<4>& polygon, double time);

}  // namespace toccata
