#include "trees/wide_walk.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trees/wide_walk.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes before
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/prefetch.hpp"
#include "trees/prism_directions.hpp"
#include "trees/slanted_lanes.hpp"

#ifndef TOCCATA_WIDE_WALK_TABLE
#define TOCCATA_WIDE_WALK_TABLE
namespace toccata {
namespace {

/// For every set of eight lanes, the numbers of its members, ascending.
constexpr auto lane_orders = [] {
  std::array<std::array<std::uint8_t, WideBlock::width>, 256> orders{};
  for (unsigned set = 0; set < 256; ++set)
    for (std::size_t lane = 0, next = 0; lane < WideBlock::width; ++lane)
      if ((set >> lane & 1U) != 0) orders[set][next++] = static_cast<std::uint8_t>(lane);
  return orders;
}();

}  // namespace
}  // namespace toccata
#endif

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

using Words = hn::Rebind<std::uint32_t, Floats>;
constexpr std::size_t double_lanes = hn::MaxLanes(tag);

/// One box of a block, each of its numbers in all lanes.
struct BoxInAllLanes {
  BoxInAllLanes(const WideBlock& block, std::size_t lane)
      : cx(in_all(block.centre[0][lane])),
        cy(in_all(block.centre[1][lane])),
        cz(in_all(block.centre[2][lane])),
        ex(in_all(block.extent[0][lane])),
        ey(in_all(block.extent[1][lane])),
        ez(in_all(block.extent[2][lane])) {}
  static HWY_INLINE Float in_all(float x) { return hn::Set(Floats(), x); }
  Float cx, cy, cz, ex, ey, ez;
};

/// A box of the other tree, seen along the axes of the own one: it lies within at ± reach.
struct SeenBox {
  alignas(64) std::array<float, WideAxes::most> at;
  alignas(64) std::array<float, WideAxes::most> reach;
  float size;  ///< in the own tree's units, roughly
};

// The walk's own rounding, docs/design/fast-core.md: 2^-24 is the unit roundoff of floats.
constexpr float walk_slack = 0x1p-20F;

/// What every step needs, by tree: its blocks, and its axes.
struct WalkSides {
  explicit WalkSides(const WideWalk& walk)
      : blocks{walk.tree(0).blocks.data(), walk.tree(1).blocks.data()}, axes{&walk.axes(0), &walk.axes(1)} {}
  const WideBlock* blocks[2];
  const WideAxes* axes[2];
};

/// A block of one tree and a box of the other, that are to be compared.
struct WalkEntry {
  WalkEntry() = default;
  HWY_INLINE WalkEntry(const WalkSides& sides, std::uint32_t block_of_side, std::uint32_t lane_of_other)
      : side(block_of_side & 1U),
        block_number(block_of_side >> 1),
        box_number(lane_of_other),
        block(sides.blocks[side] + block_number),
        other(sides.blocks[side ^ 1U] + (lane_of_other >> 3)),
        axes(sides.axes[side]) {}
  [[nodiscard]] std::size_t lane() const { return box_number & 7U; }

  std::uint32_t side;
  std::uint32_t block_number;
  std::uint32_t box_number;  ///< block · 8 + lane, of the other tree
  const WideBlock* block;
  const WideBlock* other;
  const WideAxes* axes;
};

/// Two rigidly posed meshes have three slanted axes, and none when they are turned alike, as a mesh is to itself; the
/// other number stands for any.
constexpr std::size_t usual_count = 6;
constexpr std::size_t alike_count = WideAxes::straight;
constexpr std::size_t any_count = WideAxes::most;

/// The first lanes, as many as doubles fit into a vector.
HWY_INLINE Number as_doubles(Float values) {
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_AVX3
  return hn::PromoteTo(tag, values);
#else
  return hn::PromoteTo(tag, hn::LowerHalf(values));
#endif
}

