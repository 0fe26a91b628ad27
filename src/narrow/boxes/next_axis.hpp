#pragma once

#include <array>
#include <cstddef>

namespace toccata {

inline constexpr std::array<std::size_t, 3> next_of_axis = {1, 2, 0};

/// The next of the three axes in a circle. Which one it is cannot be guessed: it is looked up and not asked for.
constexpr std::size_t next_axis(std::size_t axis) { return next_of_axis[axis]; }

}  // namespace toccata
