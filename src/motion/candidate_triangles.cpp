#include "motion/candidate_triangles.hpp"

#include <algorithm>
#include <atomic>

#include "query/meshes/wide_cull.hpp"
#include "query/scenes/task_reporter.hpp"
#include "toccata/core/parallel.hpp"
#include "trees/shared_entries.hpp"
#include "trees/wide_walk.hpp"

namespace toccata {
namespace {

// Blocks from which one thread starts at a time: some hundred candidates of a smooth surface.
constexpr std::uint32_t blocks_at_once = 16;

/// Hands on what one thread finds, and knows whether all are to end.
class ThreadVisitor final : public WideVisitor {
 public:
  ThreadVisitor(std::size_t thread, SeeCandidates see, std::atomic<bool>& ended)
      : thread_(thread), see_(see), ended_(ended) {}
  bool visit(std::span<const ItemPair> pairs) override {
    if (!see_(thread_, pairs)) ended_.store(true, std::memory_order_relaxed);
    return !has_ended();
  }
  [[nodiscard]] bool has_ended() const { return ended_.load(std::memory_order_relaxed); }

 private:
  std::size_t thread_;
  SeeCandidates see_;
  std::atomic<bool>& ended_;
};

/// Blocks of a tree, shared out to the threads that walk on from them.
class SharedBlocks {
 public:
  explicit SharedBlocks(std::size_t count) : count_(static_cast<std::uint32_t>(count)) {}
  [[nodiscard]] std::size_t shares() const { return (count_ + blocks_at_once - 1) / blocks_at_once; }
  /// Empty when there are none left.
  BlockRange take() {
    const std::uint32_t first = std::min(next_.fetch_add(blocks_at_once, std::memory_order_relaxed), count_);
    return {first, std::min(first + blocks_at_once, count_)};
  }

 private:
  std::uint32_t count_;
  std::atomic<std::uint32_t> next_ = 0;
};

}  // namespace

void visit_candidates(const WideBvh& a, const WideBvh& b, double reach, const CandidateWork& work, SeeCandidates see) {
  const WideCull cull = wide_cull_in_one_frame(a, b, reach);
  const WideWalk walk(a, b, cull);
  std::atomic<bool> ended = false;
  WideFrontier frontier;
  walk.start(frontier, WideWalk::largest_batch);
  const auto count = static_cast<std::size_t>(thread_count(work.threads));
  ThreadVisitor first(0, see, ended);
  walk.spread(frontier, SharedEntries::wanted_per_thread * count, first);
  SharedEntries entries(frontier);
  TaskReporter reporter(work.progress, entries.shares());
  parallel_for(count, work.threads, [&](std::size_t thread) {
    ThreadVisitor visitor(thread, see, ended);
    WideFrontier own;
    walk.start(own, WideWalk::largest_batch);
    while (!visitor.has_ended() && !reporter.cancelled() && entries.take(own)) {
      walk.run(own, visitor);
      reporter.finished_one();
    }
  });
}

void visit_candidates(const WideBvh& tree, double reach, const CandidateWork& work, SeeCandidates see) {
  const WideCull cull = wide_cull_in_one_frame(tree, tree, reach);
  const WideWalk walk(tree, tree, cull);
  std::atomic<bool> ended = false;
  SharedBlocks blocks(tree.blocks.size());
  TaskReporter reporter(work.progress, blocks.shares());
  parallel_for(static_cast<std::size_t>(thread_count(work.threads)), work.threads, [&](std::size_t thread) {
    ThreadVisitor visitor(thread, see, ended);
    WideFrontier own;
    const auto take = [&] { return visitor.has_ended() || reporter.cancelled() ? BlockRange{} : blocks.take(); };
    for (BlockRange range = take(); range.first < range.last; range = take()) {
      walk.run_self(own, WideWalk::largest_batch, range, visitor);
      reporter.finished_one();
    }
  });
}

}  // namespace toccata
