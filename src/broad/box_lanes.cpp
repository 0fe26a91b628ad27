#include "broad/box_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "broad/box_lanes.cpp"
#include <hwy/foreach_target.h>
// foreach_target comes before
#include <hwy/highway.h>

#include <algorithm>
#include <cstring>

#include "math/lanes.hpp"

#ifndef TOCCATA_BROAD_BOX_LANES_ONCE
#define TOCCATA_BROAD_BOX_LANES_ONCE
namespace toccata {
namespace {

/// Pairs on their way into a buffer, a vector of them at a time.
struct PairWriter {
  PairBuffer& pairs;
  Index* ones = nullptr;
  Index* others = nullptr;
  std::size_t count = 0;
  std::size_t room = 0;

  void refill(std::size_t more) {
    flush();
    const PairBuffer::Place place = pairs.room_for(more);
    ones = place.ones;
    others = place.others;
    room = place.room;
  }
  void flush() {
    pairs.added(count);
    count = 0;
    room = 0;
  }
};

/// Those of the lanes in `bits` whose boxes overlap in doubles.
inline std::uint32_t overlapping_lanes(const LaidOut& laid, Index number, const Index* numbers, std::uint32_t bits) {
  std::uint32_t found = 0;
  for (std::uint32_t rest = bits; rest != 0; rest &= rest - 1) {
    const std::uint32_t lane = rest & (~rest + 1);
    if (overlap(laid.boxes[number], laid.boxes[numbers[__builtin_ctz(rest)]])) found |= lane;
  }
  return found;
}

}  // namespace
}  // namespace toccata
#endif

