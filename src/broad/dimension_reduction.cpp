#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "broad/finders.hpp"
#include "broad/method_cells.hpp"

namespace toccata {
namespace {

constexpr double Vec3::*coordinates[] = {&Vec3::x, &Vec3::y, &Vec3::z};

/// All overlaps of intervals, in one sweep over the sorted ends: when a lower end comes, its interval overlaps all that
/// are open.
class IntervalSweep {
 public:
  IntervalSweep(std::span<const Aabb> boxes, std::size_t axis) : axis_(axis) {
    for (Index number = 0; number < boxes.size(); ++number) {
      if (is_empty(boxes[number])) continue;
      ends_.push_back({boxes[number].lower.*coordinates[axis], number, false});
      ends_.push_back({boxes[number].upper.*coordinates[axis], number, true});
    }
    // Lower ends first, so that touching counts.
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) {
      if (a.value != b.value) return a.value < b.value;
      return a.is_upper != b.is_upper ? b.is_upper : a.number < b.number;
    });
  }

  /// Calls `found(pair)` for each, in no order.
  template <class Found>
  void each(std::size_t count, const Found& found) {
    place_.assign(count, 0);
    open_.clear();
    for (const End& end : ends_) {
      if (end.is_upper) {
        close(end.number);
        continue;
      }
      for (const Index other : open_) found(IndexPair{std::min(end.number, other), std::max(end.number, other)});
      place_[end.number] = open_.size();
      open_.push_back(end.number);
    }
  }
  [[nodiscard]] std::size_t axis() const { return axis_; }

 private:
  struct End {
    double value;
    Index number;
    bool is_upper;
  };
  void close(Index number) {
    const std::size_t place = place_[number];
    open_[place] = open_.back();
    place_[open_[place]] = place;
    open_.pop_back();
  }

  std::size_t axis_;
  std::vector<End> ends_;
  std::vector<Index> open_;
  std::vector<std::size_t> place_;  ///< among those open, by number
};

/// Boxes overlap in space when they do in every problem of fewer dimensions: along each of three axes, or in each of
/// two planes. Every problem tags the pairs that it finds; those with all tags are the answer. The pairs are gone
/// through in parts, by their lesser number, so that memory does not grow with the pairs of single problems.
class DimensionReduction final : public PairFinder {
 public:
  enum class To { intervals, rectangles };
  explicit DimensionReduction(To to) : to_(to) {}

  PairList find(const BoxesNow& now, PairList storage) override {
    storage.clear();
    const std::span<const Aabb> boxes = now.boxes;
    std::vector<IntervalSweep> sweeps;
    for (std::size_t axis = 0; axis < (to_ == To::intervals ? 3U : 2U); ++axis) sweeps.emplace_back(boxes, axis);
    for (const auto& [begin, end] : parts_of(boxes, sweeps)) {
      tagged_.clear();
      for (std::uint32_t problem = 0; problem < sweeps.size(); ++problem)
        sweeps[problem].each(boxes.size(), [&, from = begin, to = end](const IndexPair& pair) {
          if (pair.first >= from && pair.first < to && is_found(boxes, sweeps[problem], pair))
            tagged_.push_back({pair, 1U << problem});
        });
      collect((1U << sweeps.size()) - 1, storage);
    }
    return storage;
  }

  [[nodiscard]] std::size_t bytes() const override { return tagged_.capacity() * sizeof(Tagged); }

  [[nodiscard]] BroadPhaseCells cells(std::span<const Aabb> boxes) const override {
    BroadPhaseCells cells;
    for (std::size_t axis = 0; to_ == To::intervals && axis < 3; ++axis) add_intervals(cells, boxes, axis);
    for (std::size_t axis = 0; to_ == To::rectangles && axis < 2; ++axis) add_rectangles(cells, boxes, axis);
    return cells;
  }

 private:
  static constexpr std::size_t most_at_once = std::size_t{1} << 22;
  struct Tagged {
    IndexPair pair;
    std::uint32_t tag;
  };

  /// Of a plane: the sweep goes along its first axis, and the second is compared. The planes are xy and yz.
  [[nodiscard]] bool is_found(std::span<const Aabb> boxes, const IntervalSweep& sweep, const IndexPair& pair) const {
    if (to_ == To::intervals) return true;
    const double Vec3::*second = coordinates[sweep.axis() + 1];
    const Aabb &a = boxes[pair.first], &b = boxes[pair.second];
    return a.lower.*second <= b.upper.*second && b.lower.*second <= a.upper.*second;
  }

  /// Ranges of lesser numbers with not too many pairs each.
  std::vector<std::pair<Index, Index>> parts_of(std::span<const Aabb> boxes, std::vector<IntervalSweep>& sweeps) const {
    std::vector<std::size_t> found(boxes.size(), 0);
    for (IntervalSweep& sweep : sweeps)
      sweep.each(boxes.size(), [&](const IndexPair& pair) {
        if (is_found(boxes, sweep, pair)) ++found[pair.first];
      });
    std::vector<std::pair<Index, Index>> parts;
    std::size_t sum = 0;
    Index begin = 0;
    for (Index number = 0; number < boxes.size(); ++number) {
      if (sum > 0 && sum + found[number] > most_at_once) {
        parts.emplace_back(begin, number);
        begin = number;
        sum = 0;
      }
      sum += found[number];
    }
    parts.emplace_back(begin, static_cast<Index>(boxes.size()));
    return parts;
  }

  void collect(std::uint32_t all_tags, PairList& pairs) {
    std::sort(tagged_.begin(), tagged_.end(), [](const Tagged& a, const Tagged& b) { return a.pair < b.pair; });
    for (std::size_t first = 0, last; first < tagged_.size(); first = last) {
      std::uint32_t tags = 0;
      for (last = first; last < tagged_.size() && tagged_[last].pair == tagged_[first].pair; ++last)
        tags |= tagged_[last].tag;
      if (tags == all_tags) pairs.push_back(tagged_[first].pair);
    }
  }

  To to_;
  std::vector<Tagged> tagged_;
};

}  // namespace

std::unique_ptr<PairFinder> make_interval_sweeps() {
  return std::make_unique<DimensionReduction>(DimensionReduction::To::intervals);
}
std::unique_ptr<PairFinder> make_rectangle_sweeps() {
  return std::make_unique<DimensionReduction>(DimensionReduction::To::rectangles);
}

}  // namespace toccata
