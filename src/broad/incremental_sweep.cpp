#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "broad/finders.hpp"
#include "broad/method_cells.hpp"

namespace toccata {
namespace {

constexpr double Vec3::*coordinates[] = {&Vec3::x, &Vec3::y, &Vec3::z};

/// An end of a box along an axis: its number twice, and one more for the upper end.
using EndName = std::uint32_t;

struct End {
  double value;
  EndName name;
};

/// Lower ends before upper ones of the same value, so that touching counts.
bool is_before(const End& a, const End& b) {
  if (a.value != b.value) return a.value < b.value;
  return (a.name & 1) != (b.name & 1) ? (a.name & 1) < (b.name & 1) : a.name < b.name;
}

/// A pair that has begun (+1) or ended (-1) to overlap in the middle of sorting.
struct Event {
  IndexPair pair;
  int change;
};

/// The ends of all boxes, sorted along three axes and kept so: when boxes move a little, sorting by insertion takes as
/// many steps as there are ends, and one for each swap. A swap of a lower with an upper end begins or ends the overlap
/// of two boxes along that axis; whether they do along the others is told by the ranks of their ends. (J. D. Cohen, M.
/// C. Lin, D. Manocha, M. K. Ponamgi, "I-COLLIDE", 1995.) There is no table of pairs: what begins and ends is noted,
/// and put into the sorted list at the end.
///
/// Where boxes come or go, or too many ends swap, all is sorted anew.
class IncrementalSweep final : public PairFinder {
 public:
  PairList find(const BoxesNow& now, PairList storage) override {
    events_.clear();
    swaps_ = 0;
    if (!is_sorted_ || some_came_or_went(now) || !sort_again(now)) {
      sort_anew(now.boxes);
      found_by_all_ = true;
      return everything_->find(now, std::move(storage));
    }
    found_by_all_ = false;
    return merged(now.before, std::move(storage));
  }

  [[nodiscard]] std::size_t bytes() const override {
    std::size_t sum = everything_->bytes() + events_.capacity() * sizeof(Event);
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum += ends_[axis].capacity() * sizeof(End) + ranks_[axis].capacity() * sizeof(std::uint32_t);
    return sum;
  }

  [[nodiscard]] BroadPhaseCells cells(std::span<const Aabb> boxes) const override {
    if (found_by_all_) return everything_->cells(boxes);
    BroadPhaseCells cells;
    for (std::size_t axis = 0; axis < 3; ++axis) add_intervals(cells, boxes, axis);
    return cells;
  }

 private:
  static constexpr std::uint32_t no_rank = ~std::uint32_t{0};

  [[nodiscard]] bool some_came_or_went(const BoxesNow& now) const {
    if (2 * now.boxes.size() != ranks_[0].size()) return true;
    return std::any_of(now.changed.begin(), now.changed.end(), [&](Index number) {
      return is_empty(now.boxes[number]) != (ranks_[0][2 * std::size_t{number}] == no_rank);
    });
  }

  void sort_anew(std::span<const Aabb> boxes) {
    is_sorted_ = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::vector<End>& ends = ends_[axis];
      ends.clear();
      for (Index number = 0; number < boxes.size(); ++number) {
        if (is_empty(boxes[number])) continue;
        ends.push_back({boxes[number].lower.*coordinates[axis], 2 * number});
        ends.push_back({boxes[number].upper.*coordinates[axis], 2 * number + 1});
      }
      std::sort(ends.begin(), ends.end(), is_before);
      ranks_[axis].assign(2 * boxes.size(), no_rank);
      for (std::size_t i = 0; i < ends.size(); ++i) ranks_[axis][ends[i].name] = static_cast<std::uint32_t>(i);
    }
  }

  /// False, and nothing of what is kept is right any more, when there were too many swaps.
  bool sort_again(const BoxesNow& now) {
    const std::size_t most_swaps = 64 + 16 * now.boxes.size();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const Index number : now.changed) {
        const std::size_t lower = 2 * std::size_t{number};
        if (ranks_[axis][lower] == no_rank) continue;
        ends_[axis][ranks_[axis][lower]].value = now.boxes[number].lower.*coordinates[axis];
        ends_[axis][ranks_[axis][lower + 1]].value = now.boxes[number].upper.*coordinates[axis];
      }
      for (std::size_t i = 1; i < ends_[axis].size(); ++i) {
        insert(axis, i);
        if (swaps_ > most_swaps) return false;
      }
    }
    return true;
  }

  void insert(std::size_t axis, std::size_t at) {
    std::vector<End>& ends = ends_[axis];
    const End end = ends[at];
    if (!is_before(end, ends[at - 1])) return;
    std::vector<std::uint32_t>& ranks = ranks_[axis];
    for (; at > 0 && is_before(end, ends[at - 1]); --at) {
      const EndName passed = ends[at - 1].name;
      const bool ends_overlap = (end.name & 1) == 1 && (passed & 1) == 0;
      if (ends_overlap) note(end.name / 2, passed / 2, -1);
      ends[at] = ends[at - 1];
      ranks[passed] = static_cast<std::uint32_t>(at);
      ranks[end.name] = static_cast<std::uint32_t>(at - 1);
      if ((end.name & 1) == 0 && (passed & 1) == 1) note(end.name / 2, passed / 2, 1);
      ++swaps_;
    }
    ends[at] = end;
  }

  /// Before an overlap ends, or after it has begun.
  void note(Index one, Index other, int change) {
    if (one != other && overlap_by_ranks(one, other))
      events_.push_back({{std::min(one, other), std::max(one, other)}, change});
  }
  [[nodiscard]] bool overlap_by_ranks(Index a, Index b) const {
    const std::size_t lower_a = 2 * std::size_t{a}, lower_b = 2 * std::size_t{b};
    return std::all_of(ranks_.begin(), ranks_.end(), [&](const std::vector<std::uint32_t>& ranks) {
      return ranks[lower_a] < ranks[lower_b + 1] && ranks[lower_b] < ranks[lower_a + 1];
    });
  }

  PairList merged(std::span<const IndexPair> before, PairList storage) {
    std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) { return a.pair < b.pair; });
    storage.clear();
    std::size_t next = 0;
    for (std::size_t first = 0, last; first < events_.size(); first = last) {
      const IndexPair& pair = events_[first].pair;
      int change = 0;
      for (last = first; last < events_.size() && events_[last].pair == pair; ++last) change += events_[last].change;
      const auto place = std::lower_bound(before.begin() + static_cast<std::ptrdiff_t>(next), before.end(), pair);
      const auto from = before.begin() + static_cast<std::ptrdiff_t>(next);
      storage.insert(storage.end(), from, place);
      next = static_cast<std::size_t>(place - before.begin());
      const bool was_there = next < before.size() && before[next] == pair;
      if (was_there) ++next;
      if ((was_there ? 1 : 0) + change > 0) storage.push_back(pair);
    }
    storage.insert(storage.end(), before.begin() + static_cast<std::ptrdiff_t>(next), before.end());
    return storage;
  }

  std::unique_ptr<PairFinder> everything_ = make_kd_tiles();
  bool is_sorted_ = false;
  bool found_by_all_ = false;  ///< in the last update
  std::size_t swaps_ = 0;
  std::array<std::vector<End>, 3> ends_;
  std::array<std::vector<std::uint32_t>, 3> ranks_;  ///< by the ends' names
  std::vector<Event> events_;
};

}  // namespace

std::unique_ptr<PairFinder> make_incremental_sweep() { return std::make_unique<IncrementalSweep>(); }

}  // namespace toccata
