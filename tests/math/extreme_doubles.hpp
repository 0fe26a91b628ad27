#pragma once

#include <limits>

namespace toccata::test {

/// The least positive double.
inline constexpr double least = std::numeric_limits<double>::denorm_min();
inline constexpr double largest = std::numeric_limits<double>::max();

}  // namespace toccata::test
