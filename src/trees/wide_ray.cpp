// Compiled once for every SIMD level; Highway includes this file into itself.
#include "trees/wide_ray.hpp"

#include "trees/pending_stack.hpp"

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

#include "trees/ray_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

constexpr std::size_t lane_count = hn::MaxLanes(Floats()), parts = WideBlock::width / lane_count;
constexpr unsigned part_mask = (1U << lane_count) - 1U;

/// The places of the lanes that are items, as bits.
HWY_INLINE unsigned items_of(const WideBlock& block) {
  const hn::CappedTag<std::int32_t, WideBlock::width> d;
  const hn::RebindToFloat<decltype(d)> f;
  unsigned items = 0;
  for (std::size_t part = 0; part < parts; ++part) {
    const auto child = hn::Load(d, block.child.data() + part * lane_count);
    items |= bits_of(hn::MaskFromVec(hn::BitCast(f, hn::BroadcastSignBit(child)))) << part * lane_count;
  }
  return items;
}

/// What a line that can tell anything tells of the lanes of a block that it meets the boxes of.
RayLanes lanes_told(const RayLine& line, const WideBlock& block, const TriangleLanes& triangles, unsigned among) {
  RayLanes told;
  for (std::size_t part = 0; part < parts; ++part) {
    const std::size_t first = part * lane_count;
    const auto a = line.corner(triangles, 0, first), b = line.corner(triangles, 1, first),
               c = line.corner(triangles, 2, first);
    const auto areas = line.areas(block, a, b, c, first);
    const unsigned kept = ~bits_of(line.missed(areas)) & (among >> first) & part_mask;
    if (kept == 0) continue;
    const auto times = line.times(areas, a, b, c);
    const unsigned agree = bits_of(times.agree) & kept;
    const unsigned beside = bits_of(hn::Or(hn::Gt(times.lower, all(1)), hn::Lt(times.upper, all(0)))) & agree;
    const unsigned on_the_way = bits_of(hn::And(hn::Gt(times.lower, all(0)), hn::Lt(times.upper, all(1)))) & agree;
    told.possible |= (kept & ~beside) << first;
    told.certain |= on_the_way << first;
    hn::StoreU(hn::IfThenElseZero(times.agree, times.lower), Floats(), told.lower.data() + first);
    hn::StoreU(times.upper, Floats(), told.upper.data() + first);
  }
  return told;
}

/// A ray on its way through a tree.
class RayWalk {
 public:
  void start(const WideTree& tree, const LeafTriangles* leaves, const WideRay& ray, std::size_t number) {
    tree_ = &tree;
    slabs_.set(ray);
    line_.set(ray, slabs_.pad());
    leaves_ = leaves != nullptr && line_.usable() ? leaves->of_block.data() : nullptr;
    number_ = number;
    late_ = ray.late + 0x1p-20F;
    limit_ = 1;
    child_ = 0;
    candidate_count_ = 0;
  }

  /// Opens a block; false when there is nothing more.
  HWY_INLINE bool step(const VisitCandidates& visit) {
    if (open(static_cast<std::size_t>(child_), visit) || next()) return true;
    if (candidate_count_ > 0) show(visit);
    return false;
  }

 private:
  /// The earliest inner child that is met becomes the next; the others wait. False where none is met.
  HWY_INLINE bool open(std::size_t number, const VisitCandidates& visit) {
    const WideBlock& block = tree_->blocks[number];
    alignas(64) LaneFloats when;
    unsigned met = 0;
    for (std::size_t part = 0; part < parts; ++part)
      met |= (slabs_.meet(block, part * lane_count, limit_, when) & part_mask) << part * lane_count;
    met &= (1U << block.count) - 1U;
    const unsigned items = items_of(block) & met, inner = met & ~items;
    if (items != 0) see(number, items, when, visit);
    return inner != 0 && go_on(block, inner, when);
  }

