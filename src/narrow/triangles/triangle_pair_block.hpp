#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "toccata/math/pose.hpp"
#include "toccata/narrow/triangle_triangle.hpp"

namespace toccata {

/// Up to eight pairs of triangles side by side, one per lane of the vector instructions, and what became known about
/// them. Lanes from `count` on may hold any numbers, but must hold some: value-initialise a block before its first use.
struct alignas(64) TrianglePairBlock {
  static constexpr std::size_t lanes = 8;
  /// Coordinates by corner, axis and lane.
  using Corners = std::array<std::array<std::array<double, lanes>, 3>, 3>;

  Corners a;  ///< in each mesh's own frame; in the world after `classify_pairs`
  Corners b;
  std::size_t count = 0;  ///< how many lanes hold pairs

  // Written by `classify_pairs`. Bit i of a verdict is for lane i; a pair with neither is certainly apart.
  std::uint8_t intersection = 0;  ///< certainly have a point in common
  std::uint8_t unknown = 0;       ///< plain arithmetic cannot tell: ask `overlap` or `intersect`
  std::uint64_t signs = 0;        ///< for `intersection_in`
};

/// Places a by `pose_a` and b by `pose_b`, to the bit as `transform` does, and decides every pair for which plain
/// arithmetic with a bound on its error is enough: pairs in general position, apart or crossing. Touching pairs,
/// coplanar ones and triangles without area are left unknown, unless their boxes are disjoint; so are triangles that
/// the pose makes infinite. The answers are the same at every SIMD level.
void classify_pairs(const Pose& pose_a, const Pose& pose_b, std::span<TrianglePairBlock> blocks);

/// The same for pairs of triangles of one mesh: those with a vertex in common, by coordinates, are certainly apart here
/// where all other vertices of one are on one side of the other's plane. They have nothing else in common then.
void classify_neighbours(const Pose& pose, std::span<TrianglePairBlock> blocks);

/// The triangles of a lane, as the block now holds them.
[[nodiscard]] Triangle triangle_a(const TrianglePairBlock& block, std::size_t lane);
[[nodiscard]] Triangle triangle_b(const TrianglePairBlock& block, std::size_t lane);

/// Puts a pair into a lane.
void set_pair(TrianglePairBlock& block, std::size_t lane, const Triangle& a, const Triangle& b);

/// What `intersect` says of the triangles in a lane whose bit in `intersect` is set.
[[nodiscard]] const Intersection& intersection_in(const TrianglePairBlock& block, std::size_t lane);

}  // namespace toccata
