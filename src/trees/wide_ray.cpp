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
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "trees/block_walk.hpp"
#include "trees/ray_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

HWY_INLINE Float extents_of(const WideBlock& block, std::size_t first) {
  return hn::Add(hn::Add(lanes_from(block.extent[0], first), lanes_from(block.extent[1], first)),
                 lanes_from(block.extent[2], first));
}

/// What a line that can tell anything tells of the lanes of a block that it meets the boxes of.
RayLanes lanes_told(const RayLine& line, const WideBlock& block, const TriangleLanes& triangles, unsigned among) {
  RayLanes told;
  const LineNumbers numbers = line.numbers();
  for (std::size_t first = 0; first < WideBlock::width; first += part_lanes) {
    const auto corner = [&](std::size_t number) HWY_ATTR {
      const auto along = [&](std::size_t i)
                             HWY_ATTR { return lanes_from(triangles.corner[number][line.axes()[i]], first); };
      return seen_corner(numbers, along(0), along(1), along(2));
    };
    const LinesTold some =
        told_of(numbers, corner(0), corner(1), corner(2), extents_of(block, first), (among >> first) & part_mask);
    if (some.possible == 0) continue;
    told.possible |= some.possible << first;
    told.certain |= some.certain << first;
    hn::StoreU(some.lower, Floats(), told.lower.data() + first);
    hn::StoreU(some.upper, Floats(), told.upper.data() + first);
  }
  return told;
}

/// The triangles that a ray may meet first, which are shown some at a time.
class RayCandidates {
 public:
  void start(const WideRay& ray, std::size_t number, const VisitCandidates& visit) {
    visit_ = &visit;
    number_ = number;
    late_ = ray.late + 0x1p-20F;
    limit_ = 1;
    count_ = 0;
  }

  /// The greatest time of interest.
  [[nodiscard]] float limit() const { return limit_; }

  /// For a block's triangles more.
  HWY_INLINE void make_room() {
    if (count_ + WideBlock::width > candidates_.size()) show(false);
  }
  HWY_INLINE void add(const RayCandidate& one) { candidates_[count_++] = one; }
  /// One that is certain, and met no later than `upper`.
  HWY_INLINE void ends_by(float upper) { limit_ = std::min(limit_, upper + late_); }

  /// Shows what is still of interest, the earliest first.
  void show(bool last_of_all) {
    const auto first = candidates_.begin();
    const auto last = std::remove_if(first, first + static_cast<std::ptrdiff_t>(count_),
                                     [&](const RayCandidate& one) { return one.lower > limit_; });
    if (last - first > 1)
      std::sort(first, last, [](const RayCandidate& a, const RayCandidate& b) { return a.lower < b.lower; });
    count_ = 0;
    if (first != last) limit_ = std::min(limit_, (*visit_)(number_, {first, last}, last_of_all));
  }

  void end() {
    if (count_ > 0) show(true);
  }

 private:
  const VisitCandidates* visit_;
  std::size_t number_;
  float late_, limit_;
  std::size_t count_;
  std::array<RayCandidate, 3 * WideBlock::width> candidates_;
};

/// A search for the triangles that a ray may meet first.
class RaySearch {
 public:
  static constexpr ChildOrder child_order = ChildOrder::nearest_of_few;

  void start(const WideBvh& tree, const LeafTriangles* leaves, const WideRay& ray, std::size_t number,
             const VisitCandidates& visit) {
    tree_ = &tree;
    found_.start(ray, number, visit);
    slabs_.set(ray);
    line_.set(ray, slabs_.pad());
    leaves_ = leaves != nullptr && line_.usable() ? leaves->of_block.data() : nullptr;
  }

  HWY_INLINE unsigned meet(const WideBlock& block, std::size_t first, LaneFloats& when) const {
    return slabs_.meet(block, first, found_.limit(), when) & part_mask;
  }
  [[nodiscard]] HWY_INLINE bool wants(float when) const { return !(when > found_.limit() * of_times); }
  HWY_INLINE void prefetch(std::size_t number) const {
    if (leaves_ != nullptr) toccata::prefetch(leaves_[number]);
  }