/// The middle of the box along the axes first, first + 1 …, as many as doubles fit into a vector.
HWY_INLINE auto some_middles(const WideAxes& axes, const BoxInAllLanes& box, std::size_t first) {
  constexpr Tag d;
  const auto product = [&](std::size_t i, Float centre)
                           HWY_ATTR { return hn::Mul(hn::Load(d, axes.other[i].data() + first), as_doubles(centre)); };
  const auto at = hn::Add(hn::Add(hn::Add(product(0, box.cx), product(1, box.cy)), product(2, box.cz)),
                          hn::Load(d, axes.offset.data() + first));
  return hn::DemoteTo(hn::CappedTag<float, double_lanes>(), at);
}

/// As many as floats fit. Joined in registers: reading two stores as one would wait until both have reached the cache.
HWY_INLINE Float middles(const WideAxes& axes, const BoxInAllLanes& box, std::size_t first) {
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_AVX3
  return some_middles(axes, box, first);
#else
  return hn::Combine(Floats(), some_middles(axes, box, first + double_lanes), some_middles(axes, box, first));
#endif
}

/// How far from its middle the box reaches along them.
HWY_INLINE Float reaches(const WideAxes& axes, const BoxInAllLanes& box, std::size_t first, Float middle) {
  const Floats d;
  const auto product = [&](std::size_t i, Float extent)
                           HWY_ATTR { return hn::Mul(hn::Load(d, axes.other_size[i].data() + first), extent); };
  const auto reach = hn::Add(hn::Add(product(0, box.ex), product(1, box.ey)), product(2, box.ez));
  const auto magnitude = hn::Add(hn::Add(hn::Load(d, axes.own_size.data() + first), hn::Abs(middle)), reach);
  const auto padded = hn::Add(reach, hn::Load(d, axes.pad.data() + first));
  return hn::Add(padded, hn::Mul(hn::Set(d, walk_slack), magnitude));
}

template <std::size_t axis_count>
HWY_INLINE std::size_t count_of(const WideAxes& axes) {
  return axis_count == any_count ? axes.count : axis_count;
}

/// Writes how an entry's box is seen.
template <std::size_t axis_count>
HWY_INLINE void look(const WalkEntry& entry, SeenBox& seen) {
  const WideAxes& axes = *entry.axes;
  const BoxInAllLanes box(*entry.other, entry.lane());
  for (std::size_t first = 0; first < count_of<axis_count>(axes); first += part_lanes) {
    const auto middle = middles(axes, box, first);
    hn::Store(middle, Floats(), seen.at.data() + first);
    hn::Store(reaches(axes, box, first, middle), Floats(), seen.reach.data() + first);
  }
  const auto size = hn::Add(hn::Add(box.ex, box.ey), box.ez);
  seen.size = hn::GetLane(hn::Mul(size, hn::Set(Floats(), axes.other_is_larger_by)));
}

struct Compared {
  unsigned apart;   ///< lanes that do not meet the box
  unsigned larger;  ///< lanes that are at least as large as it
  unsigned small;   ///< lanes that are small beside it, so that the region of an item tells more
  unsigned items;   ///< lanes that are single items
};

/// One box against the eight of a block.
template <std::size_t axis_count>
HWY_INLINE Compared compare(const WalkEntry& entry, const SeenBox& box) {
  const WideBlock& block = *entry.block;
  const WideAxes& axes = *entry.axes;
  Compared result{0, 0, 0, 0};
  for (std::size_t part = 0; part < block_parts; ++part) {
    const std::size_t first = part * part_lanes;
    const BlockLanes l(block, first);
    auto apart =
        hn::Or(hn::Or(is_beyond(l.cx, l.ex, box.at[0], box.reach[0]), is_beyond(l.cy, l.ey, box.at[1], box.reach[1])),
               is_beyond(l.cz, l.ez, box.at[2], box.reach[2]));
    const auto beyond = [&](std::size_t i)
                            HWY_ATTR { return is_beyond_along(axes.slanted[i], l, box.at[i], box.reach[i]); };
    if constexpr (axis_count == usual_count) {
      apart = hn::Or(apart, hn::Or(hn::Or(beyond(3), beyond(4)), beyond(5)));
    } else if constexpr (axis_count == any_count) {
      for (std::size_t i = WideAxes::straight; i < axes.count; ++i) apart = hn::Or(apart, beyond(i));
    }
    result.apart |= bits_of(Floats(), apart) << first;
    const hn::RebindToSigned<Words> whole;
    const auto children = hn::Load(whole, block.child.data() + first);
    result.items |= bits_of(Floats(), hn::RebindMask(Floats(), hn::Lt(children, hn::Zero(whole)))) << first;
    const auto size = hn::Add(hn::Add(l.ex, l.ey), l.ez);
    result.larger |= bits_of(Floats(), hn::Ge(size, hn::Set(Floats(), box.size))) << first;
    result.small |= bits_of(Floats(), hn::Lt(size, hn::Set(Floats(), small_beside_item * box.size))) << first;
  }
  return result;
}

