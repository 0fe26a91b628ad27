#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "broad/box_lanes.hpp"
#include "broad/box_sample.hpp"
#include "broad/box_sweep.hpp"
#include "broad/finders.hpp"
#include "broad/method_cells.hpp"
#include "math/constants.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

/// Which cell a coordinate is in: a function that keeps the order, and that is all which must be true of it.
class CellAxis {
 public:
  CellAxis() = default;
  /// `lower` and `upper` are a quarter of where cells are wanted; there are at most `most` of at least `size`.
  CellAxis(double lower, double upper, double size, double most) {
    const double range = upper - lower;
    if (!(range > 0)) return;
    last_ = std::min(std::max(std::floor(range / std::max(size, range / most)), 1.0), most) - 1;
    origin_ = lower;
    per_cell_ = std::min((last_ + 1) / range, std::numeric_limits<double>::max());
  }
  [[nodiscard]] std::uint32_t cells() const { return static_cast<std::uint32_t>(last_) + 1; }
  [[nodiscard]] std::uint32_t cell_of(double coordinate) const {
    // A quarter, so that no difference overflows. What lies outside belongs to the cells at the rim.
    const double place = (0.25 * coordinate - origin_) * per_cell_;
    return static_cast<std::uint32_t>(place < 0 ? 0 : place > last_ ? last_ : place);
  }

  /// Where a cell begins and ends; those at the rim do not end.
  [[nodiscard]] std::array<double, 2> ends_of(std::uint32_t cell) const {
    const auto end = [&](std::uint32_t before) { return 4 * (origin_ + before / per_cell_); };
    return {cell == 0 ? -infinity : end(cell), cell + 1 == cells() ? infinity : end(cell + 1)};
  }

 private:
  double origin_ = 0;
  double per_cell_ = 1;
  double last_ = 0;
};

struct CellNumbers {
  std::uint32_t x, y, z;
};

class GridPlan {
 public:
  GridPlan() = default;
  /// Cells a little larger than most boxes, where most boxes are; not many more cells than boxes.
  explicit GridPlan(const BoxSample& sample, std::size_t count) {
    std::array<double, 3> lower{}, upper{}, size{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const BoxSample::Spread places = sample.places(axis), sizes = sample.sizes(axis);
      const double rim = 0.02 * (places.high - places.low);
      lower[axis] = places.low - rim;
      upper[axis] = places.high + rim;
      size[axis] = std::min(sizes.most, 1.5 * sizes.high);
    }
    const double most = std::min(1.5 * static_cast<double>(count) + 8, 0x1p31);
    double larger = 1;
    for (int attempt = 0; attempt < 40; ++attempt, larger *= 1.3) {
      // Where all boxes are points their size is no help: then the range is divided, by fewer at each attempt.
      const double most_along_axis = std::max(1.0, std::min(most, 0x1p20) / larger);
      for (std::size_t axis = 0; axis < 3; ++axis)
        axes_[axis] = CellAxis(lower[axis], upper[axis], larger * size[axis], most_along_axis);
      if (cell_count() <= most) return;
    }
    axes_ = {};
  }

  [[nodiscard]] double cell_count() const { return 1.0 * axes_[0].cells() * axes_[1].cells() * axes_[2].cells(); }
  [[nodiscard]] std::uint32_t cells(std::size_t axis) const { return axes_[axis].cells(); }
  [[nodiscard]] CellNumbers cell_of(const Vec3& point) const {
    return {axes_[0].cell_of(point.x), axes_[1].cell_of(point.y), axes_[2].cell_of(point.z)};
  }
  [[nodiscard]] Aabb box_of(std::uint32_t key) const {
    const auto x = axes_[0].ends_of(key / (cells(1) * cells(2))), y = axes_[1].ends_of(key / cells(2) % cells(1)),
               z = axes_[2].ends_of(key % cells(2));
    return {{x[0], y[0], z[0]}, {x[1], y[1], z[1]}};
  }
  [[nodiscard]] std::uint32_t key_of(const CellNumbers& cell) const {
    return (cell.x * cells(1) + cell.y) * cells(2) + cell.z;
  }

 private:
  std::array<CellAxis, 3> axes_{};
};

/// Whether a box that begins in one cell and ends in another reaches no farther than the neighbours'.
bool is_ordinary(const CellNumbers& from, const CellNumbers& to) {
  return (to.x - from.x) <= 1 && (to.y - from.y) <= 1 && (to.z - from.z) <= 1;
}

