// Compiled once for every SIMD level; Highway includes this file into itself.
#include "trees/near_walk.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trees/near_walk.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes before
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/prefetch.hpp"
#include "trees/box_lanes.hpp"
#include "trees/triangle_prism.hpp"

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

/// The blocks that were seen last: eight boxes at once are seen in the time of one, and the others are mostly asked for
/// soon.
class SeenBlocks {
 public:
  SeenBlocks() { numbers_.fill(NearFrontier::none); }

  HWY_INLINE Seen box(const NearView& view, std::span<const OrientedBlock> blocks, std::uint32_t number,
                      std::size_t lane) {
    const std::size_t place = (number * 0x9E3779B1U) >> (32 - log2_count);
    if (numbers_[place] != number) {
      numbers_[place] = number;
      see(view, blocks[number], blocks_[place]);
    }
    return seen_in(blocks_[place], lane);
  }

 private:
  static constexpr unsigned log2_count = 4;
  std::array<std::uint32_t, 1U << log2_count> numbers_;
  std::array<SeenBlock, 1U << log2_count> blocks_;
};

/// A triangle of the other tree, and boxes of the own one that are small beside it.
class BesideTriangle {
 public:
  /// Makes the bounds greater where the triangle itself says more.
  void raise(const NearView& view, const NearBvh& tree, std::int32_t other_child, const OrientedBlock& own,
             double other_size, BlockBounds& bounds) {
    for (std::size_t lane = 0; lane < own.count; ++lane) {
      const double size = (double{own.extent[0][lane]} + own.extent[1][lane]) + own.extent[2][lane];
      if (own.is_item(lane) || !(size < small_beside_item * other_size)) continue;
      see_triangle(view, tree, static_cast<std::uint32_t>(~other_child));
      bounds[lane] = std::max(bounds[lane], (prism_.gap(own, lane) - view.pad) * view.scale);
    }
  }

 private:
  void see_triangle(const NearView& view, const NearBvh& tree, std::uint32_t place) {
    if (place == place_) return;
    place_ = place;
    const auto& corner = tree.mesh->triangles()[tree.items[place]];
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 local = (1 / tree.unit) * (tree.mesh->vertices()[corner[i]] - tree.origin);
      corners[i] = view.offset + view.ratio * turned(view.rotation, local);
    }
    prism_ = TrianglePrism(corners);
  }

  std::uint32_t place_ = NearFrontier::none;
  TrianglePrism prism_;
};

/// A box of either tree.
struct BoxNumber {
  std::uint32_t block = 0;
  std::uint32_t lane = 0;
};

class NearRun {
 public:
  NearRun(const NearWalk& walk, NearFrontier& frontier, NearQuestion& question)
      : walk_(walk), f_(frontier), question_(question) {}

  void run() {
    f_.clear();
    if (!dive() || question_.limit() < 0) return;
    set_limits(question_.limit());
    const std::uint32_t lanes = block(1, 0).count;
    for (std::uint32_t lane = 0; lane < lanes; ++lane) push_boxes(0, 0, lane, 0);
    for (bucket_ = 0; bucket_ < NearFrontier::bucket_count && !is_beyond(least_of(bucket_)); ++bucket_) empty_bucket();
  }

 private:
  [[nodiscard]] const OrientedBlock& block(std::size_t side, std::size_t number) const {
    return walk_.tree(side).blocks[number];
  }

  /// A box of the other tree.
  HWY_INLINE Seen seen_box(std::size_t side, std::uint32_t number, std::size_t lane) {
    return seen_[side].box(walk_.view(side), walk_.tree(side ^ 1).blocks, number, lane);
  }