/// The chosen lanes first, in order; what comes after them means nothing. Highway's own way for AVX2 and SSE4 copies
/// its table to the stack at every call when g++ compiles it; the instruction of AVX-512 is not faster than this.
HWY_INLINE hn::Vec<Words> compressed(hn::Vec<Words> values, unsigned chosen) {
  const Words d;
  const hn::CappedTag<std::uint8_t, part_lanes> bytes;
  const auto order = hn::PromoteTo(d, hn::LoadU(bytes, lane_orders[chosen].data()));
  return hn::TableLookupLanes(values, hn::IndicesFromVec(d, order));
}

/// Writes the chosen ones of eight values, and up to eight more words that mean nothing. Without branches: which lanes
/// are chosen cannot be foreseen. `values(first)` are those of the lanes first, first + 1 …
template <class Values>
HWY_INLINE void append(const Values& values, unsigned chosen, std::uint32_t* HWY_RESTRICT to) {
  for (std::size_t part = 0; part < block_parts; ++part) {
    const unsigned here = chosen >> part * part_lanes & part_mask;
    hn::StoreU(compressed(values(part * part_lanes), here), Words(), to);
    to += std::popcount(here);
  }
}

HWY_INLINE void append_same(std::uint32_t value, std::uint32_t* HWY_RESTRICT to) {
  const Words d;
  for (std::size_t part = 0; part < block_parts; ++part) hn::StoreU(hn::Set(d, value), d, to + part * part_lanes);
}

/// Where a frontier grows. Kept apart from it so that the compiler need not store every change.
struct FrontierEnds {
  std::uint32_t* blocks;
  std::uint32_t* boxes;
  std::uint32_t* below;
  Index* beside;
  std::array<Index*, 2> places;
  unsigned regions;  ///< all bits where single items have regions, otherwise 0
  std::size_t size;
  std::size_t below_count;
  std::size_t pair_count;
  std::size_t tests;
};

/// Files what meets, of the lanes that `wanted` names: a pair of items, a pair of which the larger is to be opened, or
/// what is below a box that is smaller than a single item.
HWY_INLINE void file(const WalkEntry& entry, const Compared& compared, unsigned wanted, FrontierEnds& f) {
  const WideBlock& block = *entry.block;
  const std::uint32_t side = entry.side, other_side = side ^ 1U;
  const auto other_child = static_cast<std::uint32_t>(entry.other->child[entry.lane()]);

  const Words d;
  const auto child = [&](std::size_t first) HWY_ATTR {
    return hn::BitCast(d, hn::Load(hn::RebindToSigned<Words>(), block.child.data() + first));
  };
  const unsigned lanes_in_use = ((1U << block.count) - 1U) & wanted;
  const unsigned hits = ~compared.apart & lanes_in_use;
  const unsigned other_is_item = 0U - (other_child >> 31);
  const unsigned below = hits & ~compared.items & other_is_item & compared.small & f.regions;
  const unsigned opens_own = hits & ~compared.items & (other_is_item | compared.larger) & ~below;
  const unsigned opens_other = hits & ~opens_own & ~other_is_item;
  const unsigned found = hits & compared.items & other_is_item;

  std::uint32_t* const blocks_end = f.blocks + f.size;
  std::uint32_t* const boxes_end = f.boxes + f.size;
  const int own_count = std::popcount(opens_own), other_count = std::popcount(opens_other);
  append([&](std::size_t first) HWY_ATTR { return hn::Or(hn::ShiftLeft<1>(child(first)), hn::Set(d, side)); },
         opens_own, blocks_end);
  append_same(entry.box_number, boxes_end);
  append_same(other_child << 1 | other_side, blocks_end + own_count);
  append([&](std::size_t first)
             HWY_ATTR { return hn::Iota(d, (entry.block_number << 3) + static_cast<std::uint32_t>(first)); },
         opens_other, boxes_end + own_count);
  f.size += static_cast<std::size_t>(own_count + other_count);
  append([&](std::size_t first) HWY_ATTR { return hn::Not(child(first)); }, found, f.places[side] + f.pair_count);
  append_same(~other_child, f.places[other_side] + f.pair_count);
  f.pair_count += static_cast<std::size_t>(std::popcount(found));
  f.tests += static_cast<std::size_t>(std::popcount(lanes_in_use));
  if (HWY_UNLIKELY(below != 0)) {
    append([&](std::size_t first) HWY_ATTR { return hn::Or(hn::ShiftLeft<1>(child(first)), hn::Set(d, side)); }, below,
           f.below + f.below_count);
    append_same(~other_child, f.beside + f.below_count);
    f.below_count += static_cast<std::size_t>(std::popcount(below));
  }
}

