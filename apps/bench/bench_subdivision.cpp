#include <algorithm>
#include <limits>

#include "arguments.hpp"
#include "query/subdivision_cages.hpp"
#include "report.hpp"
#include "subdivisions.hpp"
#include "toccata/core/random.hpp"
#include "toccata/query/nearest.hpp"

namespace toccata::bench {
namespace {

SubdivisionCage cage_of(const SubdivisionArguments& arguments) {
  const bool is_loop = arguments.scheme == "loop";
  return {arguments.cage == "torus" ? test::torus_cage(8, 6, is_loop) : test::bipyramid_cage(12),
          is_loop ? SubdivisionScheme::loop : SubdivisionScheme::catmull_clark};
}

/// Beside the cage, some of them near.
std::vector<Pose> poses_of(const SubdivisionArguments& arguments) {
  Random random(arguments.seed);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < arguments.count; ++i) {
    const double turn = random.between(0, 360);
    poses.push_back(Pose::rotation({0, 0, 1}, turn) * Pose::translation(random.between(3.2, 5), 0, 0) *
                    Pose::rotation({1, 2, 3}, random.between(0, 360)));
  }
  return poses;
}

struct LimitRun {
  Result result;
  std::vector<Vec3> points;              ///< of the mesh
  std::vector<LimitInterval> intervals;  ///< of the distances
};

/// The fastest round of each question counts.
LimitRun measured(LimitLibrary& library, const SubdivisionCage& cage, const SubdivisionArguments& arguments) {
  const Clock clock = arguments.clock == "thread" ? Clock::thread : Clock::wall;
  const Model box = Box({0.4, 0.3, 0.2});
  const std::vector<Pose> poses = poses_of(arguments);
  const bool of_mesh = arguments.task == "mesh";
  LimitRun run;
  if (of_mesh) run.points = library.make(cage, arguments.within);
  if (!of_mesh) run.result.build_ms = 1e3 * seconds_of([&] { library.make_ready(cage, arguments.within); }, clock);
  run.intervals.resize(of_mesh ? 0 : poses.size());
  std::vector<double> times(of_mesh ? 1 : poses.size(), std::numeric_limits<double>::infinity());
  for (int round = 0; round < arguments.rounds; ++round)
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double seconds = seconds_of(
          [&] {
            if (of_mesh) run.points = library.make(cage, arguments.within);
            if (!of_mesh) run.intervals[i] = library.distance(box, poses[i]);
          },
          clock);
      times[i] = std::min(times[i], 1e6 * seconds);
    }
  run.result.queries = times.size();
  summarise(std::move(times), run.result);
  run.result.who = library.description();
  run.result.task = arguments.task;
  return run;
}

/// Points that are farther from the proved mesh than its bound and their own allow, and intervals without a common
/// number.
std::size_t differences(const LimitRun& run, const LimitRun& ours, const Model& mesh, double within) {
  std::size_t count = 0;
  for (const Vec3& p : run.points) count += std::size_t{nearest_point(p, mesh)->lower > 2 * within};
  for (std::size_t i = 0; i < run.intervals.size(); ++i) {
    const LimitInterval &a = run.intervals[i], &b = ours.intervals[i];
    count += std::size_t{std::max(a.lower, b.lower) > std::min(a.upper, b.upper)};
  }
  return count;
}

}  // namespace

int run_subdivision(const SubdivisionArguments& arguments) {
  const SubdivisionCage cage = cage_of(arguments);
  LimitLibraries libraries = toccata_limit_libraries();
  if (!arguments.peers.empty())
    for (auto& peer : osd_limit_libraries()) libraries.push_back(std::move(peer));
  const Model mesh(refine(cage, {.tolerance = arguments.within}).mesh);
  std::vector<LimitRun> runs;
  std::vector<Result> results;
  for (const auto& library : libraries) {
    runs.push_back(measured(*library, cage, arguments));
    runs.back().result.disagreements = differences(runs.back(), runs.front(), mesh, arguments.within);
    results.push_back(runs.back().result);
  }
  for (const Result& other : results)
    results[0].disagreements = std::max(results[0].disagreements, other.disagreements);
  return print_results(report_of("subdivision", {{"task", arguments.task},
                                                 {"cage", arguments.cage},
                                                 {"scheme", arguments.scheme},
                                                 {"within", arguments.within},
                                                 {"seed", arguments.seed},
                                                 {"rounds", arguments.rounds},
                                                 {"clock", arguments.clock}}),
                       {results, {}}, arguments.json);
}

}  // namespace toccata::bench
