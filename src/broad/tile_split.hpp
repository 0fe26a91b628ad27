#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "broad/float_boxes.hpp"

namespace toccata {

/// Where a set of boxes is cut into slabs along one axis. A box belongs to every slab that it reaches into.
class TileSplit {
 public:
  static constexpr std::size_t most_slabs = 16;

  /// Slabs of about as many boxes each, so many that tiles become as wide along each axis, measured by the boxes; one
  /// only where more would not help. All but the first begin behind `corner`. `sample` are some of the `count` boxes,
  /// evenly chosen, and may be reordered.
  TileSplit(std::span<FlatBox> sample, std::size_t count, std::size_t tile_size, const std::array<float, 3>& corner);

  [[nodiscard]] std::size_t slabs() const { return slabs_; }
  [[nodiscard]] std::size_t axis() const { return axis_; }
  /// Where a slab but the first begins; what lies there belongs to it.
  [[nodiscard]] float begin_of(std::size_t slab) const { return cuts_[slab - 1]; }
  [[nodiscard]] std::uint8_t first_slab(const FlatBox& box) const { return slab_of(box.lower[axis_]); }
  [[nodiscard]] std::uint8_t last_slab(const FlatBox& box) const { return slab_of(box.upper[axis_]); }

 private:
  [[nodiscard]] std::uint8_t slab_of(float coordinate) const {
    using Floats [[gnu::vector_size(16)]] = float;
    using Words [[gnu::vector_size(16)]] = std::int32_t;
    const Floats all{coordinate, coordinate, coordinate, coordinate};
    Words less{};
    for (std::size_t i = 0; i < most_slabs; i += 4)
      less += Floats{cuts_[i], cuts_[i + 1], cuts_[i + 2], cuts_[i + 3]} <= all;
    return static_cast<std::uint8_t>(-(less[0] + less[1] + less[2] + less[3]));
  }

  std::size_t axis_ = 0;
  std::size_t slabs_ = 1;
  alignas(16) std::array<float, most_slabs> cuts_;  ///< ascending; +∞ behind the last
};

}  // namespace toccata