  /// Follows the nearest boxes down to two items, so that there is a limit to begin with, unless they turn out to be
  /// beyond that which there is. False where all boxes are.
  bool dive() {
    BoxNumber of_b;
    double least = expand(0, 0, of_b).bound;
    for (std::uint32_t lane = 1; lane < block(1, 0).count; ++lane) {
      const Nearest nearest = expand(0, 0, {0, lane});
      if (nearest.bound < least) {
        least = nearest.bound;
        of_b.lane = lane;
      }
    }
    const double limit = question_.limit();
    if (least > limit) return false;
    std::size_t side = 0;
    std::uint32_t own_block = 0;
    BoxNumber other = of_b;
    for (;;) {
      const Nearest nearest = expand(side, own_block, other);
      if (nearest.bound > limit) return true;
      const BoxNumber own{own_block, nearest.lane};
      const std::int32_t child = block(side, own.block).child[own.lane];
      const std::int32_t other_child = block(side ^ 1, other.block).child[other.lane];
      if (child < 0 && other_child < 0) {
        const auto place = static_cast<std::uint32_t>(~child), other_place = static_cast<std::uint32_t>(~other_child);
        side == 0 ? add_pair(place, other_place) : add_pair(other_place, place);
        hand_on();
        return true;
      }
      if (other_child < 0 || (child >= 0 && opens_own_)) {
        own_block = static_cast<std::uint32_t>(child);
      } else {
        own_block = static_cast<std::uint32_t>(other_child);
        other = own;
        side ^= 1;
      }
    }
  }

  struct Nearest {
    std::uint32_t lane;
    double bound;
  };

  /// The bounds of a block's boxes and one of the other tree.
  HWY_INLINE void bound(std::size_t side, const OrientedBlock& own, const Seen& box, std::int32_t other_child) {
    const NearView& view = walk_.view(side);
    bounds_of(view, own, box, bounds_);
    const NearBvh& other = walk_.tree(side ^ 1);
    if (other_child < 0 && other.mesh != nullptr && view.rigid)
      beside_[side].raise(view, other, other_child, own, box.size, bounds_);
  }

  /// The bounds of a box and the children of a block; says which is the least.
  Nearest expand(std::size_t side, std::uint32_t number, const BoxNumber& other) {
    const OrientedBlock& own = block(side, number);
    const Seen box = seen_box(side, other.block, other.lane);
    bound(side, own, box, block(side ^ 1, other.block).child[other.lane]);
    f_.counts.volume_tests += own.count;
    std::uint32_t nearest = 0;
    for (std::uint32_t lane = 1; lane < own.count; ++lane)
      if (bounds_[lane] < bounds_[nearest]) nearest = lane;
    opens_own_ = size_of(own, nearest) >= box.size;
    return {nearest, bounds_[nearest]};
  }

  [[nodiscard]] static double size_of(const OrientedBlock& own, std::size_t lane) {
    return (double{own.extent[0][lane]} + own.extent[1][lane]) + own.extent[2][lane];
  }

  // Bounds are kept as floats, as parts of the first limit; both are rounded so that nothing is lost.

  void set_limits(double limit) {
    inverse_ = std::isfinite(1 / limit) ? 1 / limit : 0;  // 0: nothing is left out
    last_limit_ = limit;
    limit_part_ = 1 + 0x1p-20;
  }

  [[nodiscard]] double least_of(std::size_t bucket) const {
    return static_cast<double>(bucket) / NearFrontier::bucket_count;
  }

  [[nodiscard]] bool is_beyond(double part) const { return part > limit_part_; }

  /// What is not a number comes first and is never left out.
  [[nodiscard]] std::size_t bucket_of(double part) const {
    const double scaled = part * NearFrontier::bucket_count;
    const std::size_t bucket = scaled > 0 ? static_cast<std::size_t>(std::min(scaled, 255.0)) : 0;
    return std::max(bucket, bucket_);
  }

  void push(std::array<NearFrontier::Bucket, NearFrontier::bucket_count>& buckets, std::uint32_t first,
            std::uint32_t second, double part) {
    f_.push(buckets[bucket_of(part)], {first, second, static_cast<float>(part)});
  }

