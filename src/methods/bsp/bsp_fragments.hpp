#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "methods/bsp/bsp_planes.hpp"

namespace toccata {

/// A line in the plane of a triangle: 0, 1 or 2, its edge from that corner to the next; from 3 on, where the plane of
/// that number less 3 cuts it.
using BspLine = Index;

[[nodiscard]] constexpr bool is_edge(BspLine line) { return line < 3; }
[[nodiscard]] constexpr BspLine cut_line(BspPlane plane) { return plane + 3; }

/// A corner of a fragment. Exactly, it is where two lines in the triangle's plane meet; `place` is about there.
struct BspCorner {
  Vec3 place;        ///< local
  double error = 0;  ///< no coordinate of `place` is off by more, beside the 2^-53 of a vertex
  std::array<BspLine, 2> on{};
  BspLine next = 0;             ///< the line of the edge to the next corner
  bool on_border = false;       ///< it lies in a plane that has cut space around the cell, not within it
  bool next_on_border = false;  ///< all of the edge to the next corner does
};

/// What planes have left of a triangle: a convex polygon, whose corners lie in a pool. What lies in a plane with which
/// the triangle has less in common is a segment between two corners, or one corner.
struct PooledFragment {
  Index triangle = 0;
  Index first = 0;
  Index count = 0;
};

/// A corner beside a plane.
struct CornerHeight {
  Sign sign = Sign::zero;  ///< exact
  double value = 0;        ///< rounded
  double error = 0;
};

/// The parts of a fragment; the count is 0 where there is none.
struct SplitFragment {
  PooledFragment front;
  PooledFragment back;
  PooledFragment within;  ///< what of it lies in the plane, unless that is on the border of the cell
};

/// Fragments and their corners, in a stack: those of a cell are forgotten when all within it has been done.
class BspFragments {
 public:
  explicit BspFragments(const BspPlanes& planes, const BspFrame& frame);

  [[nodiscard]] PooledFragment whole(Index triangle);

  /// Exact. What lies on one side as a whole, or in the plane, is that part itself.
  [[nodiscard]] SplitFragment split(const PooledFragment& fragment, BspPlane plane, const RoundedBspPlane& rounded);

  /// Whether three planes have one point in common and no more. Exact.
  [[nodiscard]] bool meet_in_a_point(BspPlane p, BspPlane q, BspPlane r) {
    return arithmetic_.where_meet(p, q, r).weight != 0;
  }

  [[nodiscard]] const BspCorner& corner(const PooledFragment& fragment, std::size_t i) const {
    return pool_[fragment.first + i];
  }

  [[nodiscard]] std::size_t mark() const { return pool_.size(); }
  void forget_after(std::size_t mark) { pool_.resize(mark); }

 private:
  [[nodiscard]] CornerHeight height(Index triangle, const BspCorner& corner, BspPlane plane,
                                    const RoundedBspPlane& rounded);
  [[nodiscard]] Sign exact_side(Index triangle, const BspCorner& corner, BspPlane plane);
  [[nodiscard]] Sign side_of_edge_point(Index triangle, BspLine edge, BspPlane cut, BspPlane plane);
  [[nodiscard]] IntegerPoint exact_point(Index triangle, const BspCorner& corner);
  [[nodiscard]] BspCorner crossing(const PooledFragment& fragment, std::size_t i, BspPlane plane);
  void place_exactly(Index triangle, BspCorner& corner);
  [[nodiscard]] PooledFragment part(const PooledFragment& fragment, Sign side, BspPlane plane);
  [[nodiscard]] PooledFragment within(const PooledFragment& fragment, BspPlane plane);
  void put_on_border(const PooledFragment& fragment);
  [[nodiscard]] Sign next_sign(const PooledFragment& fragment, std::size_t i) const;
  [[nodiscard]] bool is_edge_in_plane(const PooledFragment& fragment, std::size_t i) const;

  const BspPlanes& planes_;
  const BspFrame& frame_;
  BspArithmetic arithmetic_;
  std::vector<BspCorner> pool_;
  std::vector<CornerHeight> heights_;  ///< of the fragment that is being split
  std::vector<BspCorner> crossings_;   ///< of its edges, where the plane crosses them
};

}  // namespace toccata