  /// The triangles in some lanes of a block.
  HWY_INLINE void see(std::size_t number, unsigned items, const LaneFloats& when, const VisitCandidates& visit) {
    if (candidate_count_ + WideBlock::width > candidates_.size()) show(visit);
    const WideBlock& block = tree_->blocks[number];
    if (leaves_ == nullptr) {
      for (; items != 0; items &= items - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(items));
        add({when[lane], tree_->items[static_cast<std::size_t>(~block.child[lane])]});
      }
      return show(visit);
    }
    const TriangleLanes& triangles = leaves_[number];
    const RayLanes told = lanes_told(line_, block, triangles, items);
    for (unsigned left = told.possible; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const float lower = std::max(when[lane], told.lower[lane]);
      if (lower > limit_) continue;
      add({lower, triangles.number[lane]});
      if ((told.certain >> lane & 1U) != 0) limit_ = std::min(limit_, told.upper[lane] + late_);
    }
    // What is not certain is found out before more is searched for nothing.
    if (told.possible != told.certain) show(visit);
  }

  void add(const RayCandidate& candidate) { candidates_[candidate_count_++] = candidate; }

  /// Shows what is still of interest, the earliest first.
  void show(const VisitCandidates& visit) {
    const auto first = candidates_.begin();
    const auto last = std::remove_if(first, first + static_cast<std::ptrdiff_t>(candidate_count_),
                                     [&](const RayCandidate& one) { return one.lower > limit_; });
    if (last - first > 1)
      std::sort(first, last, [](const RayCandidate& a, const RayCandidate& b) { return a.lower < b.lower; });
    candidate_count_ = 0;
    if (first != last) limit_ = std::min(limit_, visit(number_, {first, last}));
  }

  HWY_INLINE bool go_on(const WideBlock& block, unsigned inner, const LaneFloats& when) {
    const auto first = static_cast<std::size_t>(std::countr_zero(inner));
    inner &= inner - 1;
    if (inner == 0) {
      child_ = block.child[first];
      return !(when[first] > limit_ * of_times);
    }
    pending_.make_room();
    prefetch(block.child[first]);
    pending_.insert({when[first], block.child[first]}, 0);
    for (std::size_t count = 1; inner != 0; inner &= inner - 1, ++count) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(inner));
      prefetch(block.child[lane]);
      pending_.insert({when[lane], block.child[lane]}, count);
    }
    return false;
  }

  /// Asks for the memory of a block before its turn comes.
  HWY_INLINE void prefetch(std::int32_t child) const {
    const auto* bytes = reinterpret_cast<const char*>(&tree_->blocks[static_cast<std::size_t>(child)]);
    for (std::size_t line = 0; line < sizeof(WideBlock); line += 64) __builtin_prefetch(bytes + line);
  }

  /// The next that waits and is still of interest.
  bool next() {
    while (!pending_.empty()) {
      const Pending one = pending_.pop();
      child_ = one.child;
      if (!(one.when > limit_ * of_times)) return true;
    }
    return false;
  }

  const WideTree* tree_;
  const TriangleLanes* leaves_;
  std::size_t number_;
  RaySlabs slabs_;
  RayLine line_;
  float late_, limit_;
  std::int32_t child_;
  std::size_t candidate_count_;
  std::array<RayCandidate, 3 * WideBlock::width> candidates_;
  PendingStack pending_;
};

/// So many walk at a time: enough to wait for memory together, and few enough that their stacks stay near.
constexpr std::size_t abreast = 4;

/// Rays that walk side by side, the next one in the place of one that is done.
void run_rays(const WideTree& tree, const LeafTriangles* leaves, std::span<const WideRay> rays, VisitCandidates visit) {
  std::array<RayWalk, abreast> walks;
  std::array<RayWalk*, abreast> walking;
  std::size_t next = 0, count = 0;
  for (; count < abreast && next < rays.size(); ++next, ++count) {
    walking[count] = &walks[count];
    walks[count].start(tree, leaves, rays[next], next);
  }
  while (count > 0)
    for (std::size_t i = 0; i < count; ++i) {
      if (walking[i]->step(visit)) continue;
      if (next < rays.size()) {
        walking[i]->start(tree, leaves, rays[next], next);
        ++next;
      } else {
        walking[i--] = walking[--count];
      }
    }
}

RayLanes run_lanes(const WideRay& ray, const WideBlock& block, const TriangleLanes& triangles) {
  RaySlabs slabs;
  slabs.set(ray);
  RayLine line;
  line.set(ray, slabs.pad());
  const unsigned items = items_of(block) & ((1U << block.count) - 1U);
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

void walk_rays(const WideTree& tree, const LeafTriangles* leaves, std::span<const WideRay> rays,
               VisitCandidates visit) {
  if (!tree.blocks.empty()) HWY_DYNAMIC_DISPATCH(run_rays)(tree, leaves, rays, visit);
}

RayLanes ray_lanes(const WideRay& ray, const WideBlock& block, const TriangleLanes& triangles) {
  return HWY_DYNAMIC_DISPATCH(run_lanes)(ray, block, triangles);
}

}  // namespace toccata
#endif
