#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <span>
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

/// Cells of one size, everywhere: a place has a key, and nothing is kept of cells where nothing is.
class CellKeys {
 public:
  /// Cells of this side, which is positive. `level` makes keys of grids differ.
  CellKeys(double side, std::uint64_t level) : side_(std::max(side, 0x1p-1000)), per_cell_(1 / side_), level_(level) {}

  [[nodiscard]] double side() const { return side_; }
  [[nodiscard]] CellPlace place_of(const Vec3& point) const {
    return {cell_of(point.x), cell_of(point.y), cell_of(point.z)};
  }
  [[nodiscard]] std::uint32_t key_of(const CellPlace& place) const {
    return static_cast<std::uint32_t>(key_of_cell(place, level_) >> 16);
  }

 private:
  /// Keeps the order; what is too far away to be told apart is in the last cell.
  [[nodiscard]] std::int64_t cell_of(double coordinate) const {
    return static_cast<std::int64_t>(std::floor(std::clamp(coordinate * per_cell_, -0x1p50, 0x1p50)));
  }
  double side_;
  double per_cell_;
  std::uint64_t level_;
};

double longest_side(const Aabb& box) {
  const Vec3 size = box.upper - box.lower;
  return std::max({size.x, size.y, size.z});
}

/// The exponent of a power of two above this; for 0 one below all.
int exponent_above(double size) { return size > 0 ? std::ilogb(size) + 1 : -1080; }

/// Each box is entered, by key, into every cell that it reaches into; boxes of equal key are compared. Different cells
/// may have one key: what is found is tested, and a pair is told only where the greater of its lower corners lies. The
/// few boxes of many cells are looked for in a tree.
///
/// One size of cells, `side` times the usual box, twice if not told otherwise (M. Teschner et al., "Optimized spatial
/// hashing for collision detection of deformable objects", 2003); or many, four times as large each, where a box is
/// native to that of its size, visits all larger ones, and natives are compared with all (B. Mirtich, "Efficient
/// algorithms for two-phase collision detection", 1997).
class HashGrid final : public PairFinder {
 public:
  enum class Sizes { one, many };
  explicit HashGrid(Sizes sizes, double side = 2) : sizes_(sizes), side_(side) {}

  PairList find(const BoxesNow& now, PairList storage) override {
    choose_levels(now.boxes);
    enter_all(now.boxes);
    sort_by_key(entries_, sorted_);
    const EvenParts chunks(entries_.size(), parts);
    parallel_for(parts, now.threads, [&](std::size_t part) {
      found_[part].clear(now.wanted);
      compare_equal_keys(now.boxes, chunks.begin(part), chunks.end(part), found_[part]);
    });
    large_.add_pairs(now.boxes, found_.front());
    return sorted_pairs(found_, now.boxes.size(), now.threads, std::move(storage));
  }

  [[nodiscard]] std::size_t bytes() const override {
    std::size_t sum =
        (entries_.capacity() + sorted_.capacity()) * sizeof(entries_[0]) + levels_.capacity() + large_.bytes();
    for (const PairBuffer& found : found_) sum += found.bytes();
    return sum;
  }

  /// The cells that some box is native to: where there are only visitors, nothing is compared.
  [[nodiscard]] BroadPhaseCells cells(std::span<const Aabb> boxes) const override {
    std::vector<std::set<CellPlace>> places(grids_.size());
    for (std::size_t number = 0; number < boxes.size(); ++number) {
      if (is_empty(boxes[number]) || levels_[number] == large) continue;
      const CellKeys& grid = grids_[levels_[number]];
      each_cell(grid.place_of(boxes[number].lower), grid.place_of(boxes[number].upper),
                [&](const CellPlace& place) { places[levels_[number]].insert(place); });
    }
    BroadPhaseCells cells;
    for (std::size_t level = grids_.size(); level-- > 0;) {
      if (places[level].empty()) continue;
      CellsOfGroup group(cells, fmt::format("cells of side {:.4g}", grids_[level].side()));
      for (const CellPlace& place : places[level]) group.add(cube_of_cell(place, grids_[level].side()));
    }
    return cells;
  }

 private:
  template <class Visit>
  static void each_cell(const CellPlace& from, const CellPlace& to, const Visit& visit) {
    for (std::int64_t x = from[0]; x <= to[0]; ++x)
      for (std::int64_t y = from[1]; y <= to[1]; ++y)
        for (std::int64_t z = from[2]; z <= to[2]; ++z) visit(CellPlace{x, y, z});
  }

  static constexpr std::size_t parts = 32;
  static constexpr std::uint8_t large = 255;  ///< in place of a level: too many cells, or infinite
  static constexpr std::int64_t most_cells = 64;

