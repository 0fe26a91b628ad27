#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/bounds/ball.hpp"
#include "toccata/bounds/obb.hpp"
#include "toccata/core/index.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {

/// Which pairs are wanted: the same answer each time, from many threads at once.
using PairFilter = std::function<bool(const IndexPair&)>;

/// All pairs of boxes that overlap (touching counts), ascending, each once. Empty boxes (`Aabb{}`) overlap nothing.
/// Throws Error naming a box of which a side is no number, or has its lower end above the upper one.
[[nodiscard]] std::vector<IndexPair> overlapping_pairs(std::span<const Aabb> boxes);

/// The same by testing every pair: the oracle.
[[nodiscard]] std::vector<IndexPair> overlapping_pairs_by_brute_force(std::span<const Aabb> boxes);

/// Parts of space of one sort: the cells of one size, the boxes of one level of a tree, the intervals along an axis.
struct CellGroup {
  std::string name;    ///< for people: "cells of side 2", "level 3"
  int dimensions = 3;  ///< 1: intervals along an axis, 2: rectangles in a plane; infinite along the others
};

/// A part of space, in the world, in the unit of the boxes.
struct BroadPhaseCell {
  Aabb box;         ///< has infinite sides where it has no end; ends that the method keeps as floats are rounded so
  Index group = 0;  ///< the number of its group
};

/// The parts into which a method of the broad phase divided space to find pairs, for looking at them
/// (BroadPhase::cells).
struct BroadPhaseCells {
  std::vector<CellGroup> groups;      ///< from coarse to fine, where they are levels
  std::vector<BroadPhaseCell> cells;  ///< by group
};

/// How the pairs are looked for (docs/design/broad-phase.md describes each). All find the same pairs, to the bit.
enum class BroadPhaseMethod {
  automatic,          ///< by what the boxes are like
  brute_force,        ///< every pair, with vector instructions
  sort_and_sweep,     ///< sorted along one axis anew each time
  uniform_grid,       ///< cells of one size, about that of most boxes
  kd_tiles,           ///< space cut so that each part has as many boxes
  morton_tree,        ///< a tree over the boxes in the order of a space-filling curve, rebuilt each time
  packed_r_tree,      ///< a tree over tiles of sorted boxes, rebuilt each time
  r_tree,             ///< the same tree, kept, from which boxes that move are taken and put in elsewhere
  layers,             ///< what rests in a tree that is kept, movers against it and among themselves
  dynamic_tree,       ///< a tree of enlarged boxes, of which those that leave theirs are put in anew
  loose_octree,       ///< a box in the cell of its middle at the depth of its size
  incremental_sweep,  ///< ends kept sorted along three axes
  spatial_hash,       ///< cells of one size, by key
  hierarchical_hash,  ///< cells of many sizes, by key
  interval_sweeps,    ///< overlaps along each axis, each swept by itself, for few thousand boxes
  rectangle_sweeps,   ///< overlaps in two planes, each swept by itself, for few thousand boxes
};

/// "auto", "brute-force" …
[[nodiscard]] std::string_view name_of(BroadPhaseMethod method);

/// All of them, `automatic` first.
[[nodiscard]] std::span<const BroadPhaseMethod> broad_phase_methods();

/// Throws Error naming the closest when there is none of that name.
[[nodiscard]] BroadPhaseMethod broad_phase_method(std::string_view name);

struct BroadPhaseOptions {
  BroadPhaseMethod method = BroadPhaseMethod::automatic;
  int threads = own_thread;
  double hash_cell = 2;  ///< the side of the cells of `spatial_hash`, in usual boxes. Finite and positive, else Error
};

/// The box with its sides moved out by `margin` (not negative, in the box's unit), rounded outward: boxes grown by half
/// a distance each overlap wherever the boxes are that near along every axis. An empty box stays empty. Throws Error
/// where the margin is negative or no number.
[[nodiscard]] Aabb offset_outward(const Aabb& box, double margin);
/// The same of the radius, and of the half extents: all that is within the margin of it is inside.
[[nodiscard]] Ball offset_outward(const Ball& ball, double margin);
[[nodiscard]] Obb offset_outward(const Obb& box, double margin);

/// What a body may be bounded by.
using AnyBound = std::variant<Aabb, Ball, Obb>;

/// Whether two overlap, touching included, as the boxes around them and as they are themselves: boxes along the axes
/// and balls, also with each other, exactly; of oriented boxes false is proved, and true may also be said of two that
/// are apart by a rounding error. The same in either order. No number is NaN.
[[nodiscard]] bool bounds_overlap(const AnyBound& a, const AnyBound& b);

