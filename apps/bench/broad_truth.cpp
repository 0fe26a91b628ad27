#include "broad_truth.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "broad_race.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/error.hpp"

namespace toccata::bench {
namespace {

using Pairs = std::vector<IndexPair>;

constexpr std::size_t most_in_each_frame = 20'000, most_in_one_frame = 200'000, sampled = 2'000;

Pairs by_brute_force(std::span<const Aabb> boxes, int threads) {
  return overlapping_pairs(boxes, {BroadPhaseMethod::brute_force, threads});
}

/// The pairs of each chosen box with all, by their doubles, one after the other; ascending.
Pairs with_all(std::span<const Index> chosen, std::span<const Aabb> boxes) {
  Pairs pairs;
  for (Index number = 0; number < boxes.size(); ++number)
    for (const Index one : chosen)
      if (overlap(boxes[one], boxes[number]) && one != number)
        pairs.push_back({std::min(one, number), std::max(one, number)});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

bool is_right_for_sample(Pairs pairs, std::span<const Aabb> boxes) {
  std::vector<Index> chosen;
  std::vector<bool> is_chosen(boxes.size());
  for (std::size_t i = 0; i < sampled; ++i) {
    const std::size_t number = i * boxes.size() / sampled;
    chosen.push_back(static_cast<Index>(number));
    is_chosen[number] = true;
  }
  std::erase_if(pairs, [&](const IndexPair& pair) { return !is_chosen[pair.first] && !is_chosen[pair.second]; });
  return pairs == with_all(chosen, boxes);
}

void require_right(const Pairs& pairs, std::span<const Aabb> boxes) {
  const bool is_right =
      boxes.size() <= most_in_one_frame ? pairs == by_brute_force(boxes, 0) : is_right_for_sample(pairs, boxes);
  if (!is_right)
    throw Error(fmt::format("the Morton tree finds other pairs of {} boxes than brute force: no answer can be judged",
                            boxes.size()));
}

}  // namespace

Pairs true_pairs_of(std::span<const Aabb> boxes, int threads) {
  return boxes.size() <= most_in_each_frame ? by_brute_force(boxes, threads)
                                            : overlapping_pairs(boxes, {BroadPhaseMethod::morton_tree, threads});
}

BroadTruth true_pairs(const BroadArguments& arguments) {
  PlainCrowd crowd(arguments);
  BroadTruth truth;
  for (int frame = 0; frame < arguments.frames; ++frame) {
    crowd.step();
    const Pairs pairs = true_pairs_of(crowd.boxes(), 0);
    if (frame == 0 && arguments.count > most_in_each_frame) require_right(pairs, crowd.boxes());
    truth.frames.push_back(digest_of(pairs));
  }
  truth.how =
      arguments.count <= most_in_each_frame ? "brute force in every frame"
      : arguments.count <= most_in_one_frame
          ? "the Morton tree in every frame, brute force over all pairs in the first"
          : fmt::format("the Morton tree in every frame, brute force over {} boxes with all in the first", sampled);
  return truth;
}

}  // namespace toccata::bench
