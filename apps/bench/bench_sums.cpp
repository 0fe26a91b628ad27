#include <algorithm>
#include <cmath>
#include <limits>

#include "arguments.hpp"
#include "report.hpp"
#include "sums.hpp"
#include "toccata/core/random.hpp"

namespace toccata::bench {
namespace {

/// One answer takes less time than a look at the clock, so times are of a batch, divided.
constexpr std::size_t points_at_once = 500;
constexpr std::size_t sums_at_once = 10;

/// Points on a sphere, which are all vertices.
ConvexHull round_hull(std::size_t vertices, Random& random) {
  std::vector<Vec3> points;
  while (points.size() < vertices) {
    const Vec3 p{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double length = std::sqrt(dot(p, p));
    if (length > 0.1 && length < 1) points.push_back((1 / length) * p);
  }
  return ConvexHull(points);
}

struct SumWork {
  std::vector<SumPair> pairs;
  std::vector<Vec3> points;
};

SumWork work_of(const SumsArguments& arguments) {
  Random random(arguments.seed);
  SumWork work;
  const std::size_t pairs = arguments.task == "sum" ? arguments.count : 1;
  for (std::size_t i = 0; i < pairs; ++i)
    work.pairs.push_back({round_hull(arguments.vertices, random), round_hull(arguments.vertices, random)});
  // A third of them inside, and none so far away that any method would see it at once.
  for (std::size_t i = 0; arguments.task == "point" && i < arguments.count; ++i)
    work.points.push_back({random.between(-2.1, 2.1), random.between(-2.1, 2.1), random.between(-2.1, 2.1)});
  return work;
}

struct SumRun {
  Result result;
  std::vector<Index> answers;
};

/// The fastest round of each batch counts; a batch again at once would be measured with branches that were learnt.
SumRun measured(SumLibrary& library, const SumWork& work, const SumsArguments& arguments) {
  const bool of_points = arguments.task == "point";
  const std::size_t count = of_points ? work.points.size() : work.pairs.size();
  const std::size_t batch = of_points ? points_at_once : sums_at_once;
  const Clock clock = arguments.clock == "thread" ? Clock::thread : Clock::wall;
  library.prepare(work.pairs);
  SumRun run{{}, std::vector<Index>(count)};
  if (of_points) run.result.build_ms = 1e3 * seconds_of([&] { library.make_ready(); }, clock);
  std::vector<double> times((count + batch - 1) / batch, std::numeric_limits<double>::infinity());
  for (int round = 0; round < arguments.rounds; ++round)
    for (std::size_t i = 0; i < times.size(); ++i) {
      const std::size_t first = i * batch, last = std::min(first + batch, count);
      const double seconds = seconds_of(
          [&] {
            for (std::size_t k = first; k < last; ++k)
              run.answers[k] = of_points ? Index{library.contains(work.points[k])} : library.make(k);
          },
          clock);
      times[i] = std::min(times[i], 1e6 * seconds / static_cast<double>(last - first));
    }
  summarise(std::move(times), run.result);
  run.result.who = library.description();
  run.result.task = arguments.task;
  run.result.queries = count;
  return run;
}

std::size_t differences(const std::vector<Index>& a, const std::vector<Index>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
  return count;
}

}  // namespace

int run_sums(const SumsArguments& arguments) {
  const SumWork work = work_of(arguments);
  std::vector<Result> results;
  std::vector<Index> ours;
  for (const auto& library : sum_libraries(arguments.peers)) {
    SumRun run = measured(*library, work, arguments);
    if (ours.empty()) ours = run.answers;
    run.result.disagreements = differences(ours, run.answers);
    results.push_back(run.result);
  }
  for (const Result& other : results)
    results[0].disagreements = std::max(results[0].disagreements, other.disagreements);
  return print_results(report_of("sums", {{"task", arguments.task},
                                          {"vertices", arguments.vertices},
                                          {"seed", arguments.seed},
                                          {"rounds", arguments.rounds},
                                          {"clock", arguments.clock}}),
                       {results, {}}, arguments.json);
}

}  // namespace toccata::bench
