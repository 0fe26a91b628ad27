#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "broad/finders.hpp"
#include "broad/method_cells.hpp"
#include "broad/pair_buffer.hpp"
#include "math/vec3_coordinates.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

/// An end of a box along an axis: its number twice, and one more for the upper end.
struct End {
  double value;
  std::uint32_t name;
};

/// The ends along an axis; of one value lower ends first, so that touching counts.
std::vector<End> sorted_ends(std::span<const Aabb> boxes, std::size_t axis) {
  std::vector<End> ends;
  for (Index number = 0; number < boxes.size(); ++number) {
    if (is_empty(boxes[number])) continue;
    ends.push_back({boxes[number].lower.*vec3_coordinates[axis], 2 * number});
    ends.push_back({boxes[number].upper.*vec3_coordinates[axis], 2 * number + 1});
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    if (a.value != b.value) return a.value < b.value;
    return (a.name & 1) != (b.name & 1) ? (a.name & 1) < (b.name & 1) : a.name < b.name;
  });
  return ends;
}

/// How many pairs overlap along the axis: those begun before the end of each, less those ended before its start.
std::size_t count_overlaps(std::span<const End> ends) {
  std::size_t sum = 0, open = 0;
  for (const End& end : ends) {
    if ((end.name & 1) == 0) sum += open;
    (end.name & 1) == 0 ? ++open : --open;
  }
  return sum;
}

/// Lesser numbers whose pairs are gone through at a time.
struct Strip {
  Index begin, end;
};

/// Intervals that are open in a sweep: those of lesser numbers of the strip, and those of greater numbers than these.
class OpenIntervals {
 public:
  explicit OpenIntervals(std::size_t numbers) : places_(numbers) {}
  void clear() {
    within_.clear();
    behind_.clear();
  }
  void open(Index number, const Strip& strip) {
    std::vector<Index>& list = list_of(number, strip);
    places_[number] = static_cast<Index>(list.size());
    list.push_back(number);
  }
  void close(Index number, const Strip& strip) {
    std::vector<Index>& list = list_of(number, strip);
    const Index place = places_[number];
    list[place] = list.back();
    places_[list[place]] = place;
    list.pop_back();
  }
  [[nodiscard]] std::span<const Index> within() const { return within_; }
  [[nodiscard]] std::span<const Index> behind() const { return behind_; }

 private:
  std::vector<Index>& list_of(Index number, const Strip& strip) { return number < strip.end ? within_ : behind_; }

  std::vector<Index> within_, behind_;
  std::vector<Index> places_;  ///< among those open, by number
};

/// All overlaps of intervals whose lesser number is in the strip, in one sweep over the sorted ends: when a lower end
/// comes, its interval overlaps all that are open. Calls `found(lesser, greater)` for each, in no order.
template <class Found>
void sweep(std::span<const End> ends, const Strip& strip, OpenIntervals& open, const Found& found) {
  open.clear();
  for (const End& end : ends) {
    const Index number = end.name / 2;
    if (number < strip.begin) continue;
    if ((end.name & 1) == 1) {
      open.close(number, strip);
      continue;
    }
    for (const Index other : open.within()) found(std::min(number, other), std::max(number, other));
    if (number < strip.end)
      for (const Index other : open.behind()) found(number, other);
    open.open(number, strip);
  }
}

/// A bit for each pair of a strip.
class Tags {
 public:
  Tags(const Strip& strip, std::size_t numbers)
      : strip_(strip), numbers_(numbers), words_((std::size_t{strip.end - strip.begin} * numbers + 63) / 64) {}
  void set(Index lesser, Index greater) { words_[place(lesser, greater) / 64] |= bit(lesser, greater); }
  [[nodiscard]] bool has(Index lesser, Index greater) const {
    return (words_[place(lesser, greater) / 64] & bit(lesser, greater)) != 0;
  }

 private:
  [[nodiscard]] std::size_t place(Index lesser, Index greater) const {
    return std::size_t{lesser - strip_.begin} * numbers_ + greater;
  }
  [[nodiscard]] std::uint64_t bit(Index lesser, Index greater) const {
    return std::uint64_t{1} << (place(lesser, greater) % 64);
  }

  Strip strip_;
  std::size_t numbers_;
  std::vector<std::uint64_t> words_;
};

