#include <cmath>
#include <functional>
#include <limits>

#include "arguments.hpp"
#include "measure.hpp"
#include "poses.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/core/version.hpp"
#include "toccata/query/convex_parts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/penetration.hpp"

// Questions about two decomposed meshes: asked of the meshes, of the parts before the meshes, and of the parts alone.
namespace toccata::bench {
namespace {

using Question = std::function<double(const PairQuery&)>;

/// A way to ask, and whether it has to answer as the meshes do.
struct WayToAsk {
  std::string name;
  Question ask;
  bool is_exact = true;
};

struct DecomposedPair {
  ModelWithParts a;
  ModelWithParts b;
};

ModelWithParts decomposed(const std::string& file, std::size_t most) {
  const Model model(single_mesh(file));
  return {model, decompose(model, {.max_parts = most})};
}

double depth_of(const Model& a, const Model& b, const PairQuery& query) { return penetration(a, b, query).upper; }
double distance_of(const Model& a, const Model& b, const PairQuery& query) { return distance(a, b, query).upper; }
double is_overlap(const Model& a, const Model& b, const PairQuery& query) { return overlap(a, b, query) ? 1 : 0; }

std::vector<WayToAsk> ways_of(const DecomposedPair& pair, const std::string& task) {
  const auto ask = task == "penetration" ? depth_of : task == "distance" ? distance_of : is_overlap;
  std::vector<WayToAsk> ways{
      {"the meshes", [&pair, ask](const PairQuery& query) { return ask(pair.a.model(), pair.b.model(), query); }},
      {"the parts alone", [&pair, ask](const PairQuery& query) { return ask(pair.a.parts(), pair.b.parts(), query); },
       false}};
  if (task == "overlap")
    ways.insert(ways.begin() + 1, {"the parts, then the meshes", [&pair](const PairQuery& query) {
                                     return overlap(pair.a, pair.b, query) ? 1.0 : 0.0;
                                   }});
  return ways;
}

struct Asked {
  Result result;
  std::vector<double> answers;
};

/// The fastest round of each question counts.
Asked asked(const WayToAsk& way, const std::vector<PosePair>& poses, const DecomposeArguments& arguments) {
  Asked found{{}, std::vector<double>(poses.size())};
  std::vector<double> times(poses.size(), std::numeric_limits<double>::infinity());
  for (int round = 0; round < arguments.rounds; ++round)
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const PairQuery query{.pose_a = poses[i].a, .pose_b = poses[i].b};
      times[i] = std::fmin(times[i], 1e6 * seconds_of([&] { found.answers[i] = way.ask(query); }, Clock::thread));
    }
  summarise(std::move(times), found.result);
  found.result.who = {"toccata", way.name, std::string(version), TOCCATA_BENCH_FLAGS};
  found.result.task = arguments.task;
  found.result.queries = poses.size();
  return found;
}

std::size_t differences(const std::vector<double>& a, const std::vector<double>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i];
  return count;
}

}  // namespace

int run_decomposed(const DecomposeArguments& arguments) {
  const DecomposedPair pair{decomposed(arguments.mesh, arguments.parts),
                            decomposed(arguments.mesh_b.empty() ? arguments.mesh : arguments.mesh_b, arguments.parts)};
  const Nearness nearness{arguments.task == "distance" ? Nearness::Kind::separated : Nearness::Kind::jittered};
  const std::vector<PosePair> poses =
      random_poses(pair.a.model(), pair.b.model(), arguments.random, arguments.seed, nearness, 1);
  Measurements measurements;
  std::vector<double> truth;
  for (const WayToAsk& way : ways_of(pair, arguments.task)) {
    Asked found = asked(way, poses, arguments);
    if (truth.empty()) truth = found.answers;
    found.result.disagreements = differences(truth, found.answers);
    found.result.wrong = way.is_exact ? found.result.disagreements : 0;
    measurements.results.push_back(found.result);
  }
  return print_results(report_of("decompose", {{"mesh", arguments.mesh},
                                               {"mesh_b", arguments.mesh_b},
                                               {"task", arguments.task},
                                               {"max_parts", arguments.parts},
                                               {"seed", arguments.seed},
                                               {"rounds", arguments.rounds}}),
                       measurements, arguments.json);
}

}  // namespace toccata::bench
