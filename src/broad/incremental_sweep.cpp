#include "broad/incremental_sweep.hpp"

#include <algorithm>

#include "broad/finders.hpp"
#include "broad/method_cells.hpp"
#include "math/vec3_coordinates.hpp"

namespace toccata {
namespace {

constexpr std::uint32_t no_rank = ~std::uint32_t{0};

/// Lower ends before upper ones of the same value, so that touching counts.
constexpr auto end_comes_before = [](const auto& a, const auto& b) {
  if (a.value != b.value) return a.value < b.value;
  return (a.name & 1) != (b.name & 1) ? (a.name & 1) < (b.name & 1) : a.name < b.name;
};

/// Swaps, or tests of boxes that came, that are fewer steps than finding all pairs.
std::size_t most_sweep_steps(std::size_t boxes) { return 64 + 16 * boxes; }

/// Boxes that are open in a sweep.
class OpenBoxes {
 public:
  explicit OpenBoxes(std::size_t numbers) : places_(numbers) {}
  void open(Index number) {
    places_[number] = static_cast<Index>(numbers_.size());
    numbers_.push_back(number);
  }
  void close(Index number) {
    const Index place = places_[number];
    numbers_[place] = numbers_.back();
    places_[numbers_[place]] = place;
    numbers_.pop_back();
  }
  [[nodiscard]] std::span<const Index> numbers() const { return numbers_; }

 private:
  std::vector<Index> numbers_;
  std::vector<Index> places_;  ///< among those open, by number
};

}  // namespace

IncrementalSweep::IncrementalSweep() : everything_(make_kd_tiles()) {}

PairList IncrementalSweep::find(const BoxesNow& now, PairList storage) {
  events_.clear();
  work_ = {};
  tell_changes(now);
  found_by_all_ = !keep_up(now);
  PairList pairs = found_by_all_ ? everything_->find(now, std::move(storage)) : merged(now.before, std::move(storage));
  came_.clear();
  changes_.clear();
  return pairs;
}

/// Whether the ends and events are now those of the boxes. If not, the ends at least are.
bool IncrementalSweep::keep_up(const BoxesNow& now) {
  if (is_sorted_ && 4 * came_.size() <= now.boxes.size()) {
    if (went_ > 0) take_out();
    if (sort_again(now)) {
      if (came_.empty()) return true;
      merge_in(now.boxes);
      return find_those_of_new(now.boxes);
    }
  }
  sort_anew(now.boxes);
  return false;
}

std::size_t IncrementalSweep::bytes() const {
  std::size_t sum = everything_->bytes() + events_.capacity() * sizeof(Event) + changes_.capacity() +
                    came_.capacity() * sizeof(Index);
  for (std::size_t axis = 0; axis < 3; ++axis)
    sum += ends_[axis].capacity() * sizeof(End) + ranks_[axis].capacity() * sizeof(std::uint32_t);
  return sum;
}

BroadPhaseCells IncrementalSweep::cells(std::span<const Aabb> boxes) const {
  if (found_by_all_) return everything_->cells(boxes);
  BroadPhaseCells cells;
  for (std::size_t axis = 0; axis < 3; ++axis) add_intervals(cells, boxes, axis);
  return cells;
}

void IncrementalSweep::tell_changes(const BoxesNow& now) {
  came_.clear();
  went_ = 0;
  for (std::vector<std::uint32_t>& ranks : ranks_) ranks.resize(2 * now.boxes.size(), no_rank);
  for (const Index number : now.changed) {
    const bool was_there = ranks_[0][2 * std::size_t{number}] != no_rank;
    if (was_there != is_empty(now.boxes[number])) continue;
    if (changes_.empty()) changes_.resize(now.boxes.size(), Change::none);
    changes_[number] = was_there ? Change::went : Change::came;
    if (was_there)
      ++went_;
    else
      came_.push_back(number);
  }
}

void IncrementalSweep::add_ends(std::vector<End>& ends, std::size_t axis, Index number, const Aabb& box) const {
  ends.push_back({box.lower.*vec3_coordinates[axis], 2 * number});
  ends.push_back({box.upper.*vec3_coordinates[axis], 2 * number + 1});
}

void IncrementalSweep::rank(std::size_t axis) {
  for (std::size_t i = 0; i < ends_[axis].size(); ++i)
    ranks_[axis][ends_[axis][i].name] = static_cast<std::uint32_t>(i);
}

void IncrementalSweep::sort_anew(std::span<const Aabb> boxes) {
  is_sorted_ = true;
  work_.sorted_anew = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ends_[axis].clear();
    for (Index number = 0; number < boxes.size(); ++number)
      if (!is_empty(boxes[number])) add_ends(ends_[axis], axis, number, boxes[number]);
    std::sort(ends_[axis].begin(), ends_[axis].end(), end_comes_before);
    ranks_[axis].assign(2 * boxes.size(), no_rank);
    rank(axis);
  }
}

/// The ends of boxes that went, of all axes.
void IncrementalSweep::take_out() {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::erase_if(ends_[axis], [&](const End& end) {
      if (changes_[end.name / 2] != Change::went) return false;
      ranks_[axis][end.name] = no_rank;
      return true;
    });
    rank(axis);
  }
}

