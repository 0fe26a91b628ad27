#include "query/meshes/spread_search.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>

#include "query/meshes/mesh_walk.hpp"
#include "query/meshes/pair_visitors.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

// A search that is spread over threads begins breadth first with so many entries, of which each thread takes some
// whenever it is free: few enough that the beginning costs little, and many enough that all end together.
constexpr std::size_t entries_per_thread = 128;
constexpr std::size_t at_once = 4;

/// The entries of a frontier, shared out to whoever comes.
class SharedEntries {
 public:
  explicit SharedEntries(const WideFrontier& from) : from_(from) {}

  /// The next entries, as those of a frontier that has none left; says whether there were any.
  bool take(WideFrontier& to) {
    const std::size_t first = next_.fetch_add(at_once, std::memory_order_relaxed);
    if (first >= from_.size) return false;
    to.size = std::min(at_once, from_.size - first);
    for (auto [all, own] : {std::pair(&from_.blocks, &to.blocks), std::pair(&from_.boxes, &to.boxes)}) {
      if (own->size() < at_once) own->resize(at_once);
      std::copy_n(all->begin() + static_cast<std::ptrdiff_t>(first), to.size, own->begin());
    }
    return true;
  }

 private:
  const WideFrontier& from_;
  std::atomic<std::size_t> next_ = 0;
};

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
  WideFrontier& largest = scratch.main.frontier;
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
  Collector<OfTwoMeshes> collect(a, b, scratch.main);
  if (!overlap(a.box(), b.box())) return;
  const MeshWalk walk(a, b);
  const auto parts = static_cast<std::size_t>(thread_count(threads));
  walk->start(scratch.main.frontier, WideWalk::largest_batch);
  walk->spread(scratch.main.frontier, entries_per_thread * parts, collect);
  prepare_parts(scratch, parts);
  SharedEntries entries(scratch.main.frontier);
  parallel_for(parts, threads, [&](std::size_t i) { run_part(a, b, walk, entries, *scratch.others[i]); });
  scratch.counts = scratch.main.frontier.counts;
  for (std::size_t i = 0; i < parts; ++i) {
    scratch.counts.volume_tests += scratch.others[i]->frontier.counts.volume_tests;
    scratch.counts.items += scratch.others[i]->frontier.counts.items;
  }
  share_growth(scratch);
}

}  // namespace toccata