  HWY_INLINE void see(std::size_t number, unsigned items, const LaneFloats& when) {
    found_.make_room();
    const WideBlock& block = tree_->blocks[number];
    if (leaves_ == nullptr) return see_boxes(block, items, when);
    const TriangleLanes& triangles = leaves_[number];
    const RayLanes told = lanes_told(line_, block, triangles, items);
    for (unsigned left = told.possible; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const float lower = std::max(when[lane], told.lower[lane]);
      if (lower > found_.limit()) continue;
      const bool certain = (told.certain >> lane & 1U) != 0;
      found_.add({lower, triangles.number[lane], certain});
      if (certain) found_.ends_by(told.upper[lane]);
    }
    // What is not certain is found out before more is searched for nothing.
    if (told.possible != told.certain) found_.show(false);
  }

  void end() { found_.end(); }

 private:
  /// Nothing is known but the boxes.
  void see_boxes(const WideBlock& block, unsigned items, const LaneFloats& when) {
    for (unsigned left = items; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      found_.add({when[lane], tree_->items[block.item_place(lane)], false});
    }
    found_.show(false);
  }

  const WideBvh* tree_;
  const TriangleLanes* leaves_;
  RaySlabs slabs_;
  RayLine line_;
  RayCandidates found_;
};

/// The same for rays that stay together, a ray in each lane: each box and each triangle is compared with all of them. A
/// turn tells the rays too, in its last bits.
class PacketSearch {
 public:
  static constexpr ChildOrder child_order = ChildOrder::nearest_of_few;
  static constexpr std::size_t width = WideBlock::width;
  static_assert(width <= 8, "the last bits of a turn are as many");

  /// False where they do not stay together, and before anything is searched for.
  bool set(std::span<const WideRay, width> rays) {
    if (!stay_together(rays)) return false;
    for (std::size_t i = 0; i < width; ++i) {
      RaySlabs slabs;
      RayLine line;
      slabs.set(rays[i]);
      line.set(rays[i], slabs.pad());
      if (!line.usable() || (i > 0 && line.axes() != axes_)) return false;
      axes_ = line.axes();
      slabs.put(i, slabs_);
      line.put(i, line_);
    }
    return true;
  }

  /// `number` is that of the first.
  void start(const WideBvh& tree, const LeafTriangles& leaves, std::span<const WideRay, width> rays, std::size_t number,
             const VisitCandidates& visit) {
    tree_ = &tree;
    leaves_ = leaves.of_block.data();
    for (std::size_t i = 0; i < width; ++i) found_[i].start(rays[i], number + i, visit);
    limit_.fill(1);
    latest_ = 1;
    rays_ = all_rays;
    blocks_ = blocks_of_rays_ = 0;
  }

  HWY_INLINE unsigned meet(const WideBlock& block, std::size_t first, LaneFloats& when) {
    if (first == 0) {
      ++blocks_;
      blocks_of_rays_ += static_cast<std::size_t>(std::popcount(rays_));
    }
    unsigned boxes = 0;
    const std::size_t end = std::min<std::size_t>(first + part_lanes, block.count);
    for (std::size_t lane = first; lane < end; ++lane) {
      unsigned rays = 0;
      Float soonest = hn::Inf(Floats());
      for (std::size_t of_rays = 0; of_rays < width; of_rays += part_lanes) {
        const auto within = [&](std::size_t axis) HWY_ATTR {
          return span_within(slab_numbers(axis, of_rays), all<Float>(block.centre[axis][lane]),
                             all<Float>(block.extent[axis][lane]));
        };
        const RaySpan span = common_part(within(0), within(1), within(2), lanes_from(limit_, of_rays));
        const FloatMask passed = hn::Gt(span.enter, hn::Mul(span.leave, all<Float>(of_times)));
        soonest = hn::Min(soonest, hn::IfThenElse(passed, hn::Inf(Floats()), span.enter));
        rays |= (~bits_of(Floats(), passed) & part_mask) << of_rays;
      }
      rays &= rays_;
      if (rays == 0) continue;
      boxes |= 1U << (lane - first);
      when[lane] = turn_of(hn::GetLane(hn::MinOfLanes(Floats(), soonest)), rays);
    }
    return boxes;
  }
  [[nodiscard]] HWY_INLINE bool wants(float turn) const { return !(when_of(turn) > latest_ * of_times); }
  HWY_INLINE void opens(float turn) { rays_ = rays_of(turn); }
  HWY_INLINE void prefetch(std::size_t number) const { toccata::prefetch(leaves_[number]); }

