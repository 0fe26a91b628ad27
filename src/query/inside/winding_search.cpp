#include "query/inside/winding_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/vec3_measures.hpp"
#include "narrow/triangles/solid_angle.hpp"
#include "query/inside/bounded_sum.hpp"
#include "query/meshes/cull_bounds.hpp"

// The names and bounds are those of docs/methods/winding-numbers.md.
namespace toccata {
namespace {

constexpr WindingPart too_near{0, HUGE_VAL};

bool is_better(const WindingEntry& a, const WindingEntry& b) {
  return a.bound != b.bound ? a.bound < b.bound : a.block < b.block;
}

Vec3 product(const Mat3& m, const Vec3& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

double determinant(const Mat3& m) { return dot(m[0], cross(m[1], m[2])); }

/// How far Rᵀ R / s² is from 1, as the root of the sum of squares, for the s that it is nearest to.
struct Similarity {
  double squared_scale = 0;
  double defect = HUGE_VAL;
};

Similarity similarity(const Mat3& linear) {
  Similarity result;
  for (int i = 0; i < 3; ++i) result.squared_scale += dot(linear.column(i), linear.column(i)) / 3;
  if (!(result.squared_scale > 0x1p-400) || !(result.squared_scale < 0x1p400)) return result;
  double squares = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double entry = dot(linear.column(i), linear.column(j)) / result.squared_scale - (i == j ? 1 : 0);
      squares += entry * entry;
    }
  result.defect = std::sqrt(squares) + 0x1p-46;
  return result;
}

}  // namespace

struct WindingSearch::Seen {
  Vec3 point;           ///< in the world
  Vec3 in_tree;         ///< about the same point
  double off;           ///< of all that is told in the tree's units
  BoundedSum near{};    ///< the triangles that were asked
  WindingEntries& far;  ///< the blocks that were not opened: a heap, that of the greatest bound first
  double far_value = 0;
  double far_bound = 0;
  bool by_moments = false;

  void keep(const WindingEntry& entry) {
    far.push_back(entry);
    std::push_heap(far.begin(), far.end(), is_better);
    far_value += entry.value;
    far_bound += entry.bound;
  }

  WindingEntry take_worst() {
    std::pop_heap(far.begin(), far.end(), is_better);
    const WindingEntry worst = far.back();
    far.pop_back();
    far_value -= worst.value;
    far_bound -= worst.bound;
    return worst;
  }

  /// The sum of all, added anew.
  BoundedSum sum() {
    BoundedSum blocks, all = near;
    for (const WindingEntry& entry : far) blocks.add(entry.value, entry.bound);
    far_value = blocks.value();
    far_bound = blocks.rounded_bound();
    all.add(blocks.value(), blocks.bound());
    return all;
  }
};

WindingSearch::WindingSearch(const PosedMesh& mesh)
    : mesh_(mesh), tree_(mesh.model().wide_bvh()), moments_(mesh.model().winding_moments()) {
  const Pose& pose = mesh.pose();
  const Similarity shape = similarity(pose.linear);
  if (!(shape.defect < 0x1p-30)) return;
  const double scale = std::sqrt(shape.squared_scale), unit = tree_.unit;
  if (!(scale * unit > 0x1p-400) || !(scale * unit < 0x1p400)) return;
  for (int i = 0; i < 3; ++i) back_[i] = (1 / (shape.squared_scale * unit)) * pose.linear.column(i);
  world_middle_ = transform(pose, tree_.origin);
  turned_ = determinant(pose.linear) < 0 ? -1 : 1;
  const double world = plain_length(world_sizes(mesh)) + plain_length(world_middle_);
  off_by_distance_ = 2 * (shape.defect + 0x1p-49) / (scale * unit);
  off_ = 2 * (0x1p-49 * world / (scale * unit) + 8 * shape.defect + 0x1p-49);
  rigid_ = is_finite(back_) && is_finite(world_middle_) && off_ < 1;
}

void WindingSearch::open(std::size_t block, Seen& seen) const {
  const WideBlock& lanes = tree_.blocks[block];
  for (std::size_t lane = 0; lane < lanes.count; ++lane) {
    if (lanes.is_item(lane)) {
      const Index item = tree_.items[lanes.item_place(lane)];
      const SolidAngle angle = solid_angle(seen.point, mesh_.triangle(item));
      seen.near.add(angle.value, angle.bound);
      continue;
    }
    const auto child = static_cast<std::size_t>(lanes.child[lane]);
    const WindingPart part = seen.by_moments ? winding_part(moments_[child], seen.in_tree, seen.off) : too_near;
    if (part.bound < HUGE_VAL)
      seen.keep({turned_ * part.value, part.bound, child});
    else
      open(child, seen);
  }
}

template <class Done>
WindingNumber WindingSearch::search(const Vec3& point, WindingEntries& memory, const Done& done) const {
  const Vec3 way = point - world_middle_;
  memory.clear();
  Seen seen{.point = point,
            .in_tree = product(back_, way),
            .off = off_ + off_by_distance_ * plain_length(way),
            .far = memory};
  seen.by_moments = rigid_ && plain_length(seen.in_tree) < 0x1p60 && seen.off < HUGE_VAL;
  open(0, seen);
  for (;;) {
    // What was added and taken away again rounds: before it counts, all is added anew.
    if (seen.far.empty() || done(seen.near.value() + seen.far_value, seen.near.rounded_bound() + seen.far_bound)) {
      const BoundedSum all = seen.sum();
      const double value = all.value(), bound = all.bound() + unit_roundoff * std::abs(value);
      if (seen.far.empty() || done(value, bound))
        return {value, value - bound, value + bound, done(value, bound) ? Status::exact : Status::not_converged};
    }
    open(seen.take_worst().block, seen);
  }
}

WindingNumber WindingSearch::at(const Vec3& point, double tolerance, WindingEntries& memory) const {
  return search(point, memory, [tolerance](double, double bound) { return bound <= tolerance; });
}

WindingNumber WindingSearch::beside_a_half(const Vec3& point, WindingEntries& memory) const {
  constexpr double least = 1e-12;
  return search(point, memory, [](double value, double bound) {
    return bound <= least || std::abs(std::abs(value) - 0.5) > 1.001 * bound + 0x1p-50;
  });
}

}  // namespace toccata
