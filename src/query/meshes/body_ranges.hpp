#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "query/meshes/cull_bounds.hpp"
#include "toccata/narrow/posed_polytope.hpp"
#include "toccata/narrow/quadrics.hpp"

namespace toccata {

/// No point of a body is outside of the range along the direction, which is of length 1 but for rounding; but for the
/// rounding of a few products and sums of numbers that are no greater than `BodyRanges::reach`
/// (docs/design/culling.md).
struct BodyRange {
  Vec3 direction{};
  FormRange range{};
};

/// Three directions at right angles or nearly so, along which a body is narrow where its box is wide, as a rod is that
/// lies across the axes. None of a body that they tell little more about than its box does.
class BodyRanges {
 public:
  BodyRanges() = default;
  /// `box` is around the body in the world.
  BodyRanges(const PosedPolytope& body, const Aabb& box);
  BodyRanges(const PosedQuadric& body, const Aabb& box);

  [[nodiscard]] const Vec3& reach() const { return reach_; }
  [[nodiscard]] std::span<const BodyRange> all() const { return {ranges_.data(), count_}; }

 private:
  void keep_if_narrower_than(const Aabb& box);

  std::array<BodyRange, 3> ranges_{};
  Vec3 reach_{};
  std::size_t count_ = 0;
};

}  // namespace toccata
