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

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t width = OrientedBlock::width;
using Tag = hn::CappedTag<double, width>;
using Number = hn::Vec<Tag>;
using Bounds = std::array<double, width>;

struct Vector {
  Number x, y, z;
};

HWY_INLINE Number all(double value) { return hn::Set(Tag(), value); }
HWY_INLINE Vector in_all(const Vec3& v) { return {all(v.x), all(v.y), all(v.z)}; }
HWY_INLINE Number loaded(const std::array<float, width>& values, std::size_t lane) {
  return hn::PromoteTo(Tag(), hn::LoadU(hn::Rebind<float, Tag>(), values.data() + lane));
}
HWY_INLINE Vector loaded(const std::array<std::array<float, width>, 3>& values, std::size_t lane) {
  return {loaded(values[0], lane), loaded(values[1], lane), loaded(values[2], lane)};
}
HWY_INLINE Vector minus(const Vector& u, const Vector& v) {
  return {hn::Sub(u.x, v.x), hn::Sub(u.y, v.y), hn::Sub(u.z, v.z)};
}
HWY_INLINE Number dot(const Vector& u, const Vector& v) {
  return hn::Add(hn::Add(hn::Mul(u.x, v.x), hn::Mul(u.y, v.y)), hn::Mul(u.z, v.z));
}
HWY_INLINE Vector cross(const Vector& u, const Vector& v) {
  return {hn::Sub(hn::Mul(u.y, v.z), hn::Mul(u.z, v.y)), hn::Sub(hn::Mul(u.z, v.x), hn::Mul(u.x, v.z)),
          hn::Sub(hn::Mul(u.x, v.y), hn::Mul(u.y, v.x))};
}
/// Second where the first is not a number.
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR
HWY_INLINE Number greater(const Number& a, const Number& b) { return hn::Max(a, b); }  // one instruction
#else
HWY_INLINE Number greater(const Number& a, const Number& b) { return hn::IfThenElse(hn::Gt(a, b), a, b); }
#endif
HWY_INLINE Number sum_of_products(const std::array<Number, 3>& u, const std::array<Number, 3>& v) {
  return hn::Add(hn::Add(hn::Mul(u[0], v[0]), hn::Mul(u[1], v[1])), hn::Mul(u[2], v[2]));
}

HWY_INLINE Vec3 vector_of(const std::array<std::array<float, width>, 3>& values, std::size_t lane) {
  return {values[0][lane], values[1][lane], values[2][lane]};
}
HWY_INLINE Vec3 times(const Mat3& m, const Vec3& v) {
  return {toccata::dot(m[0], v), toccata::dot(m[1], v), toccata::dot(m[2], v)};
}

/// A box of the other tree in the own frame.
struct Seen {
  Vec3 centre;
  std::array<Vec3, 3> axis;
  Vec3 extent;
  double size;
};

HWY_INLINE Seen seen(const NearView& view, const OrientedBlock& block, std::size_t lane) {
  Seen box;
  box.extent = view.ratio * vector_of(block.extent, lane);
  box.size = (box.extent.x + box.extent.y) + box.extent.z;
  const Vec3 first = vector_of(block.axis[0], lane), second = vector_of(block.axis[1], lane);
  const Vec3 centre = vector_of(block.centre, lane);
  if (!view.rigid) {
    box.centre = view.offset + times(view.other, centre);
    box.axis = {times(view.other, first), times(view.other, second), times(view.other, toccata::cross(first, second))};
    box.extent = vector_of(block.extent, lane);
    return box;
  }
  box.centre = view.offset + view.ratio * times(view.rotation, centre);
  box.axis = {times(view.rotation, first), times(view.rotation, second), {}};
  box.axis[2] = toccata::cross(box.axis[0], box.axis[1]);
  return box;
}

/// The square of how far apart two boxes are along an axis of one, or 0; `along` is how far their centres are, and
/// `cosine` what the other's axes share with it, in magnitude.
HWY_INLINE Number squared_gap(const Number& along, const Number& extent, const std::array<Number, 3>& other_extent,
                              const std::array<Number, 3>& cosine) {
  const Number gap = hn::Sub(hn::Sub(along, extent), sum_of_products(other_extent, cosine));
  const Number part = greater(gap, hn::Zero(Tag()));
  return hn::Mul(part, part);
}

