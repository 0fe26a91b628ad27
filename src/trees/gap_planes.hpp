#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "trees/near_walk.hpp"

namespace toccata {

/// A box of each of two trees: block · 8 + lane.
struct BoxPair {
  std::uint32_t first;
  std::uint32_t second;
};

/// A direction in which something of one tree lies before something of another, kept while they move: how far apart the
/// two are along it under any later view follows from these numbers and the view alone (docs/methods/mesh-distance.md).
/// Points p of the first tree are in its units and frame, points q of the second in its own. All numbers are meant as
/// they stand; what was rounded to make them is within `reach`.
struct GapPlane {
  std::array<float, 3> normal{};  ///< n, from the first to the second, of length 1 but for rounding
  std::array<float, 3> turned{};  ///< w: n as seen from the second tree when this was made, times the view's ratio
  std::array<float, 3> centre{};  ///< c: of what is of the second tree
  float radius = 0;               ///< |q − c| is at most that
  float reach = 0;                ///< n · p − w · (q − c) is at most that
};

/// Up to eight of them side by side.
struct GapPlaneLanes {
  static constexpr std::size_t width = OrientedBlock::width;
  using Lanes = std::array<float, width>;
  std::array<Lanes, 3> normal, turned, centre;
  Lanes radius, reach;
  std::array<double, width> least;  ///< lower bounds of the distances, in the first tree's units
};

/// Many of them, side by side for vector instructions.
class GapPlanes {
 public:
  struct Near {
    std::uint32_t place;
    float least;  ///< the bound, in the first tree's units
  };

  void clear();
  [[nodiscard]] std::size_t size() const { return size_; }

  /// A place for one more, which is never near until it is set.
  std::uint32_t add();
  void set(std::uint32_t place, const GapPlane& plane);
  void set(std::uint32_t place, const GapPlaneLanes& planes, std::size_t lane);
  /// Never near from now on.
  void unset(std::uint32_t place);

  /// In the order of their places, those that may be at most `limit` apart, in the first tree's units. The same at
  /// every SIMD level.
  void find_near(const NearView& view_of_first, double limit, std::vector<Near>& near) const;

  static constexpr std::size_t width = 16;
  struct alignas(64) Block {
    using Lanes = std::array<float, width>;
    std::array<Lanes, 3> normal, turned, centre;
    Lanes radius, reach;
  };

 private:
  std::vector<Block> blocks_;
  std::size_t size_ = 0;
};

// Planes that part boxes, under rigid views. Their bounds are never less than those of the walk, but for rounding to
// floats.

/// Makes the planes of up to eight pairs.
void part_boxes(const NearWalk& walk, std::span<const BoxPair> pairs, GapPlaneLanes& planes);

/// Makes the planes between the children of a block of the tree `side` and one box of the other.
void part_children(const NearWalk& walk, std::size_t side, std::uint32_t number, std::uint32_t other,
                   GapPlaneLanes& planes);

/// More than all that is rounded in computing a bound from a GapPlane in floats, the view's pad included.
[[nodiscard]] double plane_pad(const NearView& view);

}  // namespace toccata
