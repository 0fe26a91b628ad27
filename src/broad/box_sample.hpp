#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"

namespace toccata {

/// What boxes are like, from about a thousand of them, evenly chosen by number.
class BoxSample {
 public:
  explicit BoxSample(std::span<const Aabb> boxes);

  /// From numbers in order: that of rank one in a hundred, the median, that of 95 in a hundred, and the last; 0 if
  /// there are none.
  struct Spread {
    double low = 0, median = 0, high = 0, most = 0;
  };
  /// A quarter of the lower ends along an axis, of which `high` is 99 in a hundred. (A quarter, so that no difference
  /// of two overflows.)
  [[nodiscard]] const Spread& places(std::size_t axis) const { return places_[axis]; }
  /// A quarter of the lengths along an axis, of which `high` is 95 in a hundred.
  [[nodiscard]] const Spread& sizes(std::size_t axis) const { return sizes_[axis]; }
  /// The box around what is finite of the sample.
  [[nodiscard]] const Aabb& bounds() const { return bounds_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::array<Spread, 3> places_, sizes_;
  Aabb bounds_;
  std::size_t size_ = 0;
};

/// How crowded boxes are, from all pairs of a few hundred.
struct BoxDensity {
  BoxDensity(const BoxSample& sample, std::span<const Aabb> boxes);

  /// How likely it is that, of two boxes, one is met in a sweep along the best axis from the other.
  double swept = 0;
  /// How likely it is that, of two boxes, one is looked at in a grid from the other; what is larger than cells is
  /// counted by what it costs.
  double near = 0;
  bool heaped = false;  ///< far from evenly spread
};

/// Smaller boxes count as of this size where cells are of the size of boxes: where boxes are points, cells need not
/// tell doubles apart.
[[nodiscard]] double least_size(const BoxSample& sample);

}  // namespace toccata
