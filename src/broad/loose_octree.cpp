#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "broad/box_sample.hpp"
#include "broad/finders.hpp"
#include "broad/key_sort.hpp"
#include "broad/large_boxes.hpp"
#include "broad/method_cells.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

/// An octree whose cells are twice as large as what they divide, so that every box lies wholly in the cell of its
/// middle at the depth of its size (T. Ulrich, "Loose octrees", 2000). The tree is a list sorted by depth and cell: a
/// node is found by a search in it, and nodes that hold nothing do not exist. Each box is compared with those of its
/// own depth and of all lesser ones whose cells can reach it.
class LooseOctree final : public PairFinder {
 public:
  PairList find(const BoxesNow& now, PairList storage) override {
    place_all(now.boxes);
    const EvenParts chunks(entries_.size(), parts);
    parallel_for(parts, now.threads, [&](std::size_t part) {
      found_[part].clear(now.wanted);
      for (std::size_t i = chunks.begin(part); i < chunks.end(part); ++i)
        look_around(now.boxes, entries_[i].place, found_[part]);
    });
    large_.add_pairs(now.boxes, found_.front());
    return sorted_pairs(found_, now.boxes.size(), now.threads, std::move(storage));
  }

  [[nodiscard]] std::size_t bytes() const override {
    std::size_t sum = (entries_.capacity() + sorted_.capacity()) * sizeof(entries_[0]) +
                      table_.capacity() * sizeof(Node) + depths_.capacity() + large_.bytes();
    for (const PairBuffer& found : found_) sum += found.bytes();
    return sum;
  }

  /// The cells of the nodes that exist; they reach half as far again to each side.
  [[nodiscard]] BroadPhaseCells cells(std::span<const Aabb> boxes) const override {
    std::set<std::pair<int, CellPlace>> nodes;
    for (const auto& entry : entries_) {
      const int level = depths_[entry.place];
      nodes.insert({-level, place_of_middle(boxes[entry.place], level)});
    }
    BroadPhaseCells cells;
    for (auto node = nodes.begin(); node != nodes.end();) {
      const int level = -node->first;
      const double side = cell_side(level);
      CellsOfGroup group(cells, fmt::format("cells of side {:.4g}", side));
      for (; node != nodes.end() && -node->first == level; ++node) group.add(cube_of_cell(node->second, side));
    }
    return cells;
  }

 private:
  static constexpr std::size_t parts = 32;
  static constexpr int most_levels = 64;
  static constexpr std::uint8_t not_in_tree = 255;

  /// Where those of a key are among the entries. Both are 0 in an empty slot.
  struct Node {
    std::uint64_t key = 0;
    std::uint32_t begin = 0, end = 0;
  };

  /// Level 0 has the smallest cells.
  [[nodiscard]] double cell_side(int level) const { return std::ldexp(1.0, exponent_ + level); }
  [[nodiscard]] std::int64_t cell_of(double coordinate, int level) const {
    constexpr double most = std::numeric_limits<double>::max();
    const double cell = std::floor(std::ldexp(std::clamp(coordinate, -most, most), -(exponent_ + level)));
    return static_cast<std::int64_t>(std::clamp(cell, -0x1p50, 0x1p50));
  }
  [[nodiscard]] CellPlace place_of_middle(const Aabb& box, int level) const {
    const Vec3 middle = 0.5 * box.lower + 0.5 * box.upper;
    return {cell_of(middle.x, level), cell_of(middle.y, level), cell_of(middle.z, level)};
  }
  static std::uint64_t key_of(const CellPlace& place, int level) {
    return key_of_cell(place, static_cast<std::uint64_t>(level) + 1);
  }

