#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "arguments.hpp"
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

using MotionResults = std::map<std::pair<std::string, std::string>, MotionResult>;

template <class Pair>
double nanoseconds_of(const Pair& pair, int repetitions) {
  std::size_t hits = 0;
  const double seconds = seconds_of([&] {
    for (int i = 0; i < repetitions; ++i) hits += time_of_impact(pair).hit;
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
  for (const test::MotionQuery<Pair>& query : queries) {
    const double time = least_nanoseconds(query.pair, rounds);
    const bool is_hit = time_of_impact(query.pair).hit;
    for (const std::string& scene : {query.name.substr(0, query.name.find(' ')), std::string("all scenes")}) {
      MotionResult& result = results[{kind, scene}];
      result.nanoseconds.push_back(time);
      result.hits += query.is_hit;
      result.missed += query.is_hit && !is_hit;
      result.false_alarms += !query.is_hit && is_hit;
    }
  }
}

nlohmann::ordered_json json_of(const std::string& kind, const std::string& scene, MotionResult result) {
  std::vector<double>& times = result.nanoseconds;
  std::sort(times.begin(), times.end());
  double sum = 0;
  for (const double time : times) sum += time;
  return {{"task", kind},
          {"scene", scene},
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
  std::cout << fmt::format("{:<12} {:<28} {:>7} {:>5} {:>7} {:>6} {:>8.0f} {:>8.0f} {:>9.0f} {:>9.0f}\n",
                           row["task"].get<std::string>(), row["scene"].get<std::string>(), row["queries"].get<int>(),
                           row["hits"].get<int>(), row["missed"].get<int>(), row["false_alarms"].get<int>(),
                           row["median_ns"].get<double>(), row["mean_ns"].get<double>(), row["p99_ns"].get<double>(),
                           row["worst_ns"].get<double>());
}

}  // namespace

int run_motion(const MotionArguments& arguments) {
  if (arguments.data.empty())
    throw Error("motion: no data; name the folder that has ccd with --data, or set TOCCATA_DATA");
  MotionResults results;
  measure(test::vertex_face_queries(arguments.data), "vertex-face", arguments.rounds, results);
  measure(test::edge_edge_queries(arguments.data), "edge-edge", arguments.rounds, results);
  auto report = report_of("motion", {{"rounds", arguments.rounds}});
  std::size_t wrong = 0;
  for (const auto& [name, result] : results) {
    report["results"].push_back(json_of(name.first, name.second, result));
    wrong += result.missed + result.false_alarms;
  }
  if (arguments.json) {
    std::cout << report.dump(2) << "\n";
  } else {
    std::cout << "task         scene                        queries  hits  missed  false   median     mean       p99   "
                 "  worst\n";
    for (const auto& row : report["results"]) print_row(row);
    std::cout << "times in nanoseconds\n";
  }
  return wrong == 0 ? 0 : 1;
}

}  // namespace toccata::bench