/// What an update has changed, both ascending. The pairs that persist are those of now without `begin`.
struct PairChanges {
  std::vector<IndexPair> begin;
  std::vector<IndexPair> end;
};

/// Boxes that move, and the pairs of them that overlap; touching counts. A body may be bounded by a ball or an oriented
/// box as well: methods compare the boxes around them, and of the pairs found those stay that overlap themselves
/// (`bounds_overlap`). So all methods find the same pairs then too.
///
/// Boxes have numbers that stay the same until they are removed. They are dense: the numbers of removed boxes are given
/// out again, the least first, but never before the next `update`, so that no pair of an update means two objects. A
/// box may have infinite sides; an empty one (`Aabb{}`) overlaps nothing; any other must have lower ≤ upper along every
/// axis, else Error names it, as it does a ball or an oriented box whose centre is not finite, or whose extent is NaN,
/// or whose axes are not as `Obb` says. What throws Error has changed nothing; where memory runs out in an update, give
/// the boxes to another.
///
/// Const functions may be called from many threads at once. A copy has the same boxes, pairs and changes.
class BroadPhase {
 public:
  explicit BroadPhase(const BroadPhaseOptions& options = {});
  BroadPhase(const BroadPhase& other);
  BroadPhase(BroadPhase&&) noexcept;
  BroadPhase& operator=(BroadPhase other) noexcept;
  ~BroadPhase();

  /// The numbers given to the boxes, in their order.
  std::vector<Index> add(std::span<const Aabb> boxes);
  std::vector<Index> add(std::span<const Ball> balls);
  std::vector<Index> add(std::span<const Obb> boxes);
  /// Throws Error naming a number that is in use no more, or given twice.
  void remove(std::span<const Index> numbers);
  /// Gives box `numbers[i]` the place `boxes[i]`; of several for one number the last counts. Throws Error naming a
  /// number that is not in use, and where the spans differ in length. What was a ball may become a box, and so on.
  void move(std::span<const Index> numbers, std::span<const Aabb> boxes);
  void move(std::span<const Index> numbers, std::span<const Ball> balls);
  void move(std::span<const Index> numbers, std::span<const Obb> boxes);

  /// Finds the pairs of the boxes as they are now: all of them, ascending, each once. The span is valid until the next
  /// update.
  std::span<const IndexPair> update();
  /// What the last update found.
  [[nodiscard]] std::span<const IndexPair> pairs() const;
  /// What the last update found that was not there at the one before, and the reverse.
  [[nodiscard]] PairChanges changes() const;

  /// How many numbers there are, those of removed boxes included: every number is less.
  [[nodiscard]] std::size_t size() const;
  /// Where the box is now, or that around a ball or an oriented box. Empty for a number that is not in use.
  [[nodiscard]] const Aabb& box(Index number) const;
  /// The bound as it was given.
  [[nodiscard]] AnyBound bound(Index number) const;
  [[nodiscard]] bool in_use(Index number) const;

  /// The method of the last update: never `automatic`.
  [[nodiscard]] BroadPhaseMethod method() const;
  /// Why that one, for people: "sizes span 3 decades, clustered: …". Empty where it was asked for.
  [[nodiscard]] std::string reason() const;
  /// The parts into which the method divided space in the last update, for looking at them: what it really used, no
  /// more. Nothing for methods that divide nothing, before the first update of boxes, of a copy until its first, and
  /// after an update in which `automatic` tried a method that it has given up since. What is too large for cells is in
  /// none. Throws Error where boxes have come, gone or moved since the update.
  [[nodiscard]] BroadPhaseCells cells() const;
  /// Memory of the boxes and of what the method keeps, without the pairs. Balls and oriented boxes are counted with the
  /// pairs of boxes around them, which they need besides.
  [[nodiscard]] std::size_t bytes() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// All pairs of boxes that overlap, as `overlapping_pairs(boxes)` finds them, by any method on any number of threads.
[[nodiscard]] std::vector<IndexPair> overlapping_pairs(std::span<const Aabb> boxes, const BroadPhaseOptions& options);

/// The same pairs, but only those that are wanted. Memory is that of the boxes and of the pairs that are wanted,
/// however many overlap. `wanted` is asked of every pair that overlaps, in any order: once of those that it refuses.
[[nodiscard]] std::vector<IndexPair> overlapping_pairs(std::span<const Aabb> boxes, const BroadPhaseOptions& options,
                                                       const PairFilter& wanted);

}  // namespace toccata
