#pragma once

#include <span>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata::bench {

/// The right pairs of each frame, and how it is known that they are right.
struct BroadTruth {
  std::vector<PairDigest> frames;
  std::string how;
};

/// The pairs of up to 20,000 boxes are found by brute force in each frame; those of more boxes by the Morton tree,
/// which is compared in the first frame with brute force: over all pairs of up to 200,000 boxes, and for more over the
/// pairs of 2,000 boxes, chosen evenly by number, with all. Throws Error where they differ.
BroadTruth true_pairs(const BroadArguments& arguments);

/// The right pairs of boxes, by the same method.
std::vector<IndexPair> true_pairs_of(std::span<const Aabb> boxes, int threads);

}  // namespace toccata::bench