  void choose_levels(std::span<const Aabb> boxes) {
    levels_.assign(boxes.size(), large);
    grids_.clear();
    const BoxSample sample(boxes);
    const double least = least_size(sample);
    if (sizes_ == Sizes::one) {
      double usual = 0.25 * least;
      for (std::size_t axis = 0; axis < 3; ++axis) usual = std::max(usual, sample.sizes(axis).median);
      grids_.emplace_back(std::min(4 * side_ * std::min(usual, 0x1p1000), 0x1p1020), 0);
      std::fill(levels_.begin(), levels_.end(), std::uint8_t{0});
      return;
    }
    std::array<bool, 1100> is_used{};
    const auto slot_of = [least](double size) {
      return static_cast<std::size_t>(exponent_above(std::max(size, least)) + 1080) / 2;
    };
    for (const Aabb& box : boxes)
      if (!is_empty(box) && longest_side(box) <= std::numeric_limits<double>::max())
        is_used[slot_of(longest_side(box))] = true;
    std::array<std::uint8_t, 1100> level_of_slot{};
    for (std::size_t slot = 0; slot < is_used.size(); ++slot) {
      if (!is_used[slot] || grids_.size() == large) continue;
      level_of_slot[slot] = static_cast<std::uint8_t>(grids_.size());
      grids_.emplace_back(std::ldexp(1.0, std::min(static_cast<int>(2 * slot) - 1080 + 1, 1020)), slot);
    }
    for (std::size_t number = 0; number < boxes.size(); ++number)
      if (const double size = longest_side(boxes[number]); size <= std::numeric_limits<double>::max())
        levels_[number] = level_of_slot[slot_of(size)];
  }

  void enter_all(std::span<const Aabb> boxes) {
    const FloatFrame frame(finite_bounds(boxes));
    entries_.clear();
    large_.clear();
    for (Index number = 0; number < boxes.size(); ++number) {
      if (is_empty(boxes[number])) continue;
      const FlatBox box = flat_box(frame, boxes[number], number);
      if (levels_[number] != large && enter(boxes[number], number))
        large_.add_ordinary(box);
      else
        large_.add_large(box);
    }
  }

  /// False, and nothing entered, where there would be too many cells.
  bool enter(const Aabb& box, Index number) {
    const std::size_t before = entries_.size();
    for (std::size_t level = levels_[number]; level < grids_.size(); ++level) {
      const CellKeys& grid = grids_[level];
      const CellPlace from = grid.place_of(box.lower), to = grid.place_of(box.upper);
      const double cells = static_cast<double>(to[0] - from[0] + 1) * static_cast<double>(to[1] - from[1] + 1) *
                           static_cast<double>(to[2] - from[2] + 1);
      if (cells > most_cells) {
        levels_[number] = large;
        entries_.resize(before);
        return false;
      }
      const std::uint64_t is_visitor = level == levels_[number] ? 0 : 1;
      each_cell(from, to, [&](const CellPlace& place) { enter_once(grid.key_of(place), is_visitor, number, before); });
    }
    return true;
  }
  void enter_once(std::uint64_t key, std::uint64_t is_visitor, Index number, std::size_t first) {
    for (std::size_t i = first; i < entries_.size(); ++i)
      if (entries_[i].key >> 1 == key) return;
    entries_.push_back({key << 1 | is_visitor, number});
  }

  /// Compares those runs of equal keys that begin between `begin` and `end`. Natives come first.
  void compare_equal_keys(std::span<const Aabb> boxes, std::size_t begin, std::size_t end, PairBuffer& pairs) const {
    const auto key_at = [&](std::size_t i) { return entries_[i].key >> 1; };
    while (begin > 0 && begin < end && key_at(begin) == key_at(begin - 1)) ++begin;
    for (std::size_t first = begin, last; first < end; first = last) {
      last = first + 1;
      while (last < entries_.size() && key_at(last) == key_at(first)) ++last;
      for (std::size_t i = first; i < last && (entries_[i].key & 1) == 0; ++i)
        for (std::size_t j = i + 1; j < last; ++j) compare(boxes, entries_[i], entries_[j].place, pairs);
    }
  }

  void compare(std::span<const Aabb> boxes, const Keyed<std::uint64_t>& one, Index other, PairBuffer& pairs) const {
    const Aabb &a = boxes[one.place], &b = boxes[other];
    if (one.place == other || !overlap(a, b)) return;
    // To the grid of the larger one it is native, and the other comes there too.
    const CellKeys& grid = grids_[std::max(levels_[one.place], levels_[other])];
    const Vec3 corner{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y), std::max(a.lower.z, b.lower.z)};
    if (grid.key_of(grid.place_of(corner)) == one.key >> 1) pairs.add(one.place, other);
  }

  Sizes sizes_;
  double side_;
  std::vector<CellKeys> grids_;
  std::vector<std::uint8_t> levels_;  ///< by number
  std::vector<Keyed<std::uint64_t>> entries_, sorted_;
  LargeBoxes large_;
  std::vector<PairBuffer> found_{parts};
};

}  // namespace

std::unique_ptr<PairFinder> make_spatial_hash(double side) {
  return std::make_unique<HashGrid>(HashGrid::Sizes::one, side);
}
std::unique_ptr<PairFinder> make_hierarchical_hash() { return std::make_unique<HashGrid>(HashGrid::Sizes::many); }

}  // namespace toccata
