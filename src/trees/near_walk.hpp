#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "toccata/math/mat3.hpp"
#include "toccata/trees/walk.hpp"
#include "trees/oriented_boxes.hpp"

namespace toccata {

/// How boxes of the other tree are seen from one ("its own"): constants of a query. Where both meshes are placed by
/// rotations, mirrored or not, and uniform scales, in the own tree's units and frame: an own point q stays where it is,
/// and a point p of the other one is at offset + ratio · rotation · p.
struct NearView {
  bool rigid = true;
  Mat3 rotation;     ///< orthonormal up to 2⁻³⁸
  double ratio = 1;  ///< what a length of 1 of the other tree is in the own one
  Vec3 offset;
  double scale = 1;  ///< what a length of 1 of these units is in those of `NearQuestion::limit`; NaN: nothing is known
  double pad = 0;    ///< in these units, more than all that is not exact can change a distance by
  /// Where not rigid: what brings own points and, but for the offset, other points into one common frame.
  Mat3 own;
  Mat3 other;
};

/// A question about what is nearest, for a walk over two trees.
class NearQuestion {
 public:
  /// The largest distance that still matters; −1 ends the walk. It may only shrink.
  [[nodiscard]] virtual double limit() const = 0;
  virtual void visit(std::span<const ItemPair> pairs) = 0;

 protected:
  ~NearQuestion() = default;
};

/// The scratch memory of a walk: pairs that are still to be looked at, by their bounds. It grows as needed and keeps
/// its size.
struct NearFrontier {
  static constexpr std::size_t bucket_count = 256;
  static constexpr std::size_t run_length = 21;
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  struct Entry {
    std::uint32_t first;   ///< block · 2 + which tree it is of; of two items, the place of the first tree's
    std::uint32_t second;  ///< box of the other tree: block · 8 + lane; of two items, the place of the second's
    float bound;           ///< as a part of the first limit
  };
  /// Some entries of a bucket. A list of single ones would wait for memory at each.
  struct Run {
    std::array<Entry, run_length> entries;
    std::uint32_t below;  ///< the run that comes when this one is empty, or the next free one
  };
  /// A stack of entries, whose last run is not empty.
  struct Bucket {
    std::uint32_t run = none;
    std::uint32_t count = 0;  ///< entries in the last run

    [[nodiscard]] bool empty() const { return run == none; }
  };
  std::vector<Run> runs;
  std::uint32_t free = none;
  std::array<Bucket, bucket_count> boxes;  ///< of two boxes
  std::array<Bucket, bucket_count> items;  ///< of two items
  std::vector<ItemPair> pairs;
  WalkCounts counts;

  void clear();
  void push(Bucket& bucket, const Entry& entry);
  Entry pop(Bucket& bucket);
  [[nodiscard]] const Entry& top(const Bucket& bucket) const { return runs[bucket.run].entries[bucket.count - 1]; }

 private:
  void add_run(Bucket& bucket);
};

/// One of two trees: boxes, and the items at their places.
struct NearBvh {
  std::span<const OrientedBlock> blocks;
  std::span<const Index> items;

  // Where the items are triangles of a mesh: they, and what brings their corners into the tree's units.
  const TriangleMesh* mesh = nullptr;
  Vec3 origin{};
  double unit = 1;
};

/// How far the boxes of a block are from a box of the other tree.
struct NearBounds {
  std::array<double, OrientedBlock::width> least;  ///< of lanes that are used: lower bounds, in the units of the limit
  double other_size;                               ///< of the other box: the sum of its extents, in the block's units
};

/// A walk over pairs of boxes of two trees, nearest first: pairs wait in buckets by their bounds, which are as good as
/// a sorted queue and cost nothing (R. Dial, "Algorithm 360: shortest-path forest with topological ordering", 1969).
/// Same pairs, same order and same counts at every SIMD level.
class NearWalk {
 public:
  /// `view_of_a` sees boxes of b from a.
  NearWalk(const NearBvh& a, const NearBvh& b, const NearView& view_of_a, const NearView& view_of_b)
      : trees_{a, b}, views_{view_of_a, view_of_b} {}

  /// Shows the question every pair of items whose distance may be below its limit. Neither tree is empty.
  void run(NearFrontier& frontier, NearQuestion& question) const;

  /// For one block of the tree `side` and one box of the other: block · 8 + lane.
  [[nodiscard]] NearBounds bounds(std::size_t side, std::uint32_t number, std::uint32_t other) const;

  [[nodiscard]] const NearBvh& tree(std::size_t side) const { return trees_[side]; }
  [[nodiscard]] const NearView& view(std::size_t side) const { return views_[side]; }

 private:
  std::array<NearBvh, 2> trees_;
  std::array<NearView, 2> views_;
};

}  // namespace toccata
