#pragma once

#include <optional>
#include <vector>

#include "oracle/triangles.hpp"

namespace toccata::oracle {

/// The least t in [0, 1] at which origin + t · motion lies on the closed triangle, which may be a segment or a point.
std::optional<Rational> time_of_hit(const RationalPoint& origin, const RationalPoint& motion,
                                    const RationalTriangle& target);

}  // namespace toccata::oracle
