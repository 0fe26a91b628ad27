#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/core/index.hpp"
#include "toccata/math/vec3.hpp"
#include "toccata/trees/bvh.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

/// Boxes in a tree over them, asked for those that a box overlaps or nears, still or moving. Boxes are named by their
/// numbers, 0 … size − 1. They may have infinite sides; none of their coordinates is NaN. An empty box (`Aabb{}`) is
/// never found. Answers depend on the boxes alone, and not on how they came to be where they are. Questions may be
/// asked from many threads at once.
class BoxBvh {
 public:
  BoxBvh() = default;
  explicit BoxBvh(std::span<const Aabb> boxes) { update(boxes); }

  /// The boxes as they are now; they are copied. The tree is kept, and its nodes are put around boxes that have moved:
  /// it is built anew where they have doubled (in the mean of logarithms), or where many boxes are new.
  void update(std::span<const Aabb> boxes);

  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  [[nodiscard]] const Aabb& box(Index number) const { return boxes_[number]; }

  /// Called with the number of a box; false ends the search.
  using See = FunctionRef<bool(Index)>;
  /// All boxes that the box overlaps (touching counts), in any order.
  void visit_overlapping(const Aabb& box, See see) const;

  /// The same, ascending.
  [[nodiscard]] std::vector<Index> overlapping(const Aabb& box) const;

  /// Called with the number of a box, and returns the greatest cost that is still of interest: so far as it is less
  /// than before, it counts.
  using SeeNear = FunctionRef<double(Index)>;

  /// The boxes in the order of their distances from a box, which is not empty. Those whose distance, rounded down, is
  /// at most the limit as it is at the end are seen, and no others.
  void visit_nearest(const Aabb& from, double limit, SeeNear see) const;

  /// The boxes that a box meets on its way, which is not empty and moves by t · motion, in the order of t, rounded
  /// down. A ray is a point that moves. Those met by t = limit, at most 1, as it is at the end are seen, and no others
  /// but for rounding. The motion is finite.
  void visit_along(const Aabb& moving, const Vec3& motion, double limit, SeeNear see) const;

  /// Memory of the boxes and the tree.
  [[nodiscard]] std::size_t bytes() const;

 private:
  void build();
  void sort_out();
  void refit();
  [[nodiscard]] double mean_octave() const;
  template <class Question>
  void walk_by(Question& question) const;

  std::vector<Aabb> boxes_;
  Bvh<Aabb> tree_;              ///< one box in each leaf
  double built_octave_ = 0;     ///< `mean_octave` when it was built
  std::vector<bool> in_tree_;   ///< by number
  std::vector<Index> outside_;  ///< boxes that are not in the tree: those without end, and new ones
};

}  // namespace toccata
