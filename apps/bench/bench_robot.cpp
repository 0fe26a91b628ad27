#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "arguments.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "robots.hpp"
#include "toccata/core/version.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::bench {
namespace {

using RobotRows = nlohmann::ordered_json;

constexpr const char* robot_tasks[] = {"configurations", "edges", "first contacts", "distances"};

/// Whole batches on one thread; the fastest round counts.
struct RobotRow {
  Description who;
  std::string task;
  std::size_t count = 0;
  double mean_us = 0;
  std::size_t found = 0;  ///< configurations that meet, edges that are not free
  std::size_t disagreements = 0;
};

double fastest_us(const std::function<void()>& work, std::size_t count, int rounds) {
  double least = 0;
  for (int round = 0; round < rounds; ++round) {
    const double us = 1e6 * seconds_of(work, Clock::thread) / static_cast<double>(count);
    least = round == 0 ? us : std::min(least, us);
  }
  return least;
}

std::size_t count_of_ones(const std::vector<std::uint8_t>& answers) {
  return static_cast<std::size_t>(std::ranges::count(answers, 1));
}

std::size_t count_of_others(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1U : 0U;
  return count;
}

/// The same by the question about two models, pair by pair.
std::vector<std::uint8_t> meets_by_pairs(const RobotScene& scene, std::span<const double> configurations) {
  const std::size_t positions = scene.robot().positions().size();
  const auto bodies = scene.robot().bodies();
  const auto meet = [](const SceneInstance& a, const SceneInstance& b) {
    return overlap(a.model, b.model, {a.pose, b.pose, a.solid, b.solid});
  };
  std::vector<std::uint8_t> found;
  for (std::size_t i = 0; i < configurations.size(); i += positions) {
    const std::vector<SceneInstance> posed = scene.robot().posed(configurations.subspan(i, positions));
    bool meets = false;
    for (std::size_t a = 0; a < posed.size() && !meets; ++a) {
      for (std::size_t b = a + 1; b < posed.size() && !meets; ++b)
        meets = scene.looks_at({bodies[a].link, false, bodies[b].link}) && meet(posed[a], posed[b]);
      for (std::size_t b = 0; b < scene.obstacles().size() && !meets; ++b) meets = meet(posed[a], scene.obstacles()[b]);
    }
    found.push_back(meets ? 1 : 0);
  }
  return found;
}

Description toccata_in(const char* variant) { return {"toccata", variant, std::string(version), TOCCATA_BENCH_FLAGS}; }

/// Edges from each configuration a part of the way to another.
std::vector<double> ends_of_edges(const std::vector<double>& from, const Robot& robot,
                                  const RobotArguments& arguments) {
  std::vector<double> to = sampled_configurations(robot, arguments.count, arguments.seed + 1);
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = from[i] + arguments.edge * (to[i] - from[i]);
  return to;
}

std::vector<RobotRow> robot_rows(const RobotScene& scene, const RobotArguments& arguments) {
  const Robot& robot = scene.robot();
  const std::vector<double> from = sampled_configurations(robot, arguments.count, arguments.seed);
  const std::vector<double> to = ends_of_edges(from, robot, arguments);
  const BatchOptions one_thread{.threads = own_thread};
  std::vector<std::uint8_t> meets, free;
  std::vector<RobotEdge> edges;
  std::vector<std::optional<RobotDistance>> distances;
  std::vector<RobotRow> rows;
  const auto add = [&](const char* variant, const char* task, const std::function<void()>& work) -> RobotRow& {
    const double us = fastest_us(work, arguments.count, arguments.rounds);
    return rows.emplace_back(RobotRow{toccata_in(variant), task, arguments.count, us});
  };
  RobotRow& row = add("batch", robot_tasks[0], [&] { meets = scene.meets_each(from, one_thread); });
  const std::vector<std::uint8_t> truth = meets_by_pairs(scene, from);
  row.found = count_of_ones(meets);
  row.disagreements = count_of_others(truth, meets);
  RobotRow& free_row = add("batch", robot_tasks[1], [&] { free = scene.free_each(from, to); });
  free_row.found = arguments.count - count_of_ones(free);
  RobotRow& edge_row = add("batch", robot_tasks[2], [&] { edges = scene.edge_each(from, to); });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    edge_row.found += edges[i].is_free ? 0U : 1U;
    edge_row.disagreements += edges[i].is_free != (free[i] == 1) ? 1U : 0U;
  }
  RobotRow& distance_row =
      add("batch", robot_tasks[3], [&] { distances = scene.distance_each(from, arguments.near, one_thread); });
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const bool at_0 = distances[i] && distances[i]->distance.upper == 0;
    distance_row.found += at_0 ? 1U : 0U;
    distance_row.disagreements += at_0 != (meets[i] == 1) ? 1U : 0U;
  }
  if (arguments.peers.empty()) return rows;
  for (const auto& library : fcl_robots()) {
    std::vector<std::uint8_t> theirs;
    library->build(scene);
    const double us = fastest_us([&] { theirs = library->meets(from); }, arguments.count, arguments.rounds);
    rows.push_back({library->description(), robot_tasks[0], arguments.count, us, count_of_ones(theirs),
                    count_of_others(truth, theirs)});
  }
  return rows;
}

/// The ratio of a row's time to that of the first row of the same task.
double ratio_to_ours(const RobotRow& row, const std::vector<RobotRow>& rows) {
  const auto ours = std::ranges::find(rows, row.task, &RobotRow::task);
  return row.mean_us / ours->mean_us;
}

}  // namespace

int run_robot(const RobotArguments& arguments) {
  const RobotScene scene(Robot(generated_arm({.subdivisions = arguments.subdivisions})), generated_room());
  const std::vector<RobotRow> rows = robot_rows(scene, arguments);
  if (arguments.json) {
    RobotRows report = report_of("robot", {{"count", arguments.count},
                                           {"subdivisions", arguments.subdivisions},
                                           {"edge", arguments.edge},
                                           {"seed", arguments.seed}});
    report["results"] = RobotRows::array();
    for (const RobotRow& row : rows)
      report["results"].push_back({{"library", row.who.library},
                                   {"variant", row.who.variant},
                                   {"version", row.who.version},
                                   {"task", row.task},
                                   {"count", row.count},
                                   {"mean_us", row.mean_us},
                                   {"per_second", 1e6 / row.mean_us},
                                   {"ratio", ratio_to_ours(row, rows)},
                                   {"found", row.found},
                                   {"disagreements", row.disagreements}});
    fmt::print("{}\n", report.dump(2));
  } else {
    fmt::print("{:<9}{:<26}{:<16}{:>9}{:>11}{:>13}{:>8}{:>9}{:>7}\n", "library", "variant", "task", "count", "mean us",
               "per second", "ratio", "found", "wrong");
    for (const RobotRow& row : rows)
      fmt::print("{:<9}{:<26}{:<16}{:>9}{:>11.2f}{:>13.0f}{:>8.2f}{:>9}{:>7}\n", row.who.library, row.who.variant,
                 row.task, row.count, row.mean_us, 1e6 / row.mean_us, ratio_to_ours(row, rows), row.found,
                 row.disagreements);
  }
  std::size_t wrong = 0;
  for (const RobotRow& row : rows) wrong += row.who.library == "toccata" ? row.disagreements : 0;
  return wrong == 0 ? 0 : 1;
}

}  // namespace toccata::bench