  void see(std::size_t number, unsigned items, const LaneFloats& turns) {
    for (RayCandidates& found : found_) found.make_room();
    unsigned in_doubt = 0;
    for (unsigned left = items; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      in_doubt |= see_triangle(tree_->blocks[number], leaves_[number], lane, turns[lane]);
    }
    // What is not certain is found out before more is searched for nothing.
    for (; in_doubt != 0; in_doubt &= in_doubt - 1)
      found_[static_cast<std::size_t>(std::countr_zero(in_doubt))].show(false);
    for (std::size_t i = 0; i < width; ++i) limit_[i] = found_[i].limit();
    latest_ = *std::max_element(limit_.begin(), limit_.end());
  }

  void end() {
    for (RayCandidates& found : found_) found.end();
  }

  /// Enough of the rays opened each block for that to be less work than each by itself.
  [[nodiscard]] bool paid() const {
    constexpr std::size_t least_rays = 4;
    return blocks_of_rays_ >= least_rays * blocks_;
  }

 private:
  static constexpr unsigned all_rays = (1U << width) - 1U;

  /// No later than it is.
  static float turn_of(float when, unsigned rays) {
    return std::bit_cast<float>((std::bit_cast<std::uint32_t>(when) & ~all_rays) | rays);
  }
  static float when_of(float turn) { return std::bit_cast<float>(std::bit_cast<std::uint32_t>(turn) & ~all_rays); }
  static unsigned rays_of(float turn) { return std::bit_cast<std::uint32_t>(turn) & all_rays; }

  /// They begin and end near each other: what one meets, most do.
  static bool stay_together(std::span<const WideRay, width> rays) {
    constexpr float near = 0.25F;
    for (const WideRay& ray : rays)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (!(std::fabs(ray.origin[axis] - rays[0].origin[axis]) < near) ||
            !(std::fabs(ray.motion[axis] - rays[0].motion[axis]) < near))
          return false;
    return true;
  }

  HWY_INLINE SlabNumbers slab_numbers(std::size_t axis, std::size_t first) const {
    const auto& rows = slabs_[axis];
    return {lanes_from(rows[0], first), lanes_from(rows[1], first), lanes_from(rows[2], first),
            lanes_from(rows[3], first)};
  }
  HWY_INLINE LineNumbers line_numbers(std::size_t first) const {
    const auto row = [&](std::size_t i) HWY_ATTR { return lanes_from(line_[i], first); };
    return {{row(0), row(1), row(2)}, {row(3), row(4)}, row(5), row(6), row(7)};
  }

