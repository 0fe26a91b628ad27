#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "methods/bsp/bsp_parts.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/narrow/posed_polytope.hpp"

namespace toccata {

/// Where a sweep has come to, and during which part of the way it may be there: fractions of the part within the box
/// of the mesh.
struct BspStretch {
  BspChild at = 0;
  BspChild entered = -1;  ///< the node across whose plane it begins; none where it begins with the way
  double from = 0;
  double to = 1;

  [[nodiscard]] bool is_empty() const { return from > to; }
};

/// A local half-space, rounded: of a place q not beyond the box of the mesh, normal · q − offset is off by `bound` at
/// most. The slope is at least the sum of the normal's magnitudes, and of those of what it was summed up from.
struct BspSide {
  Vec3 normal;
  double offset = 0;
  double bound = 0;
  double slope = 0;
};

[[nodiscard]] inline BspSide side_of(const FloatBspPlane& plane) {
  const Vec3 normal = as_doubles(plane.normal);
  return {normal, plane.offset, plane.bound, sum_of_magnitudes(normal)};
}

/// The heights of a shape that moves above a plane: of its middle where they begin and how they go on, how far the
/// shape reaches down and up from there, and what all of this is off by.
struct BspHeights {
  double start = 0;
  double rise = 0;
  double low = 0;
  double high = 0;
  double error = 0;

  /// The side on which all of the shape certainly is during the stretch; zero where that is not certain, as for NaN.
  [[nodiscard]] Sign side(const BspStretch& s) const {
    const double first = start + s.from * rise, last = start + s.to * rise;
    const double above = error - low, below = -error - high;
    if (first > above && last > above) return Sign::positive;
    return first < below && last < below ? Sign::negative : Sign::zero;
  }
  // The part of the stretch in which some of the shape may lie there, or on the plane.
  [[nodiscard]] BspStretch in_front(const BspStretch& s) const { return cut(s, -high - start, rise > 0); }
  [[nodiscard]] BspStretch behind(const BspStretch& s) const { return cut(s, -low - start, rise < 0); }

 private:
  /// Where the exact height of the shape's lowest or highest point is 0, the computed one is within the error, so this
  /// is no farther from where the computed one is 0 than the error over the rise. The error is 2^-20 of the slope times
  /// `reach_` at least, and the rise no more than twice that: so as much again is more than any roundings here. As a
  /// share of the whole motion it is 3 · 2^-49 at least, as the error is at least three times the slope times `off_`
  /// (bsp_sweep.cpp). So beginnings are early by 48 roundings of the time, which leaves enough for those of
  /// `time_before`.
  [[nodiscard]] BspStretch cut(BspStretch stretch, double risen, bool begins) const {
    const double per_rise = 1 / rise, crossing = risen * per_rise, off = 2 * std::fabs(error * per_rise);
    if (!(off < 1 && std::fabs(crossing) < 2)) return stretch;  // so for NaN
    if (begins)
      stretch.from = std::max(stretch.from, crossing - off);
    else
      stretch.to = std::min(stretch.to, crossing + off);
    return stretch;
  }
};

/// Takes a convex shape that moves straight on, or stands, through the cells of a tree: a ray, a segment, a shape with
/// a radius. Planes are moved out by how far the shape reaches, so it is a point that goes from cell to cell in their
/// order. When it passes a plane is known to within an interval, and both sides have all of the stretch that may be
/// there: so nothing is missed, and who asks decides triangles exactly.
class BspSweep {
 public:
  BspSweep(const BspTree::Parts& parts, const Vec3& point, const Vec3& motion);
  BspSweep(const BspTree::Parts& parts, const PosedPolytope& shape, const Vec3& motion);

  /// Is told each triangle of which a fragment lies in a plane that is met, some several times, with the stretch during
  /// which it may be met; answers from which time on none is of interest.
  using Meet = FunctionRef<double(Index triangle, const BspStretch& in_plane)>;
  void run(Meet meet);
  /// Is told each cell within the solid that may be entered; answers likewise.
  using Enter = FunctionRef<double(const BspStretch& in_cell)>;
  void run_through_cells(Enter enter);

  /// Whether the triangle is so near the way during the stretch that it may be met, by boxes.
  [[nodiscard]] bool may_meet(const Triangle& triangle, const BspStretch& stretch) const;

  /// A time that is not later than anything in the stretch: the fraction's place between both ends. It needs no slack
  /// for its few roundings: `enters_` is early, and so is every beginning that is a fraction above 0 (BspHeights::cut).
  [[nodiscard]] double time_before(const BspStretch& stretch) const {
    return enters_ + stretch.from * (leaves_ - enters_);
  }

  [[nodiscard]] BspHeights heights(const BspSide& side) const;

  /// Unit, against the motion, across what the stretch begins; zero where that is before the start.
  [[nodiscard]] Vec3 entered_across(const BspStretch& stretch) const;
  /// The same across a plane of this normal, which is no unit one.
  [[nodiscard]] Vec3 against_motion(const Vec3& normal) const;

  /// The planes around the cell that is being entered, from the root on: within it all heights are 0 or less.
  [[nodiscard]] std::vector<BspSide> sides_of_cell() const;

 private:
  /// Points are asked for so often that nothing is computed for them which is 0.
  enum class Extent { point, shape };
  /// A step from a node to a child.
  struct Step {
    BspChild node = 0;
    bool to_front = false;
  };
  struct Waiting {
    BspStretch stretch;
    Index depth = 0;  ///< steps from the root
    Step last;
  };

  void pose(std::span<const Vec3> points, const Aabb& box, double radius);
  void clip_to_box(const Aabb& box);
  void run(Meet meet, Enter enter);
  template <Extent extent>
  void pass_all(Meet meet, Enter enter);
  template <Extent extent>
  void pass(const Waiting& waiting, Meet meet, Enter enter);
  template <Extent extent>
  [[nodiscard]] BspHeights heights_for(const BspSide& side, const BspStretch& stretch) const;
  template <Extent extent>
  [[nodiscard]] BspStretch pass_on_both_sides(const BspStretch& stretch, const BspHeights& along, Meet meet);
  void follow(const Step& step) {
    if (!path_.empty()) path_[depth_] = step;
    ++depth_;
  }
  [[nodiscard]] bool is_of_interest(const BspStretch& stretch) const {
    return !stretch.is_empty() && !(time_before(stretch) > latest_);
  }
  [[nodiscard]] BspHeights heights_of_middle(const BspSide& side) const;
  /// The heights by the box around the shape.
  [[nodiscard]] BspHeights rough_heights(const BspSide& side) const;

  const BspTree::Parts& parts_;
  Vec3 motion_;
  double latest_ = 1;  ///< of the times of interest
  double enters_ = 0;  ///< the times between which the shape may be within the box
  double leaves_ = 1;
  Vec3 entered_;  ///< the normal of the box's side through which it enters; zero if it is within from the start
  Vec3 start_;    ///< local, of the shape's middle, where it enters
  Vec3 way_;      ///< from there to where it leaves
  Vec3 half_;     ///< of the box around the shape's points, local
  std::vector<Vec3> points_;  ///< from the middle; none for a single point
  double radius_ = 0;         ///< local
  double reach_ = 1;          ///< no coordinate of the shape is greater while it is within the box
  double off_ = 0;            ///< what any local coordinate of anything here is off by at most
  std::vector<Waiting> waiting_;
  std::vector<Step> path_;  ///< to where it is; kept for cells alone
  Index depth_ = 0;         ///< how many steps that is
};

}  // namespace toccata