/// Every box lies in the cell of its lower corner, sorted by counting; boxes of neighbouring cells are compared. The
/// few that are larger than cells are compared with all cells that they reach, and swept among themselves.
class GridFinder final : public PairFinder {
 public:
  PairList find(const BoxesNow& now, PairList storage) override {
    const BoxSample sample(now.boxes);
    frame_ = FloatFrame(sample.bounds());
    plan_ = GridPlan(sample, now.boxes.size());
    sort_into_cells(now);
    compare_cells(now);
    compare_large(now);
    return sorted_pairs(found_, now.boxes.size(), now.threads, std::move(storage));
  }

  [[nodiscard]] std::size_t bytes() const override {
    std::size_t sum = store_.bytes() + large_.bytes() + large_boxes_.capacity() * sizeof(FlatBox) +
                      (keys_.capacity() + starts_.capacity()) * sizeof(std::uint32_t) +
                      entries_.capacity() * sizeof(Entry) + places_.capacity() * sizeof(std::uint32_t);
    for (const PairBuffer& found : found_) sum += found.bytes();
    return sum;
  }

  [[nodiscard]] BroadPhaseCells cells(std::span<const Aabb> /*boxes*/) const override {
    BroadPhaseCells cells;
    CellsOfGroup group(cells, "cells");
    for (std::uint32_t key = 0; key < plan_.cell_count(); ++key)
      if (starts_[key] < starts_[key + std::size_t{1}]) group.add(plan_.box_of(key));
    return cells;
  }

 private:
  static constexpr std::uint32_t no_key = std::numeric_limits<std::uint32_t>::max(), large_key = no_key - 1;
  static constexpr std::size_t parts = 16;
  static constexpr std::size_t boxes_in_bucket = 1024, most_buckets = 1024;

  struct Entry {
    std::uint32_t key;
    Index number;
  };

  // A bucket is a power of two of cells, as many as have about a nearest cache's worth of boxes.

  void sort_into_cells(const BoxesNow& now) {
    const auto cells = static_cast<std::size_t>(plan_.cell_count());
    const std::size_t wanted = std::clamp<std::size_t>(now.boxes.size() / boxes_in_bucket, 1, most_buckets);
    bucket_shift_ = 0;
    while ((cells >> bucket_shift_) >= wanted) ++bucket_shift_;
    buckets_ = (cells >> bucket_shift_) + 1;
    keys_.resize(now.boxes.size());
    places_.assign(parts * buckets_, 0);
    const EvenParts chunks(now.boxes.size(), parts);
    parallel_for(parts, now.threads,
                 [&](std::size_t part) { find_keys(now.boxes, chunks.begin(part), chunks.end(part), part); });
    place_buckets();
    parallel_for(parts, now.threads, [&](std::size_t part) { scatter(chunks.begin(part), chunks.end(part), part); });
    starts_.resize((buckets_ << bucket_shift_) + 1);
    store_.resize(entries_.size());
    parallel_for(buckets_, now.threads, [&](std::size_t bucket) { sort_bucket(now.boxes, bucket); });
    starts_.back() = static_cast<std::uint32_t>(entries_.size());
  }

  void find_keys(std::span<const Aabb> boxes, std::size_t begin, std::size_t end, std::size_t part) {
    std::uint32_t* counts = places_.data() + part * buckets_;
    for (std::size_t number = begin; number < end; ++number) {
      const Aabb& box = boxes[number];
      keys_[number] = no_key;
      if (is_empty(box)) continue;
      const CellNumbers from = plan_.cell_of(box.lower), to = plan_.cell_of(box.upper);
      keys_[number] = large_key;
      if (!is_ordinary(from, to)) continue;
      const std::uint32_t key = plan_.key_of(from);
      keys_[number] = key;
      ++counts[key >> bucket_shift_];
    }
  }

  void place_buckets() {
    bucket_starts_.assign(buckets_ + 1, 0);
    std::uint32_t sum = 0;
    for (std::size_t bucket = 0; bucket < buckets_; ++bucket) {
      bucket_starts_[bucket] = sum;
      for (std::size_t part = 0; part < parts; ++part) sum += std::exchange(places_[part * buckets_ + bucket], sum);
    }
    bucket_starts_[buckets_] = sum;
    entries_.resize(sum);
  }

  void scatter(std::size_t begin, std::size_t end, std::size_t part) {
    std::uint32_t* places = places_.data() + part * buckets_;
    for (std::size_t number = begin; number < end; ++number)
      if (const std::uint32_t key = keys_[number]; key < large_key)
        entries_[places[key >> bucket_shift_]++] = {key, static_cast<Index>(number)};
  }

