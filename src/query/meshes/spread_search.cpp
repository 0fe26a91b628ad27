#include "query/meshes/spread_search.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "query/meshes/mesh_walk.hpp"
#include "query/meshes/pair_visitors.hpp"
#include "toccata/core/parallel.hpp"
#include "trees/shared_entries.hpp"

namespace toccata {
namespace {

void run_part(const PosedMesh& a, const PosedMesh& b, const MeshWalk& walk, SharedEntries& entries, SearchPart& part) {
  Collector<OfTwoMeshes> collect(a, b, part);
  walk->start(part.frontier, WideWalk::largest_batch);
  while (entries.take(part.frontier)) walk->run(part.frontier, collect);
}

void prepare_parts(SearchScratch& scratch, std::size_t count) {
  while (scratch.others.size() < count) scratch.others.push_back(std::make_unique<SearchPart>());
}

/// Which part finds what depends on timing. So each gets the memory that any may need in the same search: a second one
/// allocates nothing, whoever is faster then.
void share_growth(SearchScratch& scratch) {
  std::size_t pairs = 0, intersections = 0;
  WideFrontier& largest = scratch.main->frontier;
  for (const auto& part : scratch.others) {
    pairs += part->found.pairs.size();
    intersections += part->found.intersections.size();
    largest.grow_like(part->frontier);
  }
  for (const auto& part : scratch.others) {
    part->found.pairs.reserve(pairs);
    part->found.intersections.reserve(intersections);
    part->frontier.grow_like(largest);
  }
}

}  // namespace

void find_on_threads(const PosedMesh& a, const PosedMesh& b, SearchScratch& scratch, int threads) {
  scratch.counts = {};
  Collector<OfTwoMeshes> collect(a, b, *scratch.main);
  if (!overlap(a.box(), b.box())) return;
  const MeshWalk walk(a, b);
  const auto parts = static_cast<std::size_t>(thread_count(threads));
  walk->start(scratch.main->frontier, WideWalk::largest_batch);
  walk->spread(scratch.main->frontier, SharedEntries::wanted_per_thread * parts, collect);
  prepare_parts(scratch, parts);
  SharedEntries entries(scratch.main->frontier);
  parallel_for(parts, threads, [&](std::size_t i) { run_part(a, b, walk, entries, *scratch.others[i]); });
  scratch.counts = scratch.main->frontier.counts;
  for (std::size_t i = 0; i < parts; ++i) {
    scratch.counts.volume_tests += scratch.others[i]->frontier.counts.volume_tests;
    scratch.counts.items += scratch.others[i]->frontier.counts.items;
  }
  share_growth(scratch);
}

}  // namespace toccata