HWY_INLINE std::array<Number, 3> magnitudes_along(const std::array<Vector, 3>& axes, const Vector& v) {
  return {hn::Abs(dot(axes[0], v)), hn::Abs(dot(axes[1], v)), hn::Abs(dot(axes[2], v))};
}

/// Never above the distance of two boxes (docs/methods/mesh-distance.md): the gaps along the own axes, those along the
/// other's, and the gap along the line of the centres, whichever is largest. Without loops, which would keep what is
/// found in memory.
HWY_INLINE Number rigid_bound(const NearView& view, const OrientedBlock& block, std::size_t lane, const Seen& box) {
  using Three = std::array<Number, 3>;
  const Vector first = loaded(block.axis[0], lane), second = loaded(block.axis[1], lane);
  const std::array<Vector, 3> own{first, second, cross(first, second)};
  const std::array<Vector, 3> other{in_all(box.axis[0]), in_all(box.axis[1]), in_all(box.axis[2])};
  const Three extent{loaded(block.extent[0], lane), loaded(block.extent[1], lane), loaded(block.extent[2], lane)};
  const Three other_extent{all(box.extent.x), all(box.extent.y), all(box.extent.z)};
  const Vector between = minus(in_all(box.centre), loaded(block.centre, lane));

  const Three along_own = magnitudes_along(own, between), along_other = magnitudes_along(other, between);
  const Three c0 = magnitudes_along(other, own[0]), c1 = magnitudes_along(other, own[1]),
              c2 = magnitudes_along(other, own[2]);
  const Number by_own = hn::Add(hn::Add(squared_gap(along_own[0], extent[0], other_extent, c0),
                                        squared_gap(along_own[1], extent[1], other_extent, c1)),
                                squared_gap(along_own[2], extent[2], other_extent, c2));
  const Number by_other = hn::Add(hn::Add(squared_gap(along_other[0], other_extent[0], extent, {c0[0], c1[0], c2[0]}),
                                          squared_gap(along_other[1], other_extent[1], extent, {c0[1], c1[1], c2[1]})),
                                  squared_gap(along_other[2], other_extent[2], extent, {c0[2], c1[2], c2[2]}));
  const Number zero = hn::Zero(Tag());
  const Number by_sides = hn::Mul(greater(by_own, by_other), all(1 - 0x1p-18));
  const Number squared = dot(between, between);
  const Number reach = hn::Add(sum_of_products(extent, along_own), sum_of_products(other_extent, along_other));
  const Number left = greater(hn::Sub(squared, reach), zero);
  // Not left² / squared: a fourth power of lengths leaves the range of doubles where distances are far from it.
  const Number by_centres = hn::Mul(left, hn::Div(left, squared));
  return hn::Mul(hn::Sub(hn::Sqrt(greater(by_centres, by_sides)), all(view.pad)), all(view.scale));
}

/// The same under any poses: along the line of the centres alone.
HWY_INLINE double general_bound(const NearView& view, const OrientedBlock& block, std::size_t lane, const Seen& box) {
  const Vec3 between = box.centre - times(view.own, vector_of(block.centre, lane));
  const Vec3 first = vector_of(block.axis[0], lane), second = vector_of(block.axis[1], lane);
  const std::array<Vec3, 3> axis{first, second, toccata::cross(first, second)};
  double reach = 0;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    reach += block.extent[at][lane] * std::fabs(toccata::dot(between, times(view.own, axis[at])));
    reach += box.extent[i] * std::fabs(toccata::dot(between, box.axis[at]));
  }
  const double squared = toccata::dot(between, between), left = squared - reach;
  return left > 0 ? (left / std::sqrt(squared) - view.pad) * view.scale : 0 * view.scale;
}