  void sort_bucket(std::span<const Aabb> boxes, std::size_t bucket) {
    constexpr std::size_t ahead = 12;
    const std::size_t cells = std::size_t{1} << bucket_shift_, first = bucket << bucket_shift_;
    const std::size_t begin = bucket_starts_[bucket], end = bucket_starts_[bucket + 1];
    std::vector<std::uint32_t> place(cells, 0);
    for (std::size_t i = begin; i < end; ++i) ++place[entries_[i].key - first];
    std::uint32_t sum = static_cast<std::uint32_t>(begin);
    for (std::size_t cell = 0; cell < cells; ++cell) {
      starts_[first + cell] = sum;
      sum += std::exchange(place[cell], sum);
    }
    for (std::size_t i = begin; i < end; ++i) {
      const Aabb* later = &boxes[entries_[std::min(i + ahead, end - 1)].number];
      __builtin_prefetch(later);
      __builtin_prefetch(&later->upper.z);
      const Index number = entries_[i].number;
      store_.put(place[entries_[i].key - first]++, flat_box(frame_, boxes[number], number));
    }
  }

  void compare_cells(const BoxesNow& now) {
    const CellRows rows{
        {store_.columns(), now.boxes.data()}, starts_.data(), plan_.cells(0), plan_.cells(1), plan_.cells(2)};
    const auto cells = static_cast<std::size_t>(plan_.cell_count());
    // The cells of every part hold as many boxes.
    const EvenParts chunks(entries_.size(), parts);
    const auto cell_at = [&](std::size_t place) {
      return place == 0 ? 0
             : place >= entries_.size()
                 ? cells
                 : static_cast<std::size_t>(
                       std::lower_bound(starts_.begin(), starts_.begin() + static_cast<std::ptrdiff_t>(cells), place) -
                       starts_.begin());
    };
    parallel_for(parts, now.threads, [&](std::size_t part) {
      found_[part].clear(now.wanted);
      const std::size_t begin = cell_at(chunks.begin(part));
      const std::size_t end = part + 1 == parts ? cells : cell_at(chunks.end(part));
      add_overlaps_of_cells(rows, begin, end, found_[part]);
    });
  }

  void compare_large(const BoxesNow& now) {
    large_boxes_.clear();
    for (std::size_t number = 0; number < keys_.size(); ++number)
      if (keys_[number] == large_key)
        large_boxes_.push_back(flat_box(frame_, now.boxes[number], static_cast<Index>(number)));
    if (large_boxes_.empty()) return;
    large_.lay_out(large_boxes_, sweep_axis(large_boxes_));
    const EvenParts chunks(large_boxes_.size(), parts);
    parallel_for(parts, now.threads, [&](std::size_t part) {
      large_.add_pairs(now.boxes, chunks.begin(part), chunks.end(part), found_[part]);
      for (std::size_t i = chunks.begin(part); i < chunks.end(part); ++i)
        compare_with_cells(now, large_boxes_[i], found_[part]);
    });
  }

  /// A box in a cell may reach into the next, so that the cells before those of the large box count too.
  void compare_with_cells(const BoxesNow& now, const FlatBox& box, PairBuffer& pairs) const {
    const LaidOut laid{store_.columns(), now.boxes.data()};
    const auto before = [](std::uint32_t cell) { return cell == 0 ? 0 : cell - 1; };
    const CellNumbers low = plan_.cell_of(now.boxes[box.number].lower), to = plan_.cell_of(now.boxes[box.number].upper);
    const CellNumbers from{before(low.x), before(low.y), before(low.z)};
    const std::size_t rows = std::size_t{to.x - from.x + 1} * (to.y - from.y + 1);
    if (rows > entries_.size() / 16) return add_overlaps_with(laid, box, 0, entries_.size(), pairs);
    for (std::uint32_t x = from.x; x <= to.x; ++x)
      for (std::uint32_t y = from.y; y <= to.y; ++y) {
        const std::size_t begin = starts_[plan_.key_of({x, y, from.z})], end = starts_[plan_.key_of({x, y, to.z}) + 1];
        if (begin < end) add_overlaps_with(laid, box, begin, end, pairs);
      }
  }

  GridPlan plan_;
  FloatFrame frame_;
  int bucket_shift_ = 0;
  std::size_t buckets_ = 1;
  std::vector<std::uint32_t> keys_;           ///< by number
  std::vector<std::uint32_t> places_;         ///< by part and bucket
  std::vector<std::uint32_t> bucket_starts_;  ///< and the end
  std::vector<std::uint32_t> starts_;         ///< by cell, and the end
  std::vector<Entry> entries_;                ///< by bucket
  ColumnStore store_;                         ///< by cell
  std::vector<FlatBox> large_boxes_;
  BoxSweep large_;
  std::vector<PairBuffer> found_{parts};
};

}  // namespace

std::unique_ptr<PairFinder> make_uniform_grid() { return std::make_unique<GridFinder>(); }

}  // namespace toccata
