#include "measure.hpp"

#include <algorithm>
#include <ctime>
#include <limits>
#include <numeric>

#include "toccata/core/parallel.hpp"

namespace toccata::bench {
namespace {

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double now(Clock clock) {
  timespec time{};
  clock_gettime(clock == Clock::wall ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

double seconds_of(const std::function<void()>& work, Clock clock) {
  const double start = now(clock);
  work();
  return now(clock) - start;
}

void summarise(std::vector<double> microseconds, Result& result) {
  std::sort(microseconds.begin(), microseconds.end());
  const std::size_t count = microseconds.size();
  result.queries = count;
  result.median_us = (microseconds[(count - 1) / 2] + microseconds[count / 2]) / 2;
  result.mean_us = mean_of(microseconds);
  result.p99_us = microseconds[(count * 99 + 99) / 100 - 1];
}

Answered measure_queries(MeshLibrary& library, Task task, const std::vector<PosePair>& poses,
                         const MeasureOptions& options) {
  const int at_a_time = library.spreads_queries(task, options.threads) ? 1 : options.threads;
  Answered answered;
  answered.answers.resize(poses.size());
  std::vector<double> fastest(poses.size(), std::numeric_limits<double>::infinity());
  double fastest_round = std::numeric_limits<double>::infinity();
  const auto ask = [&](std::size_t i) {
    const double seconds = seconds_of([&] { answered.answers[i] = library.answer(task, poses[i]); }, options.clock);
    fastest[i] = std::min(fastest[i], 1e6 * seconds);
  };
  for (int round = 0; round < options.rounds; ++round)
    fastest_round = std::min(fastest_round, seconds_of([&] { parallel_for(poses.size(), at_a_time, ask); }));
  summarise(std::move(fastest), answered.result);
  if (at_a_time != 1) answered.result.mean_us = 1e6 * fastest_round / static_cast<double>(poses.size());
  answered.result.threads = options.threads;
  return answered;
}

Result measure_build(MeshLibrary& library, const TriangleMesh& a, const TriangleMesh& b,
                     const MeasureOptions& options) {
  std::vector<double> times;
  for (int round = 0; round < options.rounds; ++round)
    times.push_back(1e6 * seconds_of([&] { library.build(a, b); }, options.clock));
  Result result;
  summarise(std::move(times), result);
  result.who = library.description();
  result.build_ms = 1e-3 * result.median_us;
  result.bytes_per_triangle = static_cast<double>(library.bytes()) / (a.triangle_count() + b.triangle_count());
  return result;
}

}  // namespace toccata::bench
