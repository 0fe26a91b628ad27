#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "broad/box_families.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/math/mat3.hpp"

namespace toccata::test {

inline Ball random_ball(Random& random) {
  const double steps = static_cast<double>(random.below(4));
  // Some touch exactly, some are empty, some are points.
  if (random.below(3) == 0) return {{std::floor(random.between(0, 7)), steps, 3}, 0.5 * (steps - 1)};
  return {vector_between(random, 0, 7), random.between(0.1, 0.9)};
}

inline Obb random_oriented_box(Random& random) {
  if (random.below(16) == 0) return {};
  return {vector_between(random, 0, 7),
          orthonormal_axes(vector_between(random, -1, 1), vector_between(random, -1, 1)),
          {random.between(0, 1.5), random.between(0, 0.3), random.between(0, 0.7)}};
}

/// Bodies of which each has a bound of some kind, and what the phase should tell of them, kept in the plainest way.
class MixedLife {
 public:
  MixedLife(const BroadPhaseOptions& options, std::size_t kinds) : phase_(options), kinds_(kinds) {}

  /// One frame, and the update after it; says what is wrong, empty when nothing is.
  std::string live(int frame, Random& random) {
    if (frame % 4 == 0) add(random);
    move(random, frame % 3 == 0 ? 0.9 : 0.1);
    if (frame % 5 == 4) remove(random, frame % 10 == 9 ? 1 : 0.2);
    return update();
  }
  /// Pairs of the boxes around them that were no pairs, in all frames.
  [[nodiscard]] std::size_t cleaned() const { return cleaned_; }

 private:
  using Pairs = std::vector<IndexPair>;

  /// `call` gets as many bounds of a kind by chance.
  template <class Call>
  void with_bounds(std::size_t count, Random& random, const Call& call) {
    const std::size_t kind = random.below(kinds_);
    std::vector<Aabb> boxes;
    std::vector<Ball> balls;
    std::vector<Obb> oriented;
    for (std::size_t i = 0; i < count; ++i) {
      boxes.push_back(random_box("infinite", i + 3, random));
      balls.push_back(random_ball(random));
      oriented.push_back(random_oriented_box(random));
    }
    if (kind == 0) call(std::span<const Ball>(balls));
    if (kind == 1) call(std::span<const Obb>(oriented));
    if (kind == 2) call(std::span<const Aabb>(boxes));
  }
  void add(Random& random) {
    for (int batch = 0; batch < 3; ++batch)
      with_bounds(random.below(40), random, [&](const auto& bounds) {
        const std::vector<Index> numbers = phase_.add(bounds);
        for (std::size_t i = 0; i < numbers.size(); ++i) bounds_.insert_or_assign(numbers[i], bounds[i]);
      });
  }
  void move(Random& random, double share) {
    const std::vector<Index> numbers = some(random, share);
    with_bounds(numbers.size(), random, [&](const auto& bounds) {
      phase_.move(numbers, bounds);
      for (std::size_t i = 0; i < numbers.size(); ++i) bounds_[numbers[i]] = bounds[i];
    });
  }
  void remove(Random& random, double share) {
    const std::vector<Index> numbers = some(random, share);
    phase_.remove(numbers);
    for (const Index number : numbers) bounds_.erase(number);
  }
  std::vector<Index> some(Random& random, double share) {
    std::vector<Index> numbers;
    for (const auto& [number, bound] : bounds_)
      if (random.unit() < share) numbers.push_back(number);
    return numbers;
  }

  std::string update() {
    const Pairs before(phase_.pairs().begin(), phase_.pairs().end());
    const std::span<const IndexPair> found = phase_.update();
    const Pairs now(found.begin(), found.end());
    if (now != expected()) return "other pairs than those of brute force";
    Pairs begin;
    std::set_difference(now.begin(), now.end(), before.begin(), before.end(), std::back_inserter(begin));
    if (phase_.changes().begin != begin) return "other changes than those of the pairs";
    for (const auto& [number, bound] : bounds_)
      if (phase_.bound(number) != bound) return "a bound is not as it was given";
    std::vector<Aabb> around;
    for (Index number = 0; number < phase_.size(); ++number) around.push_back(phase_.box(number));
    cleaned_ += overlapping_pairs_by_brute_force(around).size() - now.size();
    return {};
  }
  [[nodiscard]] Pairs expected() const {
    Pairs pairs;
    for (auto one = bounds_.begin(); one != bounds_.end(); ++one)
      for (auto other = std::next(one); other != bounds_.end(); ++other)
        if (bounds_overlap(one->second, other->second)) pairs.push_back({one->first, other->first});
    return pairs;
  }

  BroadPhase phase_;
  std::size_t kinds_;  ///< 1: balls; 2: oriented boxes too; 3: and boxes
  std::map<Index, AnyBound> bounds_;
  std::size_t cleaned_ = 0;
};

}  // namespace toccata::test
