#pragma once

#include <array>
#include <memory>
#include <vector>

#include "narrow/triangle_pair_block.hpp"
#include "toccata/query/contacts.hpp"
#include "trees/wide_walk.hpp"

namespace toccata {

/// Memory that searches need and keep: see Workspace.
struct SearchScratch {
  WideFrontier frontier;
  std::array<TrianglePairBlock, 8> blocks{};  ///< as many as stay in the nearest cache
  std::vector<Contact> contacts;
  /// For the parts of a search that is spread over threads.
  std::vector<std::unique_ptr<SearchScratch>> parts;
  WalkCounts counts;
};

}  // namespace toccata
