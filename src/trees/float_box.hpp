#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace toccata {

/// Four floats side by side; arithmetic and comparison are by lane.
using Float4 [[gnu::vector_size(16)]] = float;
using Int4 [[gnu::vector_size(16)]] = std::int32_t;

[[nodiscard]] inline Float4 least(Float4 a, Float4 b) { return a < b ? a : b; }
[[nodiscard]] inline Float4 greatest(Float4 a, Float4 b) { return a > b ? a : b; }

/// A box in the units of a wide tree; the last lanes are of no account.
struct FloatBox {
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  Float4 lower;
  Float4 upper;

  /// The box that anything can be merged into.
  [[nodiscard]] static FloatBox empty() {
    return {Float4{infinity, infinity, infinity, 0}, Float4{-infinity, -infinity, -infinity, 0}};
  }

  void add(const FloatBox& other) {
    lower = least(lower, other.lower);
    upper = greatest(upper, other.upper);
  }
  void add_point(Float4 point) {
    lower = least(lower, point);
    upper = greatest(upper, point);
  }

  /// Twice the centre.
  [[nodiscard]] Float4 middle() const { return lower + upper; }
  [[nodiscard]] float middle(int axis) const { return lower[axis] + upper[axis]; }
};

/// What it costs to look into a box that is not empty, by how often that happens: half the area of its sides. Lines and
/// points cost something too, so that there are few boxes of them.
[[nodiscard]] inline float visit_cost(const FloatBox& box) {
  constexpr float of_a_point = 1e-30F;
  const Float4 size = box.upper - box.lower;
  const Float4 sides = size * __builtin_shufflevector(size, size, 1, 2, 0, 3);
  return sides[0] + sides[1] + sides[2] + of_a_point;
}

/// An item's box, with the item's number in the lane that boxes do not use.
struct FloatItem : FloatBox {
  // Numbers are kept as floats of ordinary size: arithmetic on the lane is then as fast as on the others.
  static constexpr std::uint32_t ordinary = 0x30000000;

  [[nodiscard]] std::uint32_t number() const { return std::bit_cast<std::uint32_t>(float{lower[3]}) - ordinary; }
  void set_number(std::uint32_t number) { lower[3] = std::bit_cast<float>(number + ordinary); }
};

/// Some items that lie side by side, in space as in the order of items.
struct Cell : FloatBox {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

[[nodiscard]] inline std::uint32_t item_count(const FloatItem&) { return 1; }
[[nodiscard]] inline std::uint32_t item_count(const Cell& cell) { return cell.count; }

}  // namespace toccata
