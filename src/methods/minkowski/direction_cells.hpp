#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "toccata/core/index.hpp"
#include "toccata/math/vec3.hpp"

namespace toccata {

/// The cone of directions in which a convex face is seen from the origin.
struct DirectionCone {
  std::vector<Vec3> corners;  ///< of any length
  std::vector<Vec3> walls;    ///< unit, inwards: of the planes through the origin and an edge, where they are certain
};

/// The directions as the surface of a cube, divided into squares that know the cones which reach into them.
class DirectionCells {
 public:
  DirectionCells() = default;
  /// Angles up to 2^-19 more count as reached, so that rounding of directions loses none.
  explicit DirectionCells(std::span<const DirectionCone> cones);

  /// All cones that hold the direction, and perhaps some close to it. The direction is finite and not zero.
  [[nodiscard]] std::span<const Index> cones_around(const Vec3& direction) const;

  [[nodiscard]] std::size_t memory() const {
    return roots_.capacity() * sizeof(Index) + cells_.capacity() * sizeof(Cell) + lists_.capacity() * sizeof(Index);
  }

 private:
  static constexpr int depth_of_roots = 3;
  static constexpr int greatest_depth = 10;
  static constexpr std::size_t few = 6;

  struct Cell {
    Index first = 0;  ///< of its list, or of its four children
    Index count = 0;  ///< of its list; `divided`: it has children
  };
  static constexpr Index divided = ~Index{0};

  struct Square {
    int side = 0;
    int depth = 0;
    Index u = 0;  ///< of 2^depth
    Index v = 0;
  };

  void fill(std::span<const DirectionCone> cones, const Square& square, Index cell, std::vector<Index> list);
  void divide(std::span<const DirectionCone> cones, const Square& square, Index cell, const std::vector<Index>& list);

  std::vector<Index> roots_;
  std::vector<Cell> cells_;
  std::vector<Index> lists_;
};

}  // namespace toccata
