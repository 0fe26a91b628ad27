#include "shapes/validation.hpp"

#include <cmath>

#include <fmt/format.h>

#include "toccata/core/error.hpp"

namespace toccata {

void require_finite(const Vec3& value, std::string_view what) {
  if (!is_finite(value))
    throw Error(fmt::format("{} is ({}, {}, {}), which is not finite; give finite coordinates", what, value.x, value.y,
                            value.z));
}

void require_positive(double value, std::string_view what) {
  // A NaN is not greater than 0.
  if (!(value > 0) || !std::isfinite(value))
    throw Error(fmt::format("{} is {}; give a positive finite number", what, value));
}

}  // namespace toccata
