// Compiled once for every SIMD level; Highway includes this file into itself.
#include "trees/wide_ray.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trees/wide_ray.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes before
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>

#include "trees/block_walk.hpp"
#include "trees/ray_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

/// What a line that can tell anything tells of the lanes of a block that it meets the boxes of.
RayLanes lanes_told(const RayLine& line, const WideBlock& block, const TriangleLanes& triangles, unsigned among) {
  RayLanes told;
  for (std::size_t part = 0; part < block_parts; ++part) {
    const std::size_t first = part * part_lanes;
    const auto a = line.corner(triangles, 0, first), b = line.corner(triangles, 1, first),
               c = line.corner(triangles, 2, first);
    const auto areas = line.areas(block, a, b, c, first);
    const unsigned kept = ~bits_of(Floats(), line.missed(areas)) & (among >> first) & part_mask;
    if (kept == 0) continue;
    const auto times = line.times(areas, a, b, c);
    const unsigned agree = bits_of(Floats(), times.agree) & kept;
    const unsigned beside =
        bits_of(Floats(), hn::Or(hn::Gt(times.lower, all<Float>(1)), hn::Lt(times.upper, all<Float>(0)))) & agree;
    const unsigned on_the_way =
        bits_of(Floats(), hn::And(hn::Gt(times.lower, all<Float>(0)), hn::Lt(times.upper, all<Float>(1)))) & agree;
    told.possible |= (kept & ~beside) << first;
    told.certain |= on_the_way << first;
    hn::StoreU(hn::IfThenElseZero(times.agree, times.lower), Floats(), told.lower.data() + first);
    hn::StoreU(times.upper, Floats(), told.upper.data() + first);
  }
  return told;
}

/// A search for the triangles that a ray may meet first.
class RaySearch {
 public:
  static constexpr ChildOrder child_order = ChildOrder::nearest_of_few;

  void start(const WideBvh& tree, const LeafTriangles* leaves, const WideRay& ray, std::size_t number,
             const VisitCandidates& visit) {
    tree_ = &tree;
    visit_ = &visit;
    number_ = number;
    late_ = ray.late + 0x1p-20F;
    limit_ = 1;
    candidate_count_ = 0;
    slabs_.set(ray);
    line_.set(ray, slabs_.pad());
    leaves_ = leaves != nullptr && line_.usable() ? leaves->of_block.data() : nullptr;
  }

  HWY_INLINE unsigned meet(const WideBlock& block, std::size_t first, LaneFloats& when) const {
    return slabs_.meet(block, first, limit_, when) & part_mask;
  }
  [[nodiscard]] HWY_INLINE bool wants(float when) const { return !(when > limit_ * of_times); }
  HWY_INLINE void prefetch(std::size_t number) const {
    if (leaves_ != nullptr) toccata::prefetch(leaves_[number]);
  }

  HWY_INLINE void see(std::size_t number, unsigned items, const LaneFloats& when) {
    if (candidate_count_ + WideBlock::width > candidates_.size()) show(false);
    const WideBlock& block = tree_->blocks[number];
    if (leaves_ == nullptr) return see_boxes(block, items, when);
    const TriangleLanes& triangles = leaves_[number];
    const RayLanes told = lanes_told(line_, block, triangles, items);
    for (unsigned left = told.possible; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const float lower = std::max(when[lane], told.lower[lane]);
      if (lower > limit_) continue;
      const bool certain = (told.certain >> lane & 1U) != 0;
      candidates_[candidate_count_++] = {lower, triangles.number[lane], certain};
      if (certain) limit_ = std::min(limit_, told.upper[lane] + late_);
    }
    // What is not certain is found out before more is searched for nothing.
    if (told.possible != told.certain) show(false);
  }

  void end() {
    if (candidate_count_ > 0) show(true);
  }

 private:
  /// Nothing is known but the boxes.
  void see_boxes(const WideBlock& block, unsigned items, const LaneFloats& when) {
    for (unsigned left = items; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      candidates_[candidate_count_++] = {when[lane], tree_->items[static_cast<std::size_t>(~block.child[lane])], false};
    }
    show(false);
  }

  /// Shows what is still of interest, the earliest first.
  void show(bool last_of_all) {
    const auto first = candidates_.begin();
    const auto last = std::remove_if(first, first + static_cast<std::ptrdiff_t>(candidate_count_),
                                     [&](const RayCandidate& one) { return one.lower > limit_; });
    if (last - first > 1)
      std::sort(first, last, [](const RayCandidate& a, const RayCandidate& b) { return a.lower < b.lower; });
    candidate_count_ = 0;
    if (first != last) limit_ = std::min(limit_, (*visit_)(number_, {first, last}, last_of_all));
  }

  const WideBvh* tree_;
  const VisitCandidates* visit_;
  const TriangleLanes* leaves_;
  std::size_t number_;
  RaySlabs slabs_;
  RayLine line_;
  float late_, limit_;
  std::size_t candidate_count_;
  std::array<RayCandidate, 3 * WideBlock::width> candidates_;
};

using RayWalk = BlockWalk<RaySearch>;

/// So many walk at a time: enough to wait for memory together, and few enough that their stacks stay near.
constexpr std::size_t rays_abreast = 12;

void run_rays(const WideBvh& tree, const LeafTriangles* leaves, std::span<const WideRay> rays, VisitCandidates visit) {
  if (rays.size() == 1) {
    RayWalk walk;
    walk.start(tree, tree, leaves, rays[0], std::size_t{0}, visit);
    walk.run();
    return walk.search().end();
  }
  const auto start = [&](RayWalk& walk, std::size_t, std::size_t i) {
    walk.start(tree, tree, leaves, rays[i], i, visit);
  };
  walk_abreast<RayWalk, rays_abreast>(rays.size(), start, [](RayWalk& walk, std::size_t) { walk.search().end(); });
}

RayLanes run_lanes(const WideRay& ray, const WideBlock& block, const TriangleLanes& triangles) {
  RaySlabs slabs;
  slabs.set(ray);
  RayLine line;
  line.set(ray, slabs.pad());
  const unsigned items = items_of(block) & lanes_in_use(block);
  if (line.usable()) return lanes_told(line, block, triangles, items);
  RayLanes nothing;
  nothing.possible = items;
  return nothing;
}

}  // namespace
}  // namespace toccata::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {
namespace {

HWY_EXPORT(run_rays);
HWY_EXPORT(run_lanes);

}  // namespace

void walk_rays(const WideBvh& tree, const LeafTriangles* leaves, std::span<const WideRay> rays, VisitCandidates visit) {
  if (!tree.blocks.empty()) HWY_DYNAMIC_DISPATCH(run_rays)(tree, leaves, rays, visit);
}

RayLanes ray_lanes(const WideRay& ray, const WideBlock& block, const TriangleLanes& triangles) {
  return HWY_DYNAMIC_DISPATCH(run_lanes)(ray, block, triangles);
}

}  // namespace toccata
#endif
