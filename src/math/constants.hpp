#pragma once

#include <limits>

namespace toccata {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline constexpr double greatest_double = std::numeric_limits<double>::max();

/// Half the spacing of the doubles next to 1: the largest relative error of one rounding to nearest.
inline constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

}  // namespace toccata
