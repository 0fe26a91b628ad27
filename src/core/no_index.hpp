#pragma once

#include <limits>

#include "toccata/core/index.hpp"

namespace toccata {

/// The number that stands for nothing.
inline constexpr Index no_index = std::numeric_limits<Index>::max();

}  // namespace toccata
