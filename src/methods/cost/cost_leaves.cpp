#include "methods/cost/cost_leaves.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

#include "math/constants.hpp"
#include "math/world_vertex.hpp"
#include "narrow/triangles/triangle_gaps.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

constexpr std::size_t most_samples = 512;

/// What takes less is repeated, so that the clock can tell.
constexpr double shortest_timed = 20'000;

/// The time in nanoseconds, of this thread alone where the system tells it: a busy machine does not count then.
double thread_time() {
#ifdef CLOCK_THREAD_CPUTIME_ID
  std::timespec now{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) == 0)
    return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
#endif
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

double nanoseconds_of(FunctionRef<void()> work) {
  const double start = thread_time();
  work();
  return thread_time() - start;
}

TimedOperations timed(std::size_t count, FunctionRef<void()> work) {
  if (count == 0) return {};
  const double first = nanoseconds_of(work);
  if (first > 100 * shortest_timed) return {count, first};
  const int repeats = static_cast<int>(1 + shortest_timed / std::max(first, 1e-3 * shortest_timed));
  const double again = nanoseconds_of([&] {
    for (int i = 0; i < repeats; ++i) work();
  });
  return {count, std::min(first, again / repeats)};
}

Triangle CostSide::world(Index number) const {
  const Triangle& local = triangles[number];
  return {{world_vertex(pose, local[0]), world_vertex(pose, local[1]), world_vertex(pose, local[2])}};
}

CostLeaves::CostLeaves(CostTask task, const CostSide& a, const CostSide& b)
    : task_(task), a_(a), b_(b), limit_(task == CostTask::distance ? std::numeric_limits<double>::max() : 0) {}

void CostLeaves::visit(std::span<const ItemPair> pairs) {
  const auto room = static_cast<std::ptrdiff_t>(std::min(pairs.size(), most_samples - sample_.size()));
  sample_.insert(sample_.end(), pairs.begin(), pairs.begin() + room);
  look_at(pairs);
}

void CostLeaves::look_at(std::span<const ItemPair> pairs) {
  if (task_ == CostTask::distance) {
    for (; !pairs.empty(); pairs = pairs.subspan(std::min(TrianglePairBlock::lanes, pairs.size())))
      bound_distances(pairs.first(std::min(TrianglePairBlock::lanes, pairs.size())));
    return;
  }
  for (const ItemPair& pair : pairs)
    if (meet(pair)) {
      ++intersection_;
      if (task_ == CostTask::overlap) limit_ = -1;
    }
}

/// What is known of a pair depends on the pair alone, so the least over all pairs does not depend on their order.
void CostLeaves::bound_distances(std::span<const ItemPair> pairs) {
  TriangleGaps gaps;
  for (std::size_t lane = 0; lane < pairs.size(); ++lane)
    set_pair(block_, lane, a_.world(pairs[lane].first), b_.world(pairs[lane].second));
  bound_gaps(block_, gaps);
  for (std::size_t lane = 0; lane < pairs.size() && limit_ >= 0; ++lane) {
    if (gaps.lower[lane] > limit_) continue;
    if (gaps.lower[lane] == 0 && meet(pairs[lane])) {
      ++intersection_;
      limit_ = -1;
    } else {
      const bool known = gaps.upper[lane] < infinity;
      const double upper =
          known
              ? gaps.upper[lane]
              : distance(PosedPolytope(a_.world(pairs[lane].first)), PosedPolytope(b_.world(pairs[lane].second))).upper;
      limit_ = std::min(limit_, upper);
    }
  }
}

double CostLeaves::answer() const {
  switch (task_) {
    case CostTask::overlap:
      return intersection_ > 0 ? 1 : 0;
    case CostTask::contacts:
      return static_cast<double>(intersection_);
    case CostTask::distance:
      break;
  }
  return intersection_ > 0 ? 0 : limit_;
}

TimedOperations CostLeaves::time_items() {
  CostLeaves again(task_, a_, b_);
  return timed(sample_.size(), [&] {
    again.limit_ = limit_ < 0 ? 0 : limit_;
    again.look_at(sample_);
  });
}

}  // namespace toccata
