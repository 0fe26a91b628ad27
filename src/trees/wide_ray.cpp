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

#include "trees/block_lanes.hpp"
#include "trees/ray_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

/// The places of the lanes that are items, as bits.
HWY_INLINE unsigned items_of(const WideBlock& block) {
  const hn::CappedTag<std::int32_t, WideBlock::width> d;
  const hn::RebindToFloat<decltype(d)> f;
  unsigned items = 0;
  for (std::size_t part = 0; part < block_parts; ++part) {
    const auto child = hn::Load(d, block.child.data() + part * part_lanes);
    items |= bits_of(f, hn::MaskFromVec(hn::BitCast(f, hn::BroadcastSignBit(child)))) << part * part_lanes;
  }
  return items;
}

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

/// A ray on its way through a tree.
class RayWalk {
 public:
  void start(const WideBvh& tree, const LeafTriangles* leaves, const WideRay& ray, std::size_t number) {
    tree_ = &tree;
    slabs_.set(ray);
    line_.set(ray, slabs_.pad());
    leaves_ = leaves != nullptr && line_.usable() ? leaves->of_block.data() : nullptr;
    number_ = number;
    late_ = ray.late + 0x1p-20F;
    limit_ = 1;
    child_ = 0;
    items_ = 0;
    candidate_count_ = 0;
  }

  /// Opens a block, or looks at the triangles of the last one, which have been asked for meanwhile; false when there is
  /// nothing more.
  HWY_INLINE bool step(const VisitCandidates& visit) {
    if (items_ != 0) {
      see(visit);
      items_ = 0;
    } else if (open(tree_->blocks[static_cast<std::size_t>(child_)])) {
      return true;
    }
    if (next()) return true;
    if (candidate_count_ > 0) show(visit, true);
    return false;
  }

 private:
  /// The inner children that are met wait for their turn, and triangles for the next step. True where it is clear what
  /// that is.
  HWY_INLINE bool open(const WideBlock& block) {
    unsigned met = 0;
    for (std::size_t part = 0; part < block_parts; ++part)
      met |= (slabs_.meet(block, part * part_lanes, limit_, when_) & part_mask) << part * part_lanes;
    met &= (1U << block.count) - 1U;
    items_ = items_of(block) & met;
    const unsigned inner = met & ~items_;
    if (items_ != 0) {
      opened_ = child_;
      if (leaves_ != nullptr) prefetch(leaves_[child_]);
      if (inner != 0) wait(block, inner);
      return true;
    }
    if (inner == 0) return false;
    const unsigned others = inner & (inner - 1);
    if ((others & (others - 1)) == 0) {
      go_to_first_of_two(block, inner);
      return true;
    }
    wait(block, inner);
    return false;
  }

  /// Of two, or one. Which of them it is cannot be foreseen, so nothing branches on it.
  HWY_INLINE void go_to_first_of_two(const WideBlock& block, unsigned inner) {
    const auto one = static_cast<std::size_t>(std::countr_zero(inner));
    const auto other = static_cast<std::size_t>(std::bit_width(inner) - 1);
    const bool other_first = when_[other] < when_[one];
    const std::size_t near = other_first ? other : one, far = other_first ? one : other;
    child_ = block.child[near];
    prefetch(tree_->blocks[static_cast<std::size_t>(child_)]);
    if (near == far) return;
    pending_.make_room();
    prefetch(tree_->blocks[static_cast<std::size_t>(block.child[far])]);
    pending_.insert({when_[far], block.child[far]}, 0);
  }