  /// Returns the rays of which it is not certain whether they meet it.
  HWY_INLINE unsigned see_triangle(const WideBlock& block, const TriangleLanes& triangles, std::size_t lane,
                                   float turn) {
    const unsigned rays = rays_of(turn);
    const float extents = (block.extent[0][lane] + block.extent[1][lane]) + block.extent[2][lane];
    alignas(64) LaneFloats lower, upper;
    unsigned possible = 0, certain = 0;
    for (std::size_t first = 0; first < width; first += part_lanes) {
      const LineNumbers numbers = line_numbers(first);
      const auto corner = [&](std::size_t number) HWY_ATTR {
        const auto along = [&](std::size_t i) HWY_ATTR { return all<Float>(triangles.corner[number][axes_[i]][lane]); };
        return seen_corner(numbers, along(0), along(1), along(2));
      };
      const LinesTold told =
          told_of(numbers, corner(0), corner(1), corner(2), all<Float>(extents), (rays >> first) & part_mask);
      possible |= told.possible << first;
      certain |= told.certain << first;
      hn::Store(told.lower, Floats(), lower.data() + first);
      hn::Store(told.upper, Floats(), upper.data() + first);
    }
    for (unsigned left = possible; left != 0; left &= left - 1) {
      const auto ray = static_cast<std::size_t>(std::countr_zero(left));
      const float from = std::max(when_of(turn), lower[ray]);
      if (from > found_[ray].limit()) continue;
      const bool is_certain = (certain >> ray & 1U) != 0;
      found_[ray].add({from, triangles.number[lane], is_certain});
      if (is_certain) found_[ray].ends_by(upper[ray]);
    }
    return possible & ~certain;
  }

  const WideBvh* tree_;
  const TriangleLanes* leaves_;
  alignas(64) std::array<std::array<LaneFloats, 4>, 3> slabs_;
  alignas(64) std::array<LaneFloats, 8> line_;
  alignas(64) LaneFloats limit_;  ///< of each ray
  std::array<std::size_t, 3> axes_;
  float latest_;                         ///< the greatest limit
  unsigned rays_;                        ///< those of which the block is of interest that is opened next
  std::size_t blocks_, blocks_of_rays_;  ///< opened, and the same by each ray
  std::array<RayCandidates, width> found_;
};

using RayWalk = BlockWalk<RaySearch>;
using PacketWalk = BlockWalk<PacketSearch>;

/// So many walk at a time: enough to wait for memory together, and few enough that their stacks stay near.
constexpr std::size_t rays_abreast = 12;

/// A tree of so many blocks stays in a near cache, and there is nothing to wait for.
constexpr std::size_t most_near_blocks = 1536;

/// Some of the rays, each by itself.
void run_each(const WideBvh& tree, const LeafTriangles* leaves, std::span<const WideRay> rays, std::size_t first,
              std::size_t end, const VisitCandidates& visit) {
  if (end - first <= 1 || tree.blocks.size() <= most_near_blocks) {
    RayWalk walk;
    for (std::size_t i = first; i < end; ++i) {
      walk.start(tree, tree, leaves, rays[i], i, visit);
      walk.run();
      walk.search().end();
    }
    return;
  }
  const auto start = [&](RayWalk& walk, std::size_t, std::size_t i) {
    walk.start(tree, tree, leaves, rays[first + i], first + i, visit);
  };
  walk_abreast<RayWalk, rays_abreast>(end - first, start, [](RayWalk& walk, std::size_t) { walk.search().end(); });
}

/// Those that stay together with their neighbours in packets, the others each by itself.
void run_rays(const WideBvh& tree, const LeafTriangles* leaves, std::span<const WideRay> rays, VisitCandidates visit) {
  constexpr std::size_t width = PacketSearch::width;
  if (leaves == nullptr || rays.size() < width) return run_each(tree, leaves, rays, 0, rays.size(), visit);
  constexpr std::size_t packets_to_leave_out = 15;
  PacketWalk walk;
  std::size_t done = 0, left_out = 0;
  for (std::size_t first = 0; first + width <= rays.size(); first += width) {
    const auto packet = rays.subspan(first).first<width>();
    if (left_out > 0) --left_out;
    if (left_out > 0 || !walk.search().set(packet)) continue;
    run_each(tree, leaves, rays, done, first, visit);
    walk.start(tree, tree, *leaves, packet, first, visit);
    walk.run();
    walk.search().end();
    done = first + width;
    if (!walk.search().paid()) left_out = packets_to_leave_out;
  }
  run_each(tree, leaves, rays, done, rays.size(), visit);
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
