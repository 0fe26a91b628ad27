#pragma once

#include <algorithm>
#include <cmath>

#include "math/expansion.hpp"
#include "math/vec3_measures.hpp"
#include "methods/minkowski/sum_operand.hpp"

namespace toccata {

/// A frame of plain doubles for the filters of a sum: its origin is the exact sum of the first points, and its unit a
/// power of two of about the sum's size. So far from the world's origin nothing is lost, nor where all is tiny or huge.
struct SumFrame {
  SumFrame() = default;
  SumFrame(const SumOperand& a, const SumOperand& b);

  /// Off by at most 2^-51 (|p| + reach) for each coordinate, in the frame; NaN or infinite where that cannot be held.
  [[nodiscard]] Vec3 local(const Vec3& p) const { return {local(p, 0), local(p, 1), local(p, 2)}; }
  /// The same of a vertex.
  [[nodiscard]] Vec3 local(const Vec3& on_a, const Vec3& on_b) const {
    return scale * ((on_a - first_a) + (on_b - first_b));
  }
  [[nodiscard]] Vec3 local(const Difference& edge) const { return scale * (edge.head - edge.tail); }

  Vec3 first_a, first_b;
  Vec3 high, low;    ///< the origin is high + low, exactly
  double scale = 1;  ///< a power of two
  double reach = 0;  ///< no vertex has a greater coordinate in the frame; and what low is off by, times 2^53

 private:
  [[nodiscard]] double local(const Vec3& p, int axis) const {
    const TwoPart from_high = two_difference(p[axis], high[axis]);
    return scale * (from_high.high + (from_high.low - low[axis]));
  }
};

/// The plane of a facet in the frame: its points q have normal · q = height, up to error · (|q| + reach), where |q| is
/// the greatest magnitude of a coordinate.
struct SumPlane {
  Vec3 normal;
  double height = 0;
  double error = 0;
};

}  // namespace toccata