/// Boxes overlap in space when they do in every problem of fewer dimensions: along each of three axes, or in each of
/// two planes. Every problem tags the pairs that it finds and that those before it have tagged; what the last one finds
/// with the tags of all others is the answer. The problem that finds the fewest goes first.
///
/// The table of tags is made in strips of lesser numbers, so that it stays in a near cache: memory is that of the boxes
/// and the answer, and each problem goes through each of its pairs once. These are what the method costs.
class DimensionReduction final : public PairFinder {
 public:
  enum class To { intervals, rectangles };
  explicit DimensionReduction(To to) : to_(to) {}

  PairList find(const BoxesNow& now, PairList storage) override {
    std::vector<Problem> problems;
    for (std::size_t axis = 0; axis < (to_ == To::intervals ? 3U : 2U); ++axis)
      problems.push_back({axis, sorted_ends(now.boxes, axis)});
    std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
      return count_overlaps(a.ends) < count_overlaps(b.ends);
    });
    const std::vector<Strip> strips = strips_of(now.boxes.size());
    // Buffers beyond those in use would be kept.
    found_.resize(std::min(strips.size(), most_buffers));
    parallel_for(found_.size(), now.threads, [&](std::size_t part) {
      found_[part].clear(now.wanted);
      OpenIntervals open(now.boxes.size());
      for (std::size_t i = part; i < strips.size(); i += found_.size())
        find_in(strips[i], now.boxes, problems, open, found_[part]);
    });
    return sorted_pairs(found_, now.boxes.size(), now.threads, std::move(storage));
  }

  [[nodiscard]] std::size_t bytes() const override {
    std::size_t sum = 0;
    for (const PairBuffer& found : found_) sum += found.bytes();
    return sum;
  }

  [[nodiscard]] BroadPhaseCells cells(std::span<const Aabb> boxes) const override {
    BroadPhaseCells cells;
    for (std::size_t axis = 0; to_ == To::intervals && axis < 3; ++axis) add_intervals(cells, boxes, axis);
    for (std::size_t axis = 0; to_ == To::rectangles && axis < 2; ++axis) add_rectangles(cells, boxes, axis);
    return cells;
  }

 private:
  static constexpr std::size_t tags_in_strip = std::size_t{1} << 23;  ///< 1 MB of them
  static constexpr std::size_t most_buffers = 16;
  struct Problem {
    std::size_t axis;
    std::vector<End> ends;
  };

  static std::vector<Strip> strips_of(std::size_t numbers) {
    const std::size_t rows = std::max<std::size_t>(1, tags_in_strip / std::max<std::size_t>(numbers, 1));
    std::vector<Strip> strips;
    for (std::size_t begin = 0; begin < numbers; begin += rows)
      strips.push_back({static_cast<Index>(begin), static_cast<Index>(std::min(begin + rows, numbers))});
    return strips;
  }

  void find_in(const Strip& strip, std::span<const Aabb> boxes, std::span<const Problem> problems, OpenIntervals& open,
               PairBuffer& pairs) const {
    std::vector<Tags> tags(problems.size() - 1, Tags(strip, boxes.size()));
    for (std::size_t i = 0; i < problems.size(); ++i)
      sweep(problems[i].ends, strip, open, [&](Index lesser, Index greater) {
        if (i > 0 && !tags[i - 1].has(lesser, greater)) return;
        if (!is_found(boxes, problems[i].axis, lesser, greater)) return;
        if (i < tags.size())
          tags[i].set(lesser, greater);
        else
          pairs.add(lesser, greater);
      });
  }

  /// Whether two that a plane's sweep has met are found: the sweep goes along its first axis, and the second is
  /// compared. The planes are xy and yz.
  [[nodiscard]] bool is_found(std::span<const Aabb> boxes, std::size_t axis, Index one, Index other) const {
    if (to_ == To::intervals) return true;
    const double Vec3::*second = vec3_coordinates[axis + 1];
    const Aabb &a = boxes[one], &b = boxes[other];
    return a.lower.*second <= b.upper.*second && b.lower.*second <= a.upper.*second;
  }

  To to_;
  std::vector<PairBuffer> found_;
};

}  // namespace

std::unique_ptr<PairFinder> make_interval_sweeps() {
  return std::make_unique<DimensionReduction>(DimensionReduction::To::intervals);
}
std::unique_ptr<PairFinder> make_rectangle_sweeps() {
  return std::make_unique<DimensionReduction>(DimensionReduction::To::rectangles);
}

}  // namespace toccata
