#pragma once

#include <array>
#include <memory>
#include <vector>

#include "narrow/triangle_pair_block.hpp"
#include "query/found_pairs.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/contacts.hpp"
#include "trees/wide_walk.hpp"

namespace toccata {

/// What one thread of a search works with.
struct SearchPart {
  WideFrontier frontier;
  std::array<TrianglePairBlock, 8> blocks{};  ///< as many as stay in the nearest cache
  FoundPairs found;
};

/// For sorting pairs whose numbers lie in one range.
struct PairRange {
  std::vector<FoundPair> pairs;
  std::vector<FoundPair> spare;
};

/// Memory that searches need and keep: see Workspace.
struct SearchScratch {
  SearchPart main;
  std::vector<std::unique_ptr<SearchPart>> others;  ///< of a search that is spread over threads
  std::vector<PairRange> ranges;
  std::vector<Contact> contacts;
  WalkCounts counts;
  ConvexWorkspace convex;  ///< of the last pair of convex shapes
};

}  // namespace toccata