template <std::size_t axis_count>
HWY_INLINE void step(const WalkEntry& entry, unsigned wanted, FrontierEnds& f) {
  SeenBox seen;
  look<axis_count>(entry, seen);
  file(entry, compare<axis_count>(entry, seen), wanted, f);
}

/// So many entries are taken off the frontier's end at once.
constexpr std::size_t entries_at_once = 8;

/// Room for what so many steps may add, and for the words that `append` writes beyond.
FrontierEnds room_for(WideFrontier& f, std::size_t steps) {
  const std::size_t entries = f.size + 8 * steps + 16, pairs = f.pair_count + 8 * steps + 16;
  const std::size_t below = f.below_count + 8 * steps + 16;
  // Each is looked at on its own: where memory ran out between two, a later call must not trust the first.
  for (auto* words : {&f.blocks, &f.boxes})
    if (words->size() < entries) words->resize(2 * entries);
  for (auto& places : f.places)
    if (places.size() < pairs) places.resize(2 * pairs);
  if (f.below.size() < below) f.below.resize(2 * below);
  if (f.beside.size() < below) f.beside.resize(2 * below);
  return {f.blocks.data(),
          f.boxes.data(),
          f.below.data(),
          f.beside.data(),
          {f.places[0].data(), f.places[1].data()},
          f.has_regions ? ~0U : 0U,
          f.size,
          f.below_count,
          f.pair_count,
          0};
}

void take_over(const FrontierEnds& ends, WideFrontier& f) {
  f.size = ends.size;
  f.below_count = ends.below_count;
  f.pair_count = ends.pair_count;
  f.counts.volume_tests += ends.tests;
}

/// Hands the pairs on when there are enough.
void hand_on(const WideWalk& walk, WideFrontier& f, WideVisitor& visitor, std::size_t enough) {
  if (f.pair_count < enough || f.pair_count == 0) return;
  f.pairs.resize(f.pair_count);
  const std::vector<Index>&a = walk.tree(0).items, &b = walk.tree(1).items;
  for (std::size_t i = 0; i < f.pair_count; ++i) f.pairs[i] = {a[f.places[0][i]], b[f.places[1][i]]};
  if (f.within_one)
    for (ItemPair& pair : f.pairs)
      if (pair.second < pair.first) std::swap(pair.first, pair.second);
  f.counts.items += f.pair_count;
  f.pair_count = 0;
  f.batch = std::min(2 * f.batch, WideWalk::largest_batch);
  if (!visitor.visit(f.pairs)) f.ended = true;
}