  void push_boxes(std::size_t side, std::uint32_t number, std::uint32_t other, double part) {
    prefetch(block(side, number));
    push(f_.boxes, number << 1 | static_cast<std::uint32_t>(side), other, part);
  }

  void empty_bucket() {
    NearFrontier::Bucket &boxes = f_.boxes[bucket_], &items = f_.items[bucket_];
    while (limit_part_ >= 0 && (!boxes.empty() || !items.empty())) {
      while (limit_part_ >= 0 && !boxes.empty()) {
        const NearFrontier::Entry entry = f_.pop(boxes);
        if (!boxes.empty()) ask_for_boxes(f_.top(boxes));
        if (!is_beyond(entry.bound)) open(entry);
      }
      while (!items.empty()) {
        const NearFrontier::Entry entry = f_.pop(items);
        if (!is_beyond(entry.bound)) add_pair(entry.first, entry.second);
        if (limit_part_ < 0) return;
      }
      hand_on();
    }
  }

  /// Asks for the memory of an entry before its turn comes.
  void ask_for_boxes(const NearFrontier::Entry& entry) const {
    const std::size_t side = entry.first & 1U;
    prefetch(block(side, entry.first >> 1));
    prefetch(block(side ^ 1, entry.second >> 3));
  }

  void open(const NearFrontier::Entry& entry) {
    const std::size_t side = entry.first & 1U;
    const std::uint32_t number = entry.first >> 1;
    const OrientedBlock& own = block(side, number);
    const OrientedBlock& other = block(side ^ 1, entry.second >> 3);
    const std::size_t other_lane = entry.second & 7U;
    const Seen box = seen_box(side, entry.second >> 3, other_lane);
    const std::int32_t other_child = other.child[other_lane];
    bound(side, own, box, other_child);
    f_.counts.volume_tests += own.count;
    // Bits instead of a test of each, which would be foretold wrongly time and again.
    for (std::uint32_t near = lanes_in_reach(own.count); near != 0; near &= near - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(near));
      file(side, number, lane, entry.second, other_child, box.size, bounds_[lane]);
    }
  }

  /// Makes the bounds parts of the first limit, and tells by bits which of the first lanes are not beyond that of now.
  HWY_INLINE std::uint32_t lanes_in_reach(std::uint32_t count) {
    std::uint32_t near = 0;
    for (std::size_t lane = 0; lane < most_lanes; lane += hn::Lanes(tag)) {
      const Number parts = hn::Mul(hn::LoadU(tag, bounds_.data() + lane), all(inverse_));
      hn::StoreU(parts, tag, bounds_.data() + lane);
      near |= bits_of(tag, hn::Not(hn::Gt(parts, all(limit_part_)))) << lane;
    }
    return near & ((1U << count) - 1);
  }

  /// Two items, or two boxes of which the larger is to be opened.
  HWY_INLINE void file(std::size_t side, std::uint32_t number, std::uint32_t lane, std::uint32_t other,
                       std::int32_t other_child, double other_size, double part) {
    const OrientedBlock& own = block(side, number);
    const std::int32_t child = own.child[lane];
    if (child < 0 && other_child < 0) {
      const auto place = static_cast<std::uint32_t>(~child), other_place = static_cast<std::uint32_t>(~other_child);
      file_items(side == 0 ? place : other_place, side == 0 ? other_place : place, part);
    } else if (other_child < 0 || (child >= 0 && size_of(own, lane) >= other_size)) {
      push_boxes(side, static_cast<std::uint32_t>(child), other, part);
    } else {
      push_boxes(side ^ 1, static_cast<std::uint32_t>(other_child), number << 3 | lane, part);
    }
  }

  /// What would come before all else that waits is not kept waiting; and nothing is once batches have not lowered the
  /// limit, for it is likely to be what it will be then: now the two items are near what was looked at last.
  HWY_INLINE void file_items(std::uint32_t place_a, std::uint32_t place_b, double part) {
    if (bucket_of(part) == bucket_ || steady_batches_ >= steady)
      add_pair(place_a, place_b);
    else
      push(f_.items, place_a, place_b, part);
  }

  static constexpr std::size_t largest_batch = 64;
  static constexpr std::size_t steady = 2;  ///< batches

  void add_pair(std::uint32_t place_a, std::uint32_t place_b) {
    f_.pairs.push_back({walk_.tree(0).items[place_a], walk_.tree(1).items[place_b]});
    if (f_.pairs.size() == largest_batch) hand_on();
  }

  void hand_on() {
    if (f_.pairs.empty()) return;
    f_.counts.items += f_.pairs.size();
    question_.visit(f_.pairs);
    f_.pairs.clear();
    const double limit = question_.limit();
    steady_batches_ = limit < 0.99 * last_limit_ ? 0 : steady_batches_ + 1;
    if (limit < last_limit_) {
      last_limit_ = limit;
      limit_part_ = limit < 0 ? -1 : limit * inverse_ * (1 + 0x1p-20);
    }
  }

  const NearWalk& walk_;
  NearFrontier& f_;
  NearQuestion& question_;
  std::array<SeenBlocks, 2> seen_;
  std::array<BesideTriangle, 2> beside_;
  BlockBounds bounds_{};
  bool opens_own_ = false;
  std::size_t bucket_ = 0;
  double inverse_ = 1;
  double last_limit_ = 0;
  double limit_part_ = 1;
  std::size_t steady_batches_ = 0;  ///< how many have not lowered the limit by more than a little
};

