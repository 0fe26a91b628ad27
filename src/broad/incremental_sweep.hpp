#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "broad/pair_finder.hpp"

namespace toccata {

/// The ends of all boxes, sorted along three axes and kept so: when boxes move a little, sorting by insertion takes as
/// many steps as there are ends, and one for each swap. A swap of a lower with an upper end begins or ends the overlap
/// of two boxes along that axis; whether they do along the others is told by the ranks of their ends. (J. D. Cohen, M.
/// C. Lin, D. Manocha, M. K. Ponamgi, "I-COLLIDE", 1995.) There is no table of pairs: what begins and ends is noted,
/// and put into the sorted list at the end.
///
/// The ends of boxes that go are taken out in one pass. Those of boxes that come are sorted among themselves and merged
/// with the others once; then one sweep, along the axis on which they meet the fewest, tests them with all. Where too
/// many ends swap or too many boxes come, all is sorted anew.
class IncrementalSweep final : public PairFinder {
 public:
  IncrementalSweep();

  PairList find(const BoxesNow& now, PairList storage) override;
  [[nodiscard]] std::size_t bytes() const override;
  [[nodiscard]] BroadPhaseCells cells(std::span<const Aabb> boxes) const override;

  /// What the last `find` took.
  struct Work {
    bool sorted_anew = false;
    std::size_t swaps = 0;
    std::size_t tests = 0;  ///< of boxes that came with others
  };
  [[nodiscard]] const Work& work() const { return work_; }

 private:
  /// An end of a box along an axis: its number twice, and one more for the upper end.
  using EndName = std::uint32_t;
  struct End {
    double value;
    EndName name;
  };
  /// A pair that has begun (+1) or ended (-1) to overlap.
  struct Event {
    IndexPair pair;
    int change;
  };
  enum class Change : std::uint8_t { none, came, went };

  void tell_changes(const BoxesNow& now);
  bool keep_up(const BoxesNow& now);
  void sort_anew(std::span<const Aabb> boxes);
  void add_ends(std::vector<End>& ends, std::size_t axis, Index number, const Aabb& box) const;
  void rank(std::size_t axis);
  void take_out();
  bool sort_again(const BoxesNow& now);
  void insert(std::size_t axis, std::size_t at);
  void merge_in(std::span<const Aabb> boxes);
  [[nodiscard]] std::size_t overlaps_of_new(std::size_t axis) const;
  bool find_those_of_new(std::span<const Aabb> boxes);
  void sweep_new(std::size_t axis, std::span<const Aabb> boxes);
  void test_new(Index number, std::span<const Index> others, std::span<const Aabb> boxes);
  void note(Index one, Index other, int change);
  [[nodiscard]] bool overlap_by_ranks(Index a, Index b) const;
  PairList merged(std::span<const IndexPair> before, PairList storage);

  std::unique_ptr<PairFinder> everything_;
  bool is_sorted_ = false;
  bool found_by_all_ = false;  ///< in the last update
  Work work_;
  std::array<std::vector<End>, 3> ends_;
  std::array<std::vector<std::uint32_t>, 3> ranks_;  ///< by the ends' names
  std::vector<Event> events_;
  std::vector<Change> changes_;  ///< by number, none where nothing came or went
  std::vector<Index> came_;
  std::size_t went_ = 0;
};

}  // namespace toccata
