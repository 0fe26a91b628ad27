#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "toccata/core/function_ref.hpp"
#include "toccata/core/index.hpp"
#include "toccata/trees/wide_bvh.hpp"
#include "trees/leaf_triangles.hpp"

namespace toccata {

/// A ray in the units of a wide tree, from its origin: origin + t · motion for t from 0 to 1. Every coordinate of both
/// is at most 8 in magnitude. `pad` covers, along each axis, all that was rounded on the way to these numbers; what the
/// walk rounds itself is its own business (docs/design/rays.md).
struct WideRay {
  std::array<float, 3> origin{};
  std::array<float, 3> motion{};
  float pad = 0;
  /// What a coordinate of the motion is off by, as a share of its greatest one, besides the rounding to floats. Where
  /// that is not known, or the origin is farther from the tree's box than 2⁻⁴, infinite: triangles are not looked at
  /// then, only their boxes.
  float lean = std::numeric_limits<float>::infinity();
  /// How much later than it is met, in t, a triangle's time may be told to be.
  float late = 0;
};

/// A triangle that a ray may meet, but not before t = `lower`.
struct RayCandidate {
  float lower;
  Index triangle;
  bool certain;  ///< the ray's line passes through it
};

/// What a ray may meet is shown some at a time, the earliest first, as `visit(ray, candidates, last)`, which returns
/// the greatest t that is still of interest. After the last ones nothing comes of that ray, and what is returned is
/// ignored.
using VisitCandidates = FunctionRef<float(std::size_t, std::span<const RayCandidate>, bool)>;

/// Shows, for every ray, triangles of which its first one is one: with what is later than another is met for certain,
/// or than what `visit` returned, left out. `leaves` are those of the tree or null; without them a triangle may be met
/// where its box is. A few rays walk at a time, a step each in turn: while one waits for memory, another is worked on.
void walk_rays(const WideBvh& tree, const LeafTriangles* leaves, std::span<const WideRay> rays, VisitCandidates visit);

/// What is told of the triangles in the lanes of a block that a ray's line meets the boxes of, by their places as bits.
struct RayLanes {
  unsigned possible = 0;                                 ///< the others are not met at a time from 0 to 1
  unsigned certain = 0;                                  ///< met at a time between 0 and 1
  std::array<float, WideBlock::width> lower{}, upper{};  ///< of the time; `upper` where it is certain
};

/// For tests: what the walk thinks of a block whose boxes are all met.
[[nodiscard]] RayLanes ray_lanes(const WideRay& ray, const WideBlock& block, const TriangleLanes& triangles);

}  // namespace toccata