HWY_BEFORE_NAMESPACE();
namespace toccata::HWY_NAMESPACE {
namespace {

using BoxFloats = hn::CappedTag<float, 16>;
using BoxWords = hn::Rebind<std::uint32_t, BoxFloats>;
using BoxFloat = hn::Vec<BoxFloats>;
using BoxMask = hn::Mask<BoxFloats>;

HWY_INLINE std::size_t boxes_at_once() { return hn::Lanes(BoxFloats()); }

/// One box in every lane, or a box in each.
struct Boxes {
  BoxFloat lower_x, lower_y, lower_z, upper_x, upper_y, upper_z;
};

HWY_INLINE Boxes everywhere(const FlatBox& box) {
  const BoxFloats d;
  return {hn::Set(d, box.lower[0]), hn::Set(d, box.lower[1]), hn::Set(d, box.lower[2]),
          hn::Set(d, box.upper[0]), hn::Set(d, box.upper[1]), hn::Set(d, box.upper[2])};
}
HWY_INLINE Boxes everywhere(const BoxColumns& c, std::size_t i) {
  const BoxFloats d;
  return {hn::Set(d, c.lower[0][i]), hn::Set(d, c.lower[1][i]), hn::Set(d, c.lower[2][i]),
          hn::Set(d, c.upper[0][i]), hn::Set(d, c.upper[1][i]), hn::Set(d, c.upper[2][i])};
}
HWY_INLINE Boxes boxes_at(const BoxColumns& c, std::size_t i) {
  const BoxFloats d;
  return {hn::LoadU(d, c.lower[0] + i), hn::LoadU(d, c.lower[1] + i), hn::LoadU(d, c.lower[2] + i),
          hn::LoadU(d, c.upper[0] + i), hn::LoadU(d, c.upper[1] + i), hn::LoadU(d, c.upper[2] + i)};
}

/// How far the boxes can move before they are apart along some axis; negative where they are. 0 exactly where an end
/// is equal to one of the other's.
HWY_INLINE BoxFloat room_between(const Boxes& a, const Boxes& b) {
  const BoxFloat x = hn::Min(hn::Sub(a.upper_x, b.lower_x), hn::Sub(b.upper_x, a.lower_x));
  const BoxFloat y = hn::Min(hn::Sub(a.upper_y, b.lower_y), hn::Sub(b.upper_y, a.lower_y));
  const BoxFloat z = hn::Min(hn::Sub(a.upper_z, b.lower_z), hn::Sub(b.upper_z, a.lower_z));
  return hn::Min(hn::Min(x, y), z);
}

HWY_INLINE BoxMask first_lanes(std::size_t count) { return hn::FirstN(BoxFloats(), count); }

HWY_INLINE BoxMask mask_of_bits(std::uint32_t bits) {
  std::uint8_t bytes[8] = {};
  std::memcpy(bytes, &bits, sizeof bits);
  return hn::LoadMaskBits(BoxFloats(), bytes);
}

/// Writes the pairs of box `number` with those among `numbers` that have room left, of the lanes asked about.
HWY_INLINE void put(const LaidOut& laid, Index number, const Index* numbers, BoxFloat room, BoxMask asked,
                    PairWriter& out) {
  const BoxFloats d;
  const BoxWords words;
  BoxMask found = hn::And(hn::Ge(room, hn::Zero(d)), asked);
  const BoxMask equal = hn::And(hn::Eq(room, hn::Zero(d)), asked);
  if (HWY_UNLIKELY(!hn::AllFalse(d, equal))) {
    const std::uint32_t unsure = bits_of(BoxFloats(), equal);
    found = mask_of_bits((bits_of(BoxFloats(), found) & ~unsure) | overlapping_lanes(laid, number, numbers, unsure));
  }
  if (HWY_UNLIKELY(out.count + boxes_at_once() > out.room)) out.refill(boxes_at_once());
  hn::StoreU(hn::Set(words, number), words, out.ones + out.count);
  hn::StoreU(hn::Compress(hn::LoadU(words, numbers), hn::RebindMask(words, found)), words, out.others + out.count);
  out.count += hn::CountTrue(d, found);
}

HWY_INLINE void put_run(const LaidOut& laid, const Boxes& box, Index number, std::size_t begin, std::size_t end,
                        PairWriter& out) {
  for (std::size_t j = begin; j < end; j += boxes_at_once())
    put(laid, number, laid.columns.number + j, room_between(box, boxes_at(laid.columns, j)), first_lanes(end - j), out);
}

void behind(const LaidOut& laid, std::size_t begin, std::size_t end, const std::uint32_t* ends, PairBuffer& pairs) {
  PairWriter out{pairs};
  for (std::size_t i = begin; i < end; ++i)
    put_run(laid, everywhere(laid.columns, i), laid.columns.number[i], i + 1, ends[i - begin], out);
  out.flush();
}

void in_tile(const LaidOut& laid, const std::uint32_t* sides, std::size_t begin, std::size_t end,
             const std::uint32_t* ends, PairBuffer& pairs) {
  const BoxWords words;
  PairWriter out{pairs};
  for (std::size_t i = begin; i < end; ++i) {
    const Boxes box = everywhere(laid.columns, i);
    const auto own = hn::Set(words, sides[i]);
    for (std::size_t j = i + 1; j < ends[i - begin]; j += boxes_at_once()) {
      const auto shared = hn::And(own, hn::LoadU(words, sides + j));
      const BoxMask ours = hn::RebindMask(BoxFloats(), hn::Eq(shared, hn::Zero(words)));
      put(laid, laid.columns.number[i], laid.columns.number + j, room_between(box, boxes_at(laid.columns, j)),
          hn::And(ours, first_lanes(ends[i - begin] - j)), out);
    }
  }
  out.flush();
}

void with_one(const LaidOut& laid, const FlatBox& box, std::size_t begin, std::size_t end, PairBuffer& pairs) {
  PairWriter out{pairs};
  put_run(laid, everywhere(box), box.number, begin, end, out);
  out.flush();
}

/// All boxes of a cell with all in a row of cells.
HWY_INLINE void put_rows(const LaidOut& laid, std::size_t cell_begin, std::size_t cell_end, std::size_t begin,
                         std::size_t end, PairWriter& out) {
  for (std::size_t j = begin; j < end; j += boxes_at_once()) {
    const Boxes row = boxes_at(laid.columns, j);
    const BoxMask asked = first_lanes(end - j);
    for (std::size_t i = cell_begin; i < cell_end; ++i)
      put(laid, laid.columns.number[i], laid.columns.number + j, room_between(everywhere(laid.columns, i), row), asked,
          out);
  }
}

void of_cells(const CellRows& rows, std::size_t begin, std::size_t end, PairBuffer& pairs) {
  PairWriter out{pairs};
  const std::size_t row = rows.cells_z, slab = row * rows.cells_y;
  const std::uint32_t* starts = rows.starts;
  for (std::size_t cell = begin; cell < end; ++cell) {
    const std::size_t first = starts[cell], last = starts[cell + 1];
    if (first == last) continue;
    const std::size_t z = cell % row, y = cell / row % rows.cells_y, x = cell / slab;
    const std::size_t before = z > 0 ? 1 : 0, after = z + 1 < row ? 2 : 1;
    for (std::size_t i = first; i < last; ++i)
      put_run(rows.laid, everywhere(rows.laid.columns, i), rows.laid.columns.number[i], i + 1, starts[cell + after],
              out);
    const auto put_row = [&](std::size_t of) HWY_ATTR {
      put_rows(rows.laid, first, last, starts[of - before], starts[of + after], out);
    };
    if (y + 1 < rows.cells_y) put_row(cell + row);
    if (x + 1 == rows.cells_x) continue;
    if (y > 0) put_row(cell + slab - row);
    put_row(cell + slab);
    if (y + 1 < rows.cells_y) put_row(cell + slab + row);
  }
  out.flush();
}

/// The pairs of a box with those from place `behind` on.
HWY_INLINE void put_from_tree(const BvhColumns& tree, const LaidOut& items, const Boxes& box, Index number,
                              std::size_t behind, PairWriter& out) {
  constexpr std::size_t width = BvhColumns::width;
  struct Node {
    std::size_t level, first;
  };
  // At each level all nodes of a block may wait, one of which is gone into.
  Node stack[BvhColumns::most_levels * width];
  std::size_t waiting = 0;
  stack[waiting++] = {tree.depth - 1, 0};
  std::size_t reach[BvhColumns::most_levels];  // the node of each level that place `behind` is in
  for (std::size_t level = 0, place = behind; level < tree.depth; ++level, place /= width) reach[level] = place;
  while (waiting > 0) {
    const Node node = stack[--waiting];
    for (std::size_t first = node.first; first < node.first + width; first += boxes_at_once()) {
      if (node.level == 0) {
        if (first + boxes_at_once() <= behind) continue;
        const BoxMask asked = first < behind ? hn::Not(first_lanes(behind - first)) : first_lanes(boxes_at_once());
        put(items, number, items.columns.number + first, room_between(box, boxes_at(items.columns, first)), asked, out);
        continue;
      }
      const BoxFloat room = room_between(box, boxes_at(tree.levels[node.level], first));
      for (std::uint32_t rest = bits_of(BoxFloats(), hn::Ge(room, hn::Zero(BoxFloats()))); rest != 0;
           rest &= rest - 1) {
        const std::size_t child = first + static_cast<std::size_t>(__builtin_ctz(rest));
        if (child >= reach[node.level]) stack[waiting++] = {node.level - 1, child * width};
      }
    }
  }
}

void in_tree(const BvhColumns& tree, const Aabb* boxes, std::size_t begin, std::size_t end, PairBuffer& pairs) {
  PairWriter out{pairs};
  const LaidOut items{tree.levels[0], boxes};
  for (std::size_t i = begin; i < end; ++i)
    put_from_tree(tree, items, everywhere(items.columns, i), items.columns.number[i], i + 1, out);
  out.flush();
}

void with_tree(const BvhColumns& tree, const Aabb* all, std::span<const FlatBox> boxes, PairBuffer& pairs) {
  PairWriter out{pairs};
  for (const FlatBox& box : boxes) put_from_tree(tree, {tree.levels[0], all}, everywhere(box), box.number, 0, out);
  out.flush();
}

}  // namespace
}  // namespace toccata::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace toccata {

