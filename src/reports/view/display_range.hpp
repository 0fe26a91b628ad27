#pragma once

#include <cmath>

namespace toccata::io {

/// Numbers for what lies in an interval: x = lower + step · number, also where the interval is wider than the largest
/// double.
struct DisplayRange {
  double lower = 0;
  double step = 0;       ///< the width of the interval, or a quarter of it where the whole is no double
  bool is_whole = true;  ///< the former

  DisplayRange(double lower_end, double upper_end) : lower(lower_end), step(upper_end - lower_end) {
    is_whole = std::isfinite(step);
    if (!is_whole) step = upper_end / 4 - lower_end / 4;
  }

  /// From 0 to 1, or to 4; 0 where the interval is a point.
  [[nodiscard]] double number(double x) const {
    const double width = x - lower;
    if (!(step > 0)) return 0;
    return std::isfinite(width) ? width / step : x / step - lower / step;
  }
};

}  // namespace toccata::io
