#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "methods/bsp/bsp_parts.hpp"
#include "toccata/methods/msp_tree.hpp"

namespace toccata {

/// A child of a node in a plane or on a line: another such node by its number, or a region that is not cut. For one
/// that lies on the surface, -2 - 7t - f holds the least triangle t that it lies on and what of it: f below 3 is a
/// vertex, below 6 an edge.
using MspChild = std::int32_t;

constexpr MspChild off_surface = -1;

[[nodiscard]] constexpr bool is_region(MspChild child) { return child < 0; }

/// What of a triangle a point, or a region, lies on.
struct TriangleFeature {
  Index triangle = 0;
  Feature feature;
};

[[nodiscard]] constexpr MspChild region_on(const TriangleFeature& on) {
  const int kind = static_cast<int>(on.feature.kind);
  return -2 - 7 * static_cast<MspChild>(on.triangle) - 3 * kind - on.feature.index;
}

[[nodiscard]] constexpr TriangleFeature on_of_region(MspChild region) {
  const int number = -2 - region, f = number % 7;
  return {static_cast<Index>(number / 7), {static_cast<FeatureKind>(f / 3), static_cast<std::uint8_t>(f % 3)}};
}

/// Cuts a part of a plane by a line, or a part of a line by a point.
struct MspNode {
  BspPlane plane = 0;
  std::array<MspChild, 3> child{};  ///< behind the plane, within it, in front of it

  [[nodiscard]] MspChild& beside(Sign side) { return child[1U + static_cast<std::size_t>(side)]; }
  [[nodiscard]] MspChild beside(Sign side) const { return child[1U + static_cast<std::size_t>(side)]; }
};

struct MspTree::Parts {
  explicit Parts(const Model& solid) : space(solid) {}

  BspTree::Parts space;
  std::vector<MspChild> within;  ///< of each node of space, what is in its plane
  std::vector<MspNode> nodes;
  MspStatistics statistics;
};

/// Builds the tree as `build_bsp` does.
void build_msp(MspTree::Parts& parts, const BspOptions& options);

}  // namespace toccata
