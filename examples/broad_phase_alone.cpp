// The broad phase by itself: boxes that move, and which of them overlap. What the boxes stand for is yours.
#include <toccata/methods.hpp>
#include <toccata/toccata.hpp>

#include <algorithm>
#include <cstdio>
#include <vector>

using namespace toccata;

int main() {
  Crowd crowd("clustered", 5000, 7);  // 5,000 boxes that move, the same on every machine
  BroadPhase phase;                   // chooses its method itself; BroadPhaseOptions names one
  const std::vector<Index> numbers = phase.add(crowd.boxes());

  std::size_t begun = 0, ended = 0;
  bool all_right = true;
  for (int frame = 0; frame < 10; ++frame) {
    const std::span<const Index> moved = crowd.step();
    std::vector<Index> ids;
    std::vector<Aabb> boxes;
    for (const Index i : moved) {
      ids.push_back(numbers[i]);
      boxes.push_back(crowd.boxes()[i]);
    }
    phase.move(ids, boxes);
    const std::span<const IndexPair> pairs = phase.update();
    const PairChanges changes = phase.changes();
    if (frame > 0) begun += changes.begin.size(), ended += changes.end.size();
    // Here numbers are 0, 1, 2 …, so the pairs are those of the boxes in their order.
    all_right = all_right && std::ranges::equal(pairs, overlapping_pairs_by_brute_force(crowd.boxes()));
  }
  std::printf("%zu boxes, %zu pairs at the end\n", crowd.boxes().size(), phase.pairs().size());
  std::printf("in nine frames %zu pairs began and %zu ended\n", begun, ended);
  std::printf("the same as by brute force: %s\n", all_right ? "yes" : "no");

  // Once only, without keeping anything.
  std::printf("%zu pairs by a sweep\n",
              overlapping_pairs(crowd.boxes(), {.method = BroadPhaseMethod::sort_and_sweep}).size());

  // Questions of one box to many.
  const BoxBvh tree(crowd.boxes());
  const Aabb region = offset_outward(crowd.boxes()[0], 5);
  std::printf("%zu boxes within 5 of the first along every axis\n", tree.overlapping(region).size());
}
