#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "arguments.hpp"
#include "feature_peer.hpp"
#include "report.hpp"
#include "support/motion_data.hpp"
#include "toccata/core/error.hpp"

namespace toccata::bench {
namespace {

/// The questions of one scene, or of all, about one kind of pair.
struct MotionResult {
  std::vector<double> nanoseconds;  ///< of each query
  std::size_t hits = 0;
  std::size_t missed = 0;
  std::size_t false_alarms = 0;
};

/// By library and method, kind of pair, and scene.
struct MotionKey {
  std::string library;
  std::string variant;
  std::string kind;
  std::string scene;
  friend auto operator<=>(const MotionKey&, const MotionKey&) = default;
};
using MotionResults = std::map<MotionKey, MotionResult>;

void add_answer(MotionResults& results, MotionKey key, const std::string& query, bool truth,
                const FeaturePeerMethod::Answer& answer) {
  for (const std::string& scene : {query.substr(0, query.find(' ')), std::string("all scenes")}) {
    key.scene = scene;
    MotionResult& result = results[key];
    result.nanoseconds.push_back(answer.nanoseconds);
    result.hits += truth;
    result.missed += truth && !answer.hit;
    result.false_alarms += !truth && answer.hit;
  }
}

template <class Pair>
double nanoseconds_of(const Pair& pair, int repetitions) {
  std::size_t hits = 0;
  const double seconds = seconds_of([&] {
    for (int i = 0; i < repetitions; ++i) hits += time_of_impact(pair).has_value();
  });
  if (hits != 0 && hits != static_cast<std::size_t>(repetitions))
    throw Error("motion: an answer has changed between two runs");
  return 1e9 * seconds / repetitions;
}

/// The least mean of several runs of the same query where it is too short for a clock; one that is long is interrupted
/// less often alone.
template <class Pair>
double least_nanoseconds(const Pair& pair, int rounds) {
  const int repetitions = nanoseconds_of(pair, 1) < 10'000 ? 16 : 1;
  double least = HUGE_VAL;
  for (int round = 0; round < rounds; ++round) least = std::min(least, nanoseconds_of(pair, repetitions));
  return least;
}

template <class Pair>
void measure(const std::vector<test::MotionQuery<Pair>>& queries, const std::string& kind, int rounds,
             MotionResults& results) {
  for (const test::MotionQuery<Pair>& query : queries)
    add_answer(results, {"toccata", "time_of_impact", kind, {}}, query.name, query.is_hit,
               {time_of_impact(query.pair).has_value(), least_nanoseconds(query.pair, rounds)});
}

using VertexFaceQueries = std::vector<test::MotionQuery<VertexFace>>;
using EdgeEdgeQueries = std::vector<test::MotionQuery<EdgeEdge>>;

template <class Pair>
std::vector<Pair> pairs_of(const std::vector<test::MotionQuery<Pair>>& queries) {
  std::vector<Pair> pairs;
  for (const test::MotionQuery<Pair>& query : queries) pairs.push_back(query.pair);
  return pairs;
}

/// Or why not.
void measure_ipctk(const VertexFaceQueries& vertex_faces, const EdgeEdgeQueries& edge_edges, int rounds,
                   MotionResults& results, nlohmann::ordered_json& report) {
  const FeaturePeer peer = ask_ipctk(pairs_of(vertex_faces), pairs_of(edge_edges), rounds);
  if (!peer.missing.empty()) report["not_measured"].push_back({{"library", "ipctk"}, {"reason", peer.missing}});
  for (const FeaturePeerMethod& method : peer.methods) {
    const std::string variant = fmt::format("{} {}, from Python", method.name, peer.version);
    report["floors"].push_back({{"library", "ipctk"}, {"variant", variant}, {"floor_ns", method.floor_nanoseconds}});
    if (method.answers.size() != vertex_faces.size() + edge_edges.size())
      throw Error(fmt::format("motion: ipctk answered {} of {} questions", method.answers.size(),
                              vertex_faces.size() + edge_edges.size()));
    auto answer = method.answers.begin();
    for (const auto& query : vertex_faces)
      add_answer(results, {"ipctk", variant, "vertex-face", {}}, query.name, query.is_hit, *answer++);
    for (const auto& query : edge_edges)
      add_answer(results, {"ipctk", variant, "edge-edge", {}}, query.name, query.is_hit, *answer++);
  }
}

nlohmann::ordered_json json_of(const MotionKey& key, MotionResult result) {
  std::vector<double>& times = result.nanoseconds;
  std::sort(times.begin(), times.end());
  double sum = 0;
  for (const double time : times) sum += time;
  return {{"library", key.library},
          {"variant", key.variant},
          {"task", key.kind},
          {"scene", key.scene},
          {"queries", times.size()},
          {"hits", result.hits},
          {"missed", result.missed},
          {"false_alarms", result.false_alarms},
          {"median_ns", times[times.size() / 2]},
          {"mean_ns", sum / static_cast<double>(times.size())},
          {"p99_ns", times[times.size() * 99 / 100]},
          {"worst_ns", times.back()}};
}

void print_row(const nlohmann::ordered_json& row) {
  std::cout << fmt::format("{:<9} {:<36} {:<12} {:<28} {:>7} {:>5} {:>7} {:>6} {:>8.0f} {:>8.0f} {:>9.0f} {:>10.0f}\n",
                           row["library"].get<std::string>(), row["variant"].get<std::string>(),
                           row["task"].get<std::string>(), row["scene"].get<std::string>(), row["queries"].get<int>(),
                           row["hits"].get<int>(), row["missed"].get<int>(), row["false_alarms"].get<int>(),
                           row["median_ns"].get<double>(), row["mean_ns"].get<double>(), row["p99_ns"].get<double>(),
                           row["worst_ns"].get<double>());
}

void print_report(const nlohmann::ordered_json& report) {
  std::cout
      << "library   variant                              task         scene                        queries  hits  "
         "missed  false   median     mean       p99      worst\n";
  for (const auto& row : report["results"]) print_row(row);
  for (const auto& row : report["floors"])
    std::cout << fmt::format("of {}, {}, {:.0f} are the call from Python for a vertex and a face that rest apart\n",
                             row["library"].get<std::string>(), row["variant"].get<std::string>(),
                             row["floor_ns"].get<double>());
  for (const auto& row : report["not_measured"])
    std::cout << fmt::format("{} is not measured: {}\n", row["library"].get<std::string>(),
                             row["reason"].get<std::string>());
  std::cout << "times in nanoseconds\n";
}

}  // namespace

int run_motion(const MotionArguments& arguments) {
  if (arguments.data.empty())
    throw Error("motion: no data; name the folder that has ccd with --data, or set TOCCATA_DATA");
  const VertexFaceQueries vertex_faces = test::vertex_face_queries(arguments.data);
  const EdgeEdgeQueries edge_edges = test::edge_edge_queries(arguments.data);
  MotionResults results;
  measure(vertex_faces, "vertex-face", arguments.rounds, results);
  measure(edge_edges, "edge-edge", arguments.rounds, results);
  auto report = report_of("motion", {{"rounds", arguments.rounds}});
  for (const char* list : {"results", "floors", "not_measured"}) report[list] = nlohmann::ordered_json::array();
  if (std::ranges::count(arguments.peers, feature_peer) > 0)
    measure_ipctk(vertex_faces, edge_edges, arguments.rounds, results, report);
  std::size_t wrong = 0;
  for (const auto& [key, result] : results) {
    report["results"].push_back(json_of(key, result));
    if (key.library == "toccata") wrong += result.missed + result.false_alarms;
  }
  if (arguments.json)
    std::cout << report.dump(2) << "\n";
  else
    print_report(report);
  return wrong == 0 ? 0 : 1;
}

}  // namespace toccata::bench
