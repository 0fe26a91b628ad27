#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "library.hpp"

namespace toccata::bench {

/// A row of the report; times in microseconds unless said.
struct Result {
  Description who;
  std::string task;
  int threads = 1;
  std::size_t queries = 0;
  double median_us = 0;
  double mean_us = 0;  ///< where several queries are asked at a time: the whole time over their number
  double p99_us = 0;
  double build_ms = 0;  ///< of both meshes
  double bytes_per_triangle = 0;
  std::size_t disagreements = 0;  ///< queries that Toccata answers otherwise; Toccata's own: any peer does
  std::size_t wrong = 0;          ///< judged where answers differ, or everywhere with --verify
};

/// What the time is that something takes.
enum class Clock {
  wall,
  thread,  ///< of the processor, spent by the calling thread: other programs that run meanwhile do not count
};

double seconds_of(const std::function<void()>& work, Clock clock = Clock::wall);

/// The time of one question of each block, in microseconds, in the fastest of the rounds. Each round asks all: a block
/// again at once would be measured with branches that the processor has learnt. `ask(first, answers)` answers a block.
template <class Told, class Ask>
std::vector<double> fastest_of_blocks(std::span<Told> answers, std::size_t block, int rounds, Clock clock,
                                      const Ask& ask) {
  std::vector<double> fastest((answers.size() + block - 1) / block, std::numeric_limits<double>::infinity());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < fastest.size(); ++i) {
      const std::span<Told> part = answers.subspan(i * block, std::min(block, answers.size() - i * block));
      const double seconds = seconds_of([&] { ask(i * block, part); }, clock);
      fastest[i] = std::min(fastest[i], 1e6 * seconds / static_cast<double>(part.size()));
    }
  return fastest;
}

/// Fills median, mean and p99 (the value that 99 % do not exceed) from the time of each query, in microseconds.
void summarise(std::vector<double> microseconds, Result& result);

struct MeasureOptions {
  int threads = 1;
  int rounds = 3;             ///< of each query the fastest counts, so that other programs disturb less
  Clock clock = Clock::wall;  ///< that of the thread only with one thread
};

/// What a library answered, in the order of the queries, and how long it took.
struct Answered {
  Result result;
  std::vector<Answer> answers;
};

/// The library must have been built.
Answered measure_queries(MeshLibrary& library, Task task, const std::vector<PosePair>& poses,
                         const MeasureOptions& options);

/// `rounds` builds; of each library the median counts as its build time.
Result measure_build(MeshLibrary& library, const TriangleMesh& a, const TriangleMesh& b, const MeasureOptions& options);

}  // namespace toccata::bench