HWY_INLINE void bounds_of(const NearView& view, const OrientedBlock& block, const Seen& box, Bounds& bounds) {
  if (view.rigid)
    for (std::size_t lane = 0; lane < width; lane += hn::Lanes(Tag()))
      hn::StoreU(rigid_bound(view, block, lane, box), Tag(), bounds.data() + lane);
  else
    for (std::size_t lane = 0; lane < width; ++lane) bounds[lane] = general_bound(view, block, lane, box);
}

/// A box of either tree.
struct BoxNumber {
  std::uint32_t block = 0;
  std::uint32_t lane = 0;
};

class Run {
 public:
  Run(const NearWalk& walk, NearFrontier& frontier, NearQuestion& question)
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

  /// The bounds of a box and the children of a block; says which is the least.
  Nearest expand(std::size_t side, std::uint32_t number, const BoxNumber& other) {
    const OrientedBlock& own = block(side, number);
    const Seen box = seen(walk_.view(side), block(side ^ 1, other.block), other.lane);
    bounds_of(walk_.view(side), own, box, bounds_);
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

  static void prefetch(const OrientedBlock& block) {
    const auto* bytes = reinterpret_cast<const char*>(&block);
    for (std::size_t line = 0; line < sizeof(OrientedBlock); line += 64) __builtin_prefetch(bytes + line);
  }

  void open(const NearFrontier::Entry& entry) {
    const std::size_t side = entry.first & 1U;
    const std::uint32_t number = entry.first >> 1;
    const OrientedBlock& own = block(side, number);
    const OrientedBlock& other = block(side ^ 1, entry.second >> 3);
    const std::size_t other_lane = entry.second & 7U;
    const Seen box = seen(walk_.view(side), other, other_lane);
    bounds_of(walk_.view(side), own, box, bounds_);
    f_.counts.volume_tests += own.count;
    const std::int32_t other_child = other.child[other_lane];
    // Bits instead of a test of each, which would be foretold wrongly time and again.
    for (std::uint32_t near = lanes_in_reach(own.count); near != 0; near &= near - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(near));
      file(side, number, lane, entry.second, other_child, box.size, bounds_[lane]);
    }
  }

  /// Makes the bounds parts of the first limit, and tells by bits which of the first lanes are not beyond that of now.
  HWY_INLINE std::uint32_t lanes_in_reach(std::uint32_t count) {
    std::uint32_t near = 0;
    for (std::size_t lane = 0; lane < width; lane += hn::Lanes(Tag())) {
      const Number parts = hn::Mul(hn::LoadU(Tag(), bounds_.data() + lane), all(inverse_));
      hn::StoreU(parts, Tag(), bounds_.data() + lane);
      std::array<std::uint8_t, 8> bits{};
      hn::StoreMaskBits(Tag(), hn::Not(hn::Gt(parts, all(limit_part_))), bits.data());
      near |= std::uint32_t{bits[0]} << lane;
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
  Bounds bounds_{};
  bool opens_own_ = false;
  std::size_t bucket_ = 0;
  double inverse_ = 1;
  double last_limit_ = 0;
  double limit_part_ = 1;
  std::size_t steady_batches_ = 0;  ///< how many have not lowered the limit by more than a little
};

void run_near(const NearWalk& walk, NearFrontier& frontier, NearQuestion& question) {
  Run(walk, frontier, question).run();
}

NearBounds bounds_of_block(const NearWalk& walk, std::size_t side, std::uint32_t number, std::uint32_t other) {
  NearBounds bounds;
  const Seen box = seen(walk.view(side), walk.tree(side ^ 1).blocks[other >> 3], other & 7U);
  bounds_of(walk.view(side), walk.tree(side).blocks[number], box, bounds.least);
  bounds.other_size = box.size;
  return bounds;
}

}  // namespace
}  // namespace toccata::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(run_near);
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
  HWY_DYNAMIC_DISPATCH(run_near)(*this, frontier, question);
}

NearBounds NearWalk::bounds(std::size_t side, std::uint32_t number, std::uint32_t other) const {
  return HWY_DYNAMIC_DISPATCH(bounds_of_block)(*this, side, number, other);
}

}  // namespace toccata
#endif
