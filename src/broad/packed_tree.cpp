#include "broad/packed_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "broad/method_cells.hpp"

namespace toccata {
namespace {

constexpr std::size_t width = TreeColumns::width;

/// Apart from every box, whose floats are finite.
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr FlatBox nothing{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}, 0};

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

/// Where the middles lie; outliers may be cut off.
class MortonOrder {
 public:
  explicit MortonOrder(std::span<const FlatBox> boxes) {
    std::array<double, 3> low{}, high{};
    double range = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::numeric_limits<double>::infinity();
      high[axis] = -low[axis];
      for (const FlatBox& box : boxes) {
        low[axis] = std::min(low[axis], middle(box, axis));
        high[axis] = std::max(high[axis], middle(box, axis));
      }
      low_[axis] = low[axis];
      range = std::max(range, high[axis] - low[axis]);
    }
    per_cell_ = range > 0 ? std::min(0x1fffff / range, 1e300) : 0;
  }
  [[nodiscard]] std::uint64_t key(const FlatBox& box) const {
    return spread(cell(box, 0)) << 2 | spread(cell(box, 1)) << 1 | spread(cell(box, 2));
  }

 private:
  [[nodiscard]] std::uint64_t cell(const FlatBox& box, std::size_t axis) const {
    return static_cast<std::uint64_t>(std::clamp((middle(box, axis) - low_[axis]) * per_cell_, 0.0, 2097151.0));
  }
  std::array<double, 3> low_{};
  double per_cell_ = 0;
};

void sort_along(std::span<FlatBox> boxes, std::size_t axis) {
  std::sort(boxes.begin(), boxes.end(), [axis](const FlatBox& a, const FlatBox& b) {
    const double at_a = middle(a, axis), at_b = middle(b, axis);
    return at_a != at_b ? at_a < at_b : a.number < b.number;
  });
}

/// S. T. Leutenegger, M. A. Lopez, J. Edgington, "STR: a simple and efficient algorithm for R-tree packing", 1997.
void sort_and_tile(std::span<FlatBox> boxes) {
  const double leaves = std::ceil(static_cast<double>(boxes.size()) / width);
  const auto slabs = static_cast<std::size_t>(std::ceil(std::cbrt(leaves)));
  const std::size_t in_row = slabs * width, in_slab = slabs * in_row;
  sort_along(boxes, 0);
  for (std::size_t slab = 0; slab < boxes.size(); slab += in_slab) {
    const std::span<FlatBox> in = boxes.subspan(slab, std::min(in_slab, boxes.size() - slab));
    sort_along(in, 1);
    for (std::size_t row = 0; row < in.size(); row += in_row)
      sort_along(in.subspan(row, std::min(in_row, in.size() - row)), 2);
  }
}

}  // namespace

void PackedTree::sort_by_curve(std::span<const FlatBox> boxes) {
  const MortonOrder morton(boxes);
  keyed_.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    keyed_[i] = {static_cast<std::uint32_t>(morton.key(boxes[i]) >> 31), static_cast<std::uint32_t>(i)};
  sort_by_key(keyed_, sorted_);
  // The lower bits matter only where boxes lie close together in a wide world.
  std::vector<Keyed<std::uint64_t>> equal;
  for (std::size_t first = 0, last; first < keyed_.size(); first = last) {
    for (last = first + 1; last < keyed_.size() && keyed_[last].key == keyed_[first].key; ++last) {
    }
    if (last - first <= width) continue;
    equal.clear();
    for (std::size_t i = first; i < last; ++i) equal.push_back({morton.key(boxes[keyed_[i].place]), keyed_[i].place});
    std::sort(equal.begin(), equal.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
    for (std::size_t i = first; i < last; ++i) keyed_[i].place = equal[i - first].place;
  }
}

void PackedTree::build(std::vector<FlatBox>& boxes, PackingOrder order) {
  if (order == PackingOrder::sort_and_tile) {
    sort_and_tile(boxes);
  } else {
    sort_by_curve(boxes);
    ordered_.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) ordered_[i] = boxes[keyed_[i].place];
    std::swap(boxes, ordered_);
  }
  const auto level_at = [&](std::size_t level) -> Level& {
    if (levels_.size() <= level) levels_.resize(level + 1);
    return levels_[level];
  };
  Level& items = level_at(0);
  items.size = boxes.size();
  items.store.resize(boxes.size() + width);
  for (std::size_t i = 0; i < boxes.size(); ++i) items.store.put(i, boxes[i]);
  for (std::size_t i = boxes.size(); i < boxes.size() + width; ++i) items.store.put(i, nothing);
  depth_ = 1;
  while (levels_[depth_ - 1].size > width) {
    Level& level = level_at(depth_);
    const Level& below = levels_[depth_ - 1];
    level.size = (below.size + width - 1) / width;
    level.store.resize(level.size + width);
    for (std::size_t i = 0; i < level.size; ++i) {
      FlatBox around = nothing;
      for (std::size_t j = i * width; j < std::min((i + 1) * width, below.size); ++j)
        for (std::size_t axis = 0; axis < 3; ++axis) {
          around.lower[axis] = std::min(around.lower[axis], below.store.lower(axis, j));
          around.upper[axis] = std::max(around.upper[axis], below.store.upper(axis, j));
        }
      level.store.put(i, around);
    }
    for (std::size_t i = level.size; i < level.size + width; ++i) level.store.put(i, nothing);
    ++depth_;
  }
}

TreeColumns PackedTree::columns() const {
  TreeColumns tree{};
  tree.depth = depth_;
  for (std::size_t level = 0; level < depth_; ++level) {
    tree.levels[level] = levels_[level].store.columns();
    tree.sizes[level] = levels_[level].size;
  }
  return tree;
}

void PackedTree::add_pairs(const Aabb* all, std::size_t begin, std::size_t end, PairBuffer& pairs) const {
  if (begin < end) add_overlaps_in_tree(columns(), all, begin, end, pairs);
}

void PackedTree::add_pairs_with(const Aabb* all, std::span<const FlatBox> boxes, PairBuffer& pairs) const {
  if (size() > 0) add_overlaps_with_tree(columns(), all, boxes, pairs);
}

void PackedTree::add_cells(const FloatFrame& frame, BroadPhaseCells& cells) const {
  for (std::size_t level = depth_; level-- > 1;) {
    CellsOfGroup group(cells, fmt::format("tree, level {}", depth_ - 1 - level));
    const ColumnStore& store = levels_[level].store;
    for (std::size_t i = 0; i < levels_[level].size; ++i)
      group.add(box_of_floats(frame, {store.lower(0, i), store.lower(1, i), store.lower(2, i)},
                              {store.upper(0, i), store.upper(1, i), store.upper(2, i)}));
  }
}

void PackedTree::forget(std::size_t place) { levels_.front().store.put(place, nothing); }

void PackedTree::drop_scratch() {
  keyed_ = std::vector<Keyed<std::uint32_t>>();
  sorted_ = std::vector<Keyed<std::uint32_t>>();
  ordered_ = std::vector<FlatBox>();
}

std::size_t PackedTree::bytes() const {
  std::size_t sum =
      (keyed_.capacity() + sorted_.capacity()) * sizeof(keyed_[0]) + ordered_.capacity() * sizeof(FlatBox);
  for (const Level& level : levels_) sum += level.store.bytes();
  return sum;
}

}  // namespace toccata
