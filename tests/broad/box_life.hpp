#pragma once

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "broad/box_families.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata::test {

inline std::vector<std::string> broad_phase_names() {
  std::vector<std::string> names;
  for (const BroadPhaseMethod method : broad_phase_methods()) names.emplace_back(name_of(method));
  return names;
}

/// A broad phase whose boxes live: some move a little, some teleport, now and then some come and go. What they should
/// be is kept in the plainest way.
class BoxLife {
 public:
  BoxLife(std::string_view family, const BroadPhaseOptions& options) : family_(family), phase_(options) {}

  /// Says what is wrong; empty when nothing is.
  std::string add(std::size_t count, Random& random) {
    const std::vector<Aabb> boxes = random_boxes(family_, count, random);
    const std::vector<Index> numbers = phase_.add(boxes);
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (!boxes_.emplace(numbers.at(i), boxes[i]).second) return "a number was given out that is in use";
    return {};
  }

  /// One frame, and the update after it.
  std::string live(int frame, Random& random) {
    move(some(random, frame % 3 == 0 ? 1 : 0.1), frame % 5 == 0, random);
    if (frame % 4 == 1) remove(some(random, 0.2));
    std::string wrong;
    if (frame % 4 == 2) wrong = add(random.below(40), random);
    if (frame % 16 == 7) remove(some(random, 1));
    if (frame % 16 == 8) wrong += add(100 + random.below(100), random);
    return wrong + update();
  }

  /// One frame of a life in which about as many come as go, whose pairs nobody looks at.
  void live_on(int frame, Random& random) {
    move(some(random, frame % 3 == 0 ? 1 : 0.1), frame % 5 == 0, random);
    const std::vector<Index> gone = some(random, frame % 50 == 0 ? 0.9 : 0.05);
    remove(gone);
    add(gone.size(), random);
    phase_.update();
  }
  [[nodiscard]] std::size_t bytes() const { return phase_.bytes(); }
  [[nodiscard]] std::size_t numbers() const { return phase_.size(); }

 private:
  using Pairs = std::vector<IndexPair>;

  void move(const std::vector<Index>& numbers, bool teleport, Random& random) {
    std::vector<Aabb> boxes;
    for (const Index number : numbers) {
      const Aabb box = phase_.box(number);
      const Vec3 by = vector_between(random, -0.05, 0.05);
      boxes.push_back(teleport ? random_box(family_, number, random) : Aabb{box.lower + by, box.upper + by});
    }
    phase_.move(numbers, boxes);
    for (std::size_t i = 0; i < numbers.size(); ++i) boxes_[numbers[i]] = boxes[i];
  }
  void remove(const std::vector<Index>& numbers) {
    phase_.remove(numbers);
    for (const Index number : numbers) boxes_.erase(number);
  }
  /// A part of the numbers in use.
  std::vector<Index> some(Random& random, double share) const {
    std::vector<Index> numbers;
    for (const auto& [number, box] : boxes_)
      if (random.unit() < share) numbers.push_back(number);
    return numbers;
  }

  std::string update() {
    const Pairs before(phase_.pairs().begin(), phase_.pairs().end());
    const std::span<const IndexPair> found = phase_.update();
    const Pairs now(found.begin(), found.end());
    std::vector<Aabb> all(phase_.size());
    for (const auto& [number, box] : boxes_) all[number] = box;
    if (now != overlapping_pairs_by_brute_force(all)) return "other pairs than those of brute force";
    Pairs begin, end;
    std::set_difference(now.begin(), now.end(), before.begin(), before.end(), std::back_inserter(begin));
    std::set_difference(before.begin(), before.end(), now.begin(), now.end(), std::back_inserter(end));
    const PairChanges changes = phase_.changes();
    return changes.begin == begin && changes.end == end ? "" : "other changes than those of the pairs";
  }

  std::string_view family_;
  BroadPhase phase_;
  std::map<Index, Aabb> boxes_;
};

}  // namespace toccata::test