  /// The earliest comes next.
  HWY_INLINE void wait(const WideBlock& block, unsigned inner) {
    pending_.make_room();
    for (std::size_t count = 0; inner != 0; inner &= inner - 1, ++count) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(inner));
      const std::int32_t child = block.child[lane];
      prefetch(tree_->blocks[static_cast<std::size_t>(child)]);
      pending_.insert({when_[lane], child}, count);
    }
  }

  /// The triangles that wait.
  HWY_INLINE void see(const VisitCandidates& visit) {
    if (candidate_count_ + WideBlock::width > candidates_.size()) show(visit, false);
    const WideBlock& block = tree_->blocks[static_cast<std::size_t>(opened_)];
    if (leaves_ == nullptr) return see_boxes(block, visit);
    const TriangleLanes& triangles = leaves_[opened_];
    const RayLanes told = lanes_told(line_, block, triangles, items_);
    for (unsigned left = told.possible; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const float lower = std::max(when_[lane], told.lower[lane]);
      if (lower > limit_) continue;
      const bool certain = (told.certain >> lane & 1U) != 0;
      candidates_[candidate_count_++] = {lower, triangles.number[lane], certain};
      if (certain) limit_ = std::min(limit_, told.upper[lane] + late_);
    }
    // What is not certain is found out before more is searched for nothing.
    if (told.possible != told.certain) show(visit, false);
  }

  /// Nothing is known but the boxes.
  void see_boxes(const WideBlock& block, const VisitCandidates& visit) {
    for (unsigned left = items_; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      candidates_[candidate_count_++] = {when_[lane], tree_->items[static_cast<std::size_t>(~block.child[lane])],
                                         false};
    }
    show(visit, false);
  }

  /// Shows what is still of interest, the earliest first.
  void show(const VisitCandidates& visit, bool last_of_all) {
    const auto first = candidates_.begin();
    const auto last = std::remove_if(first, first + static_cast<std::ptrdiff_t>(candidate_count_),
                                     [&](const RayCandidate& one) { return one.lower > limit_; });
    if (last - first > 1)
      std::sort(first, last, [](const RayCandidate& a, const RayCandidate& b) { return a.lower < b.lower; });
    candidate_count_ = 0;
    if (first != last) limit_ = std::min(limit_, visit(number_, {first, last}, last_of_all));
  }

  /// Asks for memory before its turn comes.
  template <class Lines>
  HWY_INLINE static void prefetch(const Lines& lines) {
    const auto* bytes = reinterpret_cast<const char*>(&lines);
#pragma GCC unroll 5
    for (std::size_t line = 0; line < sizeof(Lines); line += 64) __builtin_prefetch(bytes + line);
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

  const WideBvh* tree_;
  const TriangleLanes* leaves_;
  std::size_t number_;
  RaySlabs slabs_;
  RayLine line_;
  float late_, limit_;
  std::int32_t child_, opened_;
  unsigned items_;               ///< of the block that was opened last: triangles whose boxes are met
  alignas(64) LaneFloats when_;  ///< and when they are
  std::size_t candidate_count_;
  std::array<RayCandidate, 3 * WideBlock::width> candidates_;
  PendingStack pending_;
};

/// So many walk at a time: enough to wait for memory together, and few enough that their stacks stay near.
constexpr std::size_t rays_abreast = 12;

void run_ray(const WideBvh& tree, const LeafTriangles* leaves, const WideRay& ray, const VisitCandidates& visit) {
  RayWalk walk;
  walk.start(tree, leaves, ray, 0);
  while (walk.step(visit)) {
  }
}

/// Rays that walk side by side, the next one in the place of one that is done.
void run_rays(const WideBvh& tree, const LeafTriangles* leaves, std::span<const WideRay> rays, VisitCandidates visit) {
  if (rays.size() == 1) return run_ray(tree, leaves, rays[0], visit);
  std::array<RayWalk, rays_abreast> walks;
  std::array<RayWalk*, rays_abreast> walking;
  std::size_t next = 0, count = 0;
  for (; count < rays_abreast && next < rays.size(); ++next, ++count) {
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

void walk_rays(const WideBvh& tree, const LeafTriangles* leaves, std::span<const WideRay> rays, VisitCandidates visit) {
  if (!tree.blocks.empty()) HWY_DYNAMIC_DISPATCH(run_rays)(tree, leaves, rays, visit);
}

RayLanes ray_lanes(const WideRay& ray, const WideBlock& block, const TriangleLanes& triangles) {
  return HWY_DYNAMIC_DISPATCH(run_lanes)(ray, block, triangles);
}

}  // namespace toccata
#endif
