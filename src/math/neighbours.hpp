#pragma once

#include <bit>
#include <cstdint>

// Neighbouring doubles of positive ones: what std::nextafter finds, without its call.
namespace toccata {

/// The double above a positive one that is not infinite.
inline double next_above(double positive) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(positive) + 1); }

/// The double below a positive one.
inline double next_below(double positive) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(positive) - 1); }

}  // namespace toccata