HWY_EXPORT(behind);
HWY_EXPORT(in_tile);
HWY_EXPORT(with_one);
HWY_EXPORT(of_cells);
HWY_EXPORT(in_tree);
HWY_EXPORT(with_tree);

void add_overlaps_behind(const LaidOut& laid, std::size_t begin, std::size_t end, const std::uint32_t* ends,
                         PairBuffer& pairs) {
  HWY_DYNAMIC_DISPATCH(behind)(laid, begin, end, ends, pairs);
}
void add_overlaps_in_tile(const LaidOut& laid, const std::uint32_t* sides, std::size_t begin, std::size_t end,
                          const std::uint32_t* ends, PairBuffer& pairs) {
  HWY_DYNAMIC_DISPATCH(in_tile)(laid, sides, begin, end, ends, pairs);
}
void add_overlaps_with(const LaidOut& laid, const FlatBox& box, std::size_t begin, std::size_t end, PairBuffer& pairs) {
  HWY_DYNAMIC_DISPATCH(with_one)(laid, box, begin, end, pairs);
}
void add_overlaps_of_cells(const CellRows& rows, std::size_t begin, std::size_t end, PairBuffer& pairs) {
  HWY_DYNAMIC_DISPATCH(of_cells)(rows, begin, end, pairs);
}

void add_overlaps_in_tree(const BvhColumns& tree, const Aabb* boxes, std::size_t begin, std::size_t end,
                          PairBuffer& pairs) {
  HWY_DYNAMIC_DISPATCH(in_tree)(tree, boxes, begin, end, pairs);
}
void add_overlaps_with_tree(const BvhColumns& tree, const Aabb* all, std::span<const FlatBox> boxes,
                            PairBuffer& pairs) {
  HWY_DYNAMIC_DISPATCH(with_tree)(tree, all, boxes, pairs);
}

}  // namespace toccata
#endif