/// A pair that a region left.
void add_found(const WideWalk& walk, WideFrontier& f, std::size_t side, Index own, Index other, WideVisitor& visitor) {
  for (auto& places : f.places)
    if (places.size() <= f.pair_count) places.resize(2 * f.pair_count + 16);
  f.places[side][f.pair_count] = own;
  f.places[side ^ 1U][f.pair_count++] = other;
  hand_on(walk, f, visitor, f.batch);
}

/// What is below boxes that are smaller than an item's, against the item's region. An item that is large beside what is
/// near it has those boxes within its own, however far its surface is from them.
void compare_regions(const WideWalk& walk, WideFrontier& f, WideVisitor& visitor) {
  WideProbe region;
  for (std::size_t i = 0; i < f.below_count && !f.ended; ++i) {
    const std::uint32_t side = f.below[i] & 1U;
    const Index other = f.beside[i];
    if (i == 0 || other != f.beside[i - 1] || side != (f.below[i - 1] & 1U))
      region = visitor.region_of(side ^ 1U, walk.tree(side ^ 1U).items[other]);
    const auto find_own = [&](Index own) {
      add_found(walk, f, side, own, other, visitor);
      return !f.ended;
    };
    f.counts.volume_tests += walk_probe_below(walk.tree(side), f.below[i] >> 1, region, find_own);
  }
  f.below_count = 0;
}

/// The entries of a block, step by step. One stage after another for all: within a stage nothing waits for anything, so
/// the processor works on many entries at once, while it could not see beyond the end of one whole step. All are read
/// before the first is filed, which may be where they were.
template <std::size_t axis_count>
class Stages {
 public:
  HWY_INLINE void run(const WalkSides& sides, const std::uint32_t* blocks, const std::uint32_t* boxes,
                      std::size_t count, FrontierEnds& ends) {
    for (std::size_t i = 0; i < count; ++i) {
      entries_[i] = WalkEntry(sides, blocks[i], boxes[i]);
      prefetch(*entries_[i].block);
      look<axis_count>(entries_[i], seen_[i]);
    }
    for (std::size_t i = 0; i < count; ++i) compared_[i] = compare<axis_count>(entries_[i], seen_[i]);
    for (std::size_t i = 0; i < count; ++i) file(entries_[i], compared_[i], 0xFF, ends);
  }

 private:
  std::array<WalkEntry, entries_at_once> entries_;
  std::array<SeenBox, entries_at_once> seen_;
  std::array<Compared, entries_at_once> compared_;
};

/// Walks until the frontier is empty; a last batch that is not full stays.
template <std::size_t axis_count>
void drain_with(const WideWalk& walk, WideFrontier& f, WideVisitor& visitor) {
  const WalkSides sides(walk);
  Stages<axis_count> stages;
  while (f.size > 0 && !f.ended) {
    const std::size_t count = std::min(f.size, entries_at_once);
    f.size -= count;
    FrontierEnds ends = room_for(f, entries_at_once);
    stages.run(sides, ends.blocks + f.size, ends.boxes + f.size, count, ends);
    take_over(ends, f);
    compare_regions(walk, f, visitor);
    hand_on(walk, f, visitor, f.batch);
  }
}

void drain(const WideWalk& walk, WideFrontier& f, WideVisitor& visitor) {
  if (walk.axes(0).count == usual_count && walk.axes(1).count == usual_count)
    drain_with<usual_count>(walk, f, visitor);
  else if (walk.axes(0).count == alike_count && walk.axes(1).count == alike_count)
    drain_with<alike_count>(walk, f, visitor);
  else
    drain_with<any_count>(walk, f, visitor);
}

void run_all(const WideWalk& walk, WideFrontier& f, WideVisitor& visitor) {
  drain(walk, f, visitor);
  if (!f.ended) hand_on(walk, f, visitor, 1);
}

