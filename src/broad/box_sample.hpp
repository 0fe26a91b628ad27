#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/random.hpp"

namespace toccata {

/// Calls `visit(number)` for about `wanted` of `count` numbers, which ascend: one by chance from each stretch of as
/// many, so that the sample does not follow a period in which things lie beside each other. The same ones each time.
template <class Visit>
void visit_sample(std::size_t count, std::size_t wanted, const Visit& visit) {
  const std::size_t step = std::max<std::size_t>(1, count / wanted);
  Random random(count);
  for (std::size_t begin = 0; begin < count; begin += step) {
    const std::size_t stretch = std::min(step, count - begin);
    visit(begin + ((random.bits() >> 32) * stretch >> 32));
  }
}

/// What boxes are like, from about a thousand of them.
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

/// How crowded boxes are, from all pairs of a few hundred, each of which may be any of the boxes: of a few from each
/// stretch of numbers, fewer would be near each other, where boxes that are near have numbers that are.
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
