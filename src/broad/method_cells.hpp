#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "broad/float_boxes.hpp"
#include "math/constants.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata {

inline constexpr Aabb whole_space{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};

/// A new group behind the others.
class CellsOfGroup {
 public:
  CellsOfGroup(BroadPhaseCells& all, std::string name, int dimensions = 3);
  void add(const Aabb& box) { all_.cells.push_back({box, group_}); }

 private:
  BroadPhaseCells& all_;
  Index group_;
};

/// Where the boxes lie along an axis, as a group. Empty boxes lie nowhere.
void add_intervals(BroadPhaseCells& cells, std::span<const Aabb> boxes, std::size_t axis);
/// Where they lie in the plane of an axis and the next.
void add_rectangles(BroadPhaseCells& cells, std::span<const Aabb> boxes, std::size_t axis);

/// Which cell of a grid of cubes everywhere.
using CellPlace = std::array<std::int64_t, 3>;
[[nodiscard]] Aabb cube_of_cell(const CellPlace& place, double side);
/// Scattered over all numbers, so that a table may take any bits of it; another one in each grid.
[[nodiscard]] inline std::uint64_t key_of_cell(const CellPlace& place, std::uint64_t grid) {
  std::uint64_t mixed = grid * 0x9e3779b97f4a7c15ULL;
  for (const std::int64_t cell : place) {
    mixed = (mixed ^ static_cast<std::uint64_t>(cell)) * 0xbf58476d1ce4e5b9ULL;
    mixed ^= mixed >> 29;
  }
  return mixed;
}

/// The box of doubles that became these floats, but for their rounding.
[[nodiscard]] Aabb box_of_floats(const FloatFrame& frame, const std::array<float, 3>& lower,
                                 const std::array<float, 3>& upper);

}  // namespace toccata
