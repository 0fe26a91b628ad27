#include "broad/packed_bvh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "broad/method_cells.hpp"
#include "math/floats.hpp"

namespace toccata {
namespace {

constexpr std::size_t node_width = BvhColumns::width;

/// Apart from every box, whose floats are finite.
constexpr FlatBox nothing{
    {infinite_float, infinite_float, infinite_float}, {-infinite_float, -infinite_float, -infinite_float}, 0};

/// Two zeros before each of 21 bits.
std::uint64_t spread(std::uint64_t bits) {
  bits &= 0x1fffff;
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

double middle(const FlatBox& box, std::size_t axis) {
  return 0.5 * (double{box.lower[axis]} + double{box.upper[axis]});
}

using Places = std::span<Keyed<std::uint32_t>>;

void sort_along(std::span<const FlatBox> boxes, Places places, std::size_t axis) {
  std::sort(places.begin(), places.end(), [&](const auto& one, const auto& other) {
    const FlatBox &a = boxes[one.place], &b = boxes[other.place];
    const double at_a = middle(a, axis), at_b = middle(b, axis);
    return at_a != at_b ? at_a < at_b : a.number < b.number;
  });
}

/// S. T. Leutenegger, M. A. Lopez, J. Edgington, "STR: a simple and efficient algorithm for R-tree packing", 1997.
void sort_and_tile(std::span<const FlatBox> boxes, Places places) {
  const double leaves = std::ceil(static_cast<double>(boxes.size()) / node_width);
  const auto slabs = static_cast<std::size_t>(std::ceil(std::cbrt(leaves)));
  const std::size_t in_row = slabs * node_width, in_slab = slabs * in_row;
  sort_along(boxes, places, 0);
  for (std::size_t slab = 0; slab < places.size(); slab += in_slab) {
    const Places in = places.subspan(slab, std::min(in_slab, places.size() - slab));
    sort_along(boxes, in, 1);
    for (std::size_t row = 0; row < in.size(); row += in_row)
      sort_along(boxes, in.subspan(row, std::min(in_row, in.size() - row)), 2);
  }
}

void end_with_nothing(ColumnStore& store, std::size_t size) {
  for (std::size_t i = size; i < size + node_width; ++i) store.put(i, nothing);
}

/// The box around the sixteen from `first` on; behind the last there are such that count for nothing.
FlatBox around_sixteen(const BoxColumns& columns, std::size_t first) {
  FlatBox around = nothing;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = first; i < first + node_width; ++i) {
      around.lower[axis] = std::min(around.lower[axis], columns.lower[axis][i]);
      around.upper[axis] = std::max(around.upper[axis], columns.upper[axis][i]);
    }
  return around;
}

}  // namespace

std::uint64_t curve_key(const FlatBox& box) {
  const auto cell = [&](std::size_t axis) {
    const float place = 0x1p19F * (2 + (0.5F * box.lower[axis] + 0.5F * box.upper[axis]));
    return spread(static_cast<std::uint32_t>(std::clamp(place, 0.0F, 2097151.0F)));
  };
  return cell(0) << 2 | cell(1) << 1 | cell(2);
}

void sort_along_curve(std::vector<FlatBox>& boxes) {
  std::vector<Keyed<std::uint64_t>> keyed, scratch;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) keyed.push_back({curve_key(boxes[i]), i});
  sort_by_key(keyed, scratch);
  const std::vector<FlatBox> before = boxes;
  for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i] = before[keyed[i].place];
}

void PackedBvh::build(std::span<const FlatBox> boxes, PackingOrder order) {
  keyed_.resize(boxes.size());
  const auto box_at = [&](std::uint32_t place) { return boxes[place]; };
  for (std::uint32_t i = 0; i < boxes.size(); ++i) keyed_[i] = {first_key(boxes[i]), i};
  if (order == PackingOrder::morton)
    sort_by_curve(box_at);
  else
    sort_and_tile(boxes, keyed_);
  lay_out(box_at, [&](std::uint32_t place) { __builtin_prefetch(&boxes[place]); });
}

void PackedBvh::sort_equal(std::vector<Keyed<std::uint64_t>>& equal) {
  std::stable_sort(equal.begin(), equal.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
}

PackedBvh::Level& PackedBvh::first_level(std::size_t size) {
  if (levels_.empty()) levels_.emplace_back();
  levels_.front().size = size;
  levels_.front().store.resize(size + node_width);
  return levels_.front();
}

void PackedBvh::build_levels() {
  depth_ = 1;
  end_with_nothing(levels_.front().store, levels_.front().size);
  while (levels_[depth_ - 1].size > node_width) {
    if (levels_.size() <= depth_) levels_.emplace_back();
    const Level& below = levels_[depth_ - 1];
    Level& level = levels_[depth_];
    level.size = (below.size + node_width - 1) / node_width;
    level.store.resize(level.size + node_width);
    for (std::size_t i = 0; i < level.size; ++i)
      level.store.put(i, around_sixteen(below.store.columns(), i * node_width));
    end_with_nothing(level.store, level.size);
    ++depth_;
  }
}

BvhColumns PackedBvh::columns() const {
  BvhColumns tree{};
  tree.depth = depth_;
  for (std::size_t level = 0; level < depth_; ++level) {
    tree.levels[level] = levels_[level].store.columns();
    tree.sizes[level] = levels_[level].size;
  }
  return tree;
}

void PackedBvh::add_pairs(const Aabb* all, std::size_t begin, std::size_t end, PairBuffer& pairs) const {
  if (begin < end) add_overlaps_in_tree(columns(), all, begin, end, pairs);
}

void PackedBvh::add_pairs_with(const Aabb* all, std::span<const FlatBox> boxes, PairBuffer& pairs) const {
  if (size() > 0) add_overlaps_with_tree(columns(), all, boxes, pairs);
}

void PackedBvh::add_cells(const FloatFrame& frame, BroadPhaseCells& cells) const {
  for (std::size_t level = depth_; level-- > 1;) {
    CellsOfGroup group(cells, fmt::format("tree, level {}", depth_ - 1 - level));
    const ColumnStore& store = levels_[level].store;
    for (std::size_t i = 0; i < levels_[level].size; ++i)
      group.add(box_of_floats(frame, {store.lower(0, i), store.lower(1, i), store.lower(2, i)},
                              {store.upper(0, i), store.upper(1, i), store.upper(2, i)}));
  }
}

void PackedBvh::forget(std::size_t place) { levels_.front().store.put(place, nothing); }

void PackedBvh::drop_scratch() {
  keyed_ = std::vector<Key>();
  sorted_ = std::vector<Key>();
}

std::size_t PackedBvh::bytes() const {
  std::size_t sum = (keyed_.capacity() + sorted_.capacity()) * sizeof(Key);
  for (const Level& level : levels_) sum += level.store.bytes();
  return sum;
}

}  // namespace toccata