/// Every entry once; what they lead to comes after them all and then in their place.
void run_level(const WideWalk& walk, WideFrontier& f, WideVisitor& visitor) {
  const std::size_t count = f.size;
  for (std::size_t i = 0; i < count && !f.ended; ++i) {
    FrontierEnds ends = room_for(f, 1);
    step<any_count>(WalkEntry(WalkSides(walk), f.blocks[i], f.boxes[i]), 0xFF, ends);
    take_over(ends, f);
    compare_regions(walk, f, visitor);
    hand_on(walk, f, visitor, f.batch);
  }
  for (auto* words : {&f.blocks, &f.boxes})
    std::copy_n(words->begin() + static_cast<std::ptrdiff_t>(count), f.size - count, words->begin());
  f.size -= count;
  if (!f.ended) hand_on(walk, f, visitor, 1);
}

/// The lanes of each of these blocks with each other, and what is below them.
void run_all_self(const WideWalk& walk, WideFrontier& f, BlockRange range, WideVisitor& visitor) {
  const std::vector<WideBlock>& blocks = walk.tree(0).blocks;
  for (std::uint32_t block = range.first; block < range.last && !f.ended; ++block) {
    FrontierEnds ends = room_for(f, WideBlock::width);
    for (std::uint32_t lane = 0; lane + 1 < blocks[block].count; ++lane)
      step<any_count>(WalkEntry(WalkSides(walk), block << 1, (block << 3) + lane), 0xFFU << (lane + 1) & 0xFFU, ends);
    take_over(ends, f);
    compare_regions(walk, f, visitor);
    hand_on(walk, f, visitor, f.batch);
    if (f.size >= entries_at_once && !f.ended) drain(walk, f, visitor);
  }
  run_all(walk, f, visitor);
}

}  // namespace
}  // namespace toccata::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {
namespace {

HWY_EXPORT(run_all);
HWY_EXPORT(run_level);
HWY_EXPORT(run_all_self);

/// To at least so many.
template <class T>
void grow(std::vector<T>& words, std::size_t size) {
  if (words.size() < size) words.resize(size);
}

}  // namespace

void WideFrontier::grow_like(const WideFrontier& other) {
  grow(blocks, other.blocks.size());
  grow(boxes, other.boxes.size());
  for (std::size_t side = 0; side < 2; ++side) grow(places[side], other.places[side].size());
  grow(below, other.below.size());
  grow(beside, other.beside.size());
  pairs.reserve(other.pairs.capacity());
}

void WideWalk::start(WideFrontier& frontier, std::size_t first_batch) const {
  frontier.size = frontier.pair_count = frontier.below_count = 0;
  frontier.batch = first_batch;
  frontier.ended = frontier.within_one = false;
  frontier.counts = {};
  if (tree(0).blocks.empty() || tree(1).blocks.empty()) return;
  const std::uint32_t boxes = tree(1).blocks.front().count;
  for (auto* words : {&frontier.blocks, &frontier.boxes})
    if (words->size() < boxes) words->resize(256);
  for (std::uint32_t lane = 0; lane < boxes; ++lane) {
    frontier.blocks[lane] = 0;
    frontier.boxes[lane] = lane;
  }
  frontier.size = boxes;
}

void WideWalk::spread(WideFrontier& frontier, std::size_t entries, WideVisitor& visitor) const {
  frontier.has_regions = visitor.has_regions();
  while (frontier.size > 0 && frontier.size < entries && !frontier.ended)
    HWY_DYNAMIC_DISPATCH(run_level)(*this, frontier, visitor);
}

void WideWalk::run(WideFrontier& frontier, WideVisitor& visitor) const {
  frontier.has_regions = visitor.has_regions();
  HWY_DYNAMIC_DISPATCH(run_all)(*this, frontier, visitor);
}

void WideWalk::run_self(WideFrontier& frontier, std::size_t first_batch, WideVisitor& visitor) const {
  run_self(frontier, first_batch, {0, static_cast<std::uint32_t>(tree(0).blocks.size())}, visitor);
}

void WideWalk::run_self(WideFrontier& frontier, std::size_t first_batch, BlockRange blocks,
                        WideVisitor& visitor) const {
  start(frontier, first_batch);
  frontier.size = 0;
  frontier.within_one = true;
  frontier.has_regions = visitor.has_regions();
  HWY_DYNAMIC_DISPATCH(run_all_self)(*this, frontier, blocks, visitor);
}

}  // namespace toccata
#endif