  void place_all(std::span<const Aabb> boxes) {
    const double least = std::max(least_size(BoxSample(boxes)), 0x1p-1000);
    exponent_ = std::ilogb(least) + 1;
    const FloatFrame frame(finite_bounds(boxes));
    depths_.assign(boxes.size(), not_in_tree);
    is_used_ = {};
    entries_.clear();
    large_.clear();
    for (Index number = 0; number < boxes.size(); ++number) {
      const Aabb& box = boxes[number];
      if (is_empty(box)) continue;
      const Vec3 size = box.upper - box.lower;
      const double longest = std::max({size.x, size.y, size.z, least});
      const int level =
          longest <= std::numeric_limits<double>::max() ? std::ilogb(longest) + 1 - exponent_ : most_levels;
      if (level >= most_levels || std::ilogb(longest) > 1000) {
        large_.add_large(flat_box(frame, box, number));
        continue;
      }
      large_.add_ordinary(flat_box(frame, box, number));
      depths_[number] = static_cast<std::uint8_t>(level);
      is_used_[static_cast<std::size_t>(level)] = true;
      entries_.push_back({key_of(place_of_middle(box, level), level), number});
    }
    sort_by_key(entries_, sorted_);
    make_table();
  }

  void make_table() {
    std::size_t size = 16;
    while (size < 2 * entries_.size()) size *= 2;
    table_.assign(size, {});
    for (std::size_t first = 0, last; first < entries_.size(); first = last) {
      for (last = first; last < entries_.size() && entries_[last].key == entries_[first].key;) ++last;
      std::size_t slot = entries_[first].key & (size - 1);
      while (table_[slot].end != 0) slot = (slot + 1) & (size - 1);
      table_[slot] = {entries_[first].key, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last)};
    }
  }
  [[nodiscard]] Node node_of(std::uint64_t key) const {
    std::size_t slot = key & (table_.size() - 1);
    while (table_[slot].end != 0 && table_[slot].key != key) slot = (slot + 1) & (table_.size() - 1);
    return table_[slot];
  }

  void look_around(std::span<const Aabb> boxes, Index number, PairBuffer& pairs) const {
    const Aabb& box = boxes[number];
    for (int level = depths_[number]; level < most_levels; ++level) {
      if (!is_used_[static_cast<std::size_t>(level)]) continue;
      // A box of the level reaches half a cell from its middle, and that is rounded.
      const double reach = 0.5 * cell_side(level);
      const auto from = [&](double lower) {
        return cell_of(lower - reach - (0x1p-50 * std::fabs(lower) + 0x1p-50 * reach), level);
      };
      const auto to = [&](double upper) {
        return cell_of(upper + reach + (0x1p-50 * std::fabs(upper) + 0x1p-50 * reach), level);
      };
      const CellPlace low{from(box.lower.x), from(box.lower.y), from(box.lower.z)};
      const CellPlace high{to(box.upper.x), to(box.upper.y), to(box.upper.z)};
      for (std::int64_t x = low[0]; x <= high[0]; ++x)
        for (std::int64_t y = low[1]; y <= high[1]; ++y)
          for (std::int64_t z = low[2]; z <= high[2]; ++z) compare(boxes, number, {x, y, z}, level, pairs);
    }
  }

  void compare(std::span<const Aabb> boxes, Index number, const CellPlace& place, int level, PairBuffer& pairs) const {
    const Node node = node_of(key_of(place, level));
    for (std::size_t i = node.begin; i < node.end; ++i) {
      const Index other = entries_[i].place;
      // Those of the same depth meet twice. Cells of equal key are told apart by what is in them.
      if (depths_[other] != level || (level == depths_[number] && other <= number)) continue;
      if (place_of_middle(boxes[other], level) != place) continue;
      if (overlap(boxes[number], boxes[other])) pairs.add(number, other);
    }
  }

  int exponent_ = 0;  ///< of the cells of level 0
  std::array<bool, most_levels> is_used_{};
  std::vector<std::uint8_t> depths_;  ///< levels by number
  std::vector<Keyed<std::uint64_t>> entries_, sorted_;
  std::vector<Node> table_;
  LargeBoxes large_;
  std::vector<PairBuffer> found_{parts};
};

}  // namespace

std::unique_ptr<PairFinder> make_loose_octree() { return std::make_unique<LooseOctree>(); }

}  // namespace toccata
