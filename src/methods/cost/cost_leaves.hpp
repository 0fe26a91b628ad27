#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "narrow/triangles/triangle_pair_block.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/methods/cost.hpp"
#include "toccata/shapes/primitives.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {

/// The number of operations that were repeated on purpose, and the time they took.
struct TimedOperations {
  std::size_t count = 0;
  double nanoseconds = 0;

  friend TimedOperations operator+(const TimedOperations& a, const TimedOperations& b) {
    return {a.count + b.count, a.nanoseconds + b.nanoseconds};
  }
  [[nodiscard]] double each() const { return count == 0 ? 0 : nanoseconds / static_cast<double>(count); }
};

/// The time of the work, by the clock of this thread.
[[nodiscard]] double nanoseconds_of(FunctionRef<void()> work);

/// The time of `work`, which makes `count` operations; what is too short for the clock is repeated.
[[nodiscard]] TimedOperations timed(std::size_t count, FunctionRef<void()> work);

/// The triangles of a mesh in the frame of its volumes, and how that frame lies in the world.
struct CostSide {
  std::span<const Triangle> triangles;
  Pose pose;

  [[nodiscard]] Triangle world(Index number) const;
};

/// The part of a question that no volume matters to: what happens to pairs of triangles.
class CostLeaves {
 public:
  CostLeaves(CostTask task, const CostSide& a, const CostSide& b);

  [[nodiscard]] CostTask task() const { return task_; }
  [[nodiscard]] double limit() const { return limit_; }
  void visit(std::span<const ItemPair> pairs);
  /// 0 or 1, a number of pairs, or the distance.
  [[nodiscard]] double answer() const;

  /// Repeats tests of the first pairs that were visited.
  [[nodiscard]] TimedOperations time_items();

 private:
  void look_at(std::span<const ItemPair> pairs);
  void bound_distances(std::span<const ItemPair> pairs);
  [[nodiscard]] bool meet(const ItemPair& pair) const { return overlap(a_.world(pair.first), b_.world(pair.second)); }

  CostTask task_;
  const CostSide& a_;
  const CostSide& b_;
  double limit_;
  std::size_t intersection_ = 0;
  std::vector<ItemPair> sample_;
  TrianglePairBlock block_{};
};

}  // namespace toccata
