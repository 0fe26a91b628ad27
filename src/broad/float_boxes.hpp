#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"

namespace toccata {

/// Doubles as floats, such that a ≤ b stays so: less a middle, times a power of two, rounded to nearest, and kept
/// within the finite floats; each step keeps the order. So boxes that overlap do so as floats too, and boxes that do as
/// floats with room on every side do so indeed; only where two ends become equal have the doubles to be looked at.
class FloatFrame {
 public:
  FloatFrame() = default;
  /// In which the floats of coordinates in `around` are about 1 or less. Any other are in order too.
  explicit FloatFrame(const Aabb& around);

  [[nodiscard]] float map(double value, int axis) const {
    constexpr double most = std::numeric_limits<float>::max();
    const double scaled = (value - middle_[static_cast<std::size_t>(axis)]) * scale_;
    // Adding 0 leaves one kind of zero.
    return static_cast<float>(scaled < -most ? -most : scaled > most ? most : scaled) + 0.0F;
  }

  /// What becomes this float, but for rounding; infinite stays so.
  [[nodiscard]] double unmap(float value, int axis) const {
    return double{value} / scale_ + middle_[static_cast<std::size_t>(axis)];
  }

 private:
  std::array<double, 3> middle_{};
  double scale_ = 1;
};

struct FlatBox {
  std::array<float, 3> lower, upper;
  Index number;
};

[[nodiscard]] inline FlatBox flat_box(const FloatFrame& frame, const Aabb& box, Index number) {
  return {{frame.map(box.lower.x, 0), frame.map(box.lower.y, 1), frame.map(box.lower.z, 2)},
          {frame.map(box.upper.x, 0), frame.map(box.upper.y, 1), frame.map(box.upper.z, 2)},
          number};
}

/// The box around all finite coordinates of boxes that are not empty.
[[nodiscard]] Aabb finite_bounds(std::span<const Aabb> boxes);

/// Where columns of boxes lie. Some vectors' worth may be read behind the last.
struct BoxColumns {
  std::array<const float*, 3> lower, upper;
  const Index* number;
};

/// Boxes side by side, each coordinate in a column of its own.
class ColumnStore {
 public:
  /// Room for so many; what was there is lost where there was not.
  void resize(std::size_t count);
  void put(std::size_t place, const FlatBox& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      column(axis)[place] = box.lower[axis];
      column(3 + axis)[place] = box.upper[axis];
    }
    numbers_[place] = box.number;
  }
  [[nodiscard]] BoxColumns columns() const {
    const float* first = floats_.get();
    const std::size_t s = stride_;
    return {{first, first + s, first + 2 * s}, {first + 3 * s, first + 4 * s, first + 5 * s}, numbers_.get()};
  }
  [[nodiscard]] float lower(std::size_t axis, std::size_t place) const { return floats_[axis * stride_ + place]; }
  [[nodiscard]] float upper(std::size_t axis, std::size_t place) const { return floats_[(3 + axis) * stride_ + place]; }
  [[nodiscard]] Index number(std::size_t place) const { return numbers_[place]; }
  [[nodiscard]] std::size_t bytes() const { return stride_ * (6 * sizeof(float) + sizeof(Index)); }

 private:
  [[nodiscard]] float* column(std::size_t index) { return floats_.get() + index * stride_; }

  std::unique_ptr<float[]> floats_;
  std::unique_ptr<Index[]> numbers_;
  std::size_t stride_ = 0;  ///< the room in a column
};

}  // namespace toccata