/// False, and nothing of what is kept is right any more, when there were too many swaps.
bool IncrementalSweep::sort_again(const BoxesNow& now) {
  if (now.changed.size() == came_.size() + went_) return true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const Index number : now.changed) {
      const std::size_t lower = 2 * std::size_t{number};
      if (ranks_[axis][lower] == no_rank) continue;
      ends_[axis][ranks_[axis][lower]].value = now.boxes[number].lower.*vec3_coordinates[axis];
      ends_[axis][ranks_[axis][lower + 1]].value = now.boxes[number].upper.*vec3_coordinates[axis];
    }
    for (std::size_t i = 1; i < ends_[axis].size(); ++i) {
      insert(axis, i);
      if (work_.swaps > most_sweep_steps(now.boxes.size())) return false;
    }
  }
  return true;
}

void IncrementalSweep::insert(std::size_t axis, std::size_t at) {
  std::vector<End>& ends = ends_[axis];
  const End end = ends[at];
  if (!end_comes_before(end, ends[at - 1])) return;
  std::vector<std::uint32_t>& ranks = ranks_[axis];
  for (; at > 0 && end_comes_before(end, ends[at - 1]); --at) {
    const EndName passed = ends[at - 1].name;
    const bool ends_overlap = (end.name & 1) == 1 && (passed & 1) == 0;
    if (ends_overlap) note(end.name / 2, passed / 2, -1);
    ends[at] = ends[at - 1];
    ranks[passed] = static_cast<std::uint32_t>(at);
    ranks[end.name] = static_cast<std::uint32_t>(at - 1);
    if ((end.name & 1) == 0 && (passed & 1) == 1) note(end.name / 2, passed / 2, 1);
    ++work_.swaps;
  }
  ends[at] = end;
}

/// Before an overlap ends, or after it has begun.
void IncrementalSweep::note(Index one, Index other, int change) {
  if (one != other && overlap_by_ranks(one, other))
    events_.push_back({{std::min(one, other), std::max(one, other)}, change});
}

bool IncrementalSweep::overlap_by_ranks(Index a, Index b) const {
  const std::size_t lower_a = 2 * std::size_t{a}, lower_b = 2 * std::size_t{b};
  return std::all_of(ranks_.begin(), ranks_.end(), [&](const std::vector<std::uint32_t>& ranks) {
    return ranks[lower_a] < ranks[lower_b + 1] && ranks[lower_b] < ranks[lower_a + 1];
  });
}

/// The ends of boxes that came, sorted, into those of the others.
void IncrementalSweep::merge_in(std::span<const Aabb> boxes) {
  std::vector<End> batch;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    batch.clear();
    for (const Index number : came_) add_ends(batch, axis, number, boxes[number]);
    std::sort(batch.begin(), batch.end(), end_comes_before);
    std::vector<End>& ends = ends_[axis];
    // From the back, where there is room.
    std::size_t next = ends.size(), to = ends.size() + batch.size();
    ends.resize(to);
    for (; !batch.empty(); --to) {
      const bool is_old = next > 0 && end_comes_before(batch.back(), ends[next - 1]);
      ends[to - 1] = is_old ? ends[next - 1] : batch.back();
      if (is_old)
        --next;
      else
        batch.pop_back();
    }
    rank(axis);
  }
}

/// How often a box that came overlaps another along the axis, at most.
std::size_t IncrementalSweep::overlaps_of_new(std::size_t axis) const {
  std::size_t sum = 0, lower_ends = 0, upper_ends = 0;
  for (const End& end : ends_[axis]) {
    const bool is_upper = (end.name & 1) == 1, is_new = changes_[end.name / 2] == Change::came;
    // Those begun before its end, less those ended before its start.
    if (is_new && is_upper) sum += lower_ends;
    if (is_new && !is_upper) sum -= upper_ends;
    ++(is_upper ? upper_ends : lower_ends);
  }
  return sum;
}

/// False when they overlap too many along every axis.
bool IncrementalSweep::find_those_of_new(std::span<const Aabb> boxes) {
  const std::array<std::size_t, 3> counts{overlaps_of_new(0), overlaps_of_new(1), overlaps_of_new(2)};
  const auto least = std::min_element(counts.begin(), counts.end());
  if (*least > most_sweep_steps(boxes.size())) return false;
  sweep_new(static_cast<std::size_t>(least - counts.begin()), boxes);
  return true;
}

/// Boxes that came with all, in one way through the ends of an axis.
void IncrementalSweep::sweep_new(std::size_t axis, std::span<const Aabb> boxes) {
  OpenBoxes open_old(boxes.size()), open_new(boxes.size());
  for (const End& end : ends_[axis]) {
    const Index number = end.name / 2;
    const bool is_new = changes_[number] == Change::came;
    OpenBoxes& open = is_new ? open_new : open_old;
    if ((end.name & 1) == 1) {
      open.close(number);
      continue;
    }
    test_new(number, open_new.numbers(), boxes);
    if (is_new) test_new(number, open_old.numbers(), boxes);
    open.open(number);
  }
}

void IncrementalSweep::test_new(Index number, std::span<const Index> others, std::span<const Aabb> boxes) {
  work_.tests += others.size();
  for (const Index other : others)
    if (overlap(boxes[number], boxes[other]))
      events_.push_back({{std::min(number, other), std::max(number, other)}, 1});
}

/// The pairs before with the events, without those of boxes that went.
PairList IncrementalSweep::merged(std::span<const IndexPair> before, PairList storage) {
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
  if (went_ > 0)
    std::erase_if(storage, [&](const IndexPair& pair) {
      return changes_[pair.first] == Change::went || changes_[pair.second] == Change::went;
    });
  return storage;
}

std::unique_ptr<PairFinder> make_incremental_sweep() { return std::make_unique<IncrementalSweep>(); }

}  // namespace toccata
