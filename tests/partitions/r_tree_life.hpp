#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "broad/box_families.hpp"
#include "toccata/partitions/r_tree.hpp"

namespace toccata::test {

/// Boxes come, move and go at random; says what is wrong, empty when nothing is.
inline std::string complaint_about_r_tree_life(std::string_view family, std::uint64_t seed, int steps) {
  Random random(seed);
  RTree tree;
  if (seed % 2 == 1) tree = RTree(random_boxes(family, 60, random));
  std::map<Index, Aabb> boxes;
  for (Index number = 0; number < tree.size(); ++number) boxes[number] = tree.box(number);
  for (int step = 0; step < steps; ++step) {
    const auto number = static_cast<Index>(random.below(120));
    const bool shrinking = step / 150 % 2 == 1;
    const Aabb box = random_box(family, number, random);
    if (boxes.count(number) == 0) {
      if (shrinking) continue;
      tree.insert(number, boxes[number] = box);
    } else if (random.below(shrinking ? 2 : 5) == 0) {
      tree.remove(number);
      boxes.erase(number);
    } else {
      tree.move(number, boxes[number] = box);
    }
    if (std::string wrong = tree.complaint(); !wrong.empty()) return wrong;
    if (tree.size() != boxes.size()) return "another number of boxes";
    std::vector<Index> expected;
    for (const auto& [other, its] : boxes)
      if (overlap(its, box)) expected.push_back(other);
    if (tree.candidates(box) != expected) return "others than brute force finds";
    if (step % 40 != 0) continue;
    std::vector<IndexPair> pairs;
    for (const auto& [a, box_a] : boxes)
      for (const auto& [b, box_b] : boxes)
        if (a < b && overlap(box_a, box_b)) pairs.push_back({a, b});
    if (tree.candidate_pairs() != pairs) return "other pairs than brute force";
  }
  return {};
}

}  // namespace toccata::test
