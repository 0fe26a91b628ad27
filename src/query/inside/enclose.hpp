#pragma once

#include "math/exact.hpp"
#include "query/inside/inside_interval.hpp"

namespace toccata {

/// Doubles on both sides of `value`, or twice the same one that equals it. Precondition: within the range of doubles.
[[nodiscard]] Interval enclose(const Rational& value);

}  // namespace toccata