void run_near_walk(const NearWalk& walk, NearFrontier& frontier, NearQuestion& question) {
  NearRun(walk, frontier, question).run();
}

NearBounds bounds_of_block(const NearWalk& walk, std::size_t side, std::uint32_t number, std::uint32_t other) {
  NearBounds bounds;
  SeenBlock block;
  see(walk.view(side), walk.tree(side ^ 1).blocks[other >> 3], block);
  const Seen box = seen_in(block, other & 7U);
  bounds_of(walk.view(side), walk.tree(side).blocks[number], box, bounds.least);
  bounds.other_size = box.size;
  return bounds;
}

}  // namespace
}  // namespace toccata::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(run_near_walk);
HWY_EXPORT(bounds_of_block);

void NearFrontier::clear() {
  runs.clear();
  free = none;
  boxes.fill({});
  items.fill({});
  pairs.clear();
  counts = {};
}

void NearFrontier::push(Bucket& bucket, const Entry& entry) {
  if (bucket.empty() || bucket.count == run_length) add_run(bucket);
  runs[bucket.run].entries[bucket.count++] = entry;
}

void NearFrontier::add_run(Bucket& bucket) {
  std::uint32_t place = free;
  if (place == none) {
    place = static_cast<std::uint32_t>(runs.size());
    runs.emplace_back();
  } else {
    free = runs[place].below;
  }
  runs[place].below = bucket.run;
  bucket = {place, 0};
}

NearFrontier::Entry NearFrontier::pop(Bucket& bucket) {
  Run& run = runs[bucket.run];
  const Entry taken = run.entries[--bucket.count];
  if (bucket.count > 0) return taken;
  const std::uint32_t emptied = bucket.run;
  bucket = {run.below, run.below == none ? 0 : static_cast<std::uint32_t>(run_length)};
  run.below = free;
  free = emptied;
  if (!bucket.empty()) __builtin_prefetch(&runs[bucket.run].below);
  return taken;
}

void NearWalk::run(NearFrontier& frontier, NearQuestion& question) const {
  HWY_DYNAMIC_DISPATCH(run_near_walk)(*this, frontier, question);
}

NearBounds NearWalk::bounds(std::size_t side, std::uint32_t number, std::uint32_t other) const {
  return HWY_DYNAMIC_DISPATCH(bounds_of_block)(*this, side, number, other);
}

}  // namespace toccata
#endif
