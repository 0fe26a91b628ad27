#pragma once

#include <span>

#include "narrow/quadrics/distance/quadric_search.hpp"

namespace toccata {

/// Whether the corners are four points of A − B that certainly have the origin between them: then the bodies certainly
/// have a point in common, and would when moved a little. In the frame of a pair whose numbers are those of
/// `PlainBody::height_at_most`.
[[nodiscard]] bool are_surely_around_origin(std::span<const QuadricSearch::Corner> corners);

/// A point of both bodies, made of such corners, but for rounding.
[[nodiscard]] Vec3 common_point_of(std::span<const QuadricSearch::Corner> corners);

}  // namespace toccata
