#pragma once

#include <functional>
#include <span>
#include <vector>

#include "query/relation/relation_segments.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/trees/bvh.hpp"

namespace toccata {

/// Segments in the plane, found by where they lie. They are kept in boxes that are turned to the direction most of
/// their length has: then long parallel segments, and those at right angles to them, are not in each other's boxes.
class SegmentIndex {
 public:
  explicit SegmentIndex(std::span<const PlanarSegment> segments);

  /// Contains the segment between two points: turned coordinates, and as a third the x, so that what lies beside a
  /// vertical line is told from what meets it.
  [[nodiscard]] Aabb box_around(const Interval& x0, const Interval& y0, const Interval& x1, const Interval& y1) const;
  [[nodiscard]] Aabb box_around(const PlanarSegment& s) const;

  /// Calls `see(i)` for every segment i whose box meets `region`, a box of box_around that `see` may shrink, in no
  /// particular but always the same order. Those that meet only what was shrunk away may be left out.
  void visit_in(const Aabb& region, const std::function<void(Index)>& see) const;

 private:
  double cosine_ = 1;  ///< of the turn, rounded: any two numbers would do
  double sine_ = 0;
  std::vector<Aabb> boxes_;
  Bvh<Aabb> tree_;
};

}  // namespace toccata
