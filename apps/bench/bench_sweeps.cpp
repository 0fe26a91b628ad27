#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "arguments.hpp"
#include "report.hpp"
#include "sweep_judge.hpp"
#include "sweep_questions.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::bench {
namespace {

using SweepJson = nlohmann::ordered_json;

AnsweredSweeps measured_sweeps(SweepLibrary& library, const SweepWork& work, int rounds) {
  library.prepare(work);
  const std::size_t count = work.questions.size();
  AnsweredSweeps one;
  one.answers.resize(count);
  const auto ask = [&](std::size_t first, auto answers) { library.answer(first, answers); };
  summarise(fastest_of_blocks(std::span(one.answers), work.block, rounds, Clock::thread, ask), one.result);
  one.result.who = library.description();
  one.result.task = work.set;
  one.result.queries = count;
  return one;
}

double difference(const Pose& x, const Pose& y) {
  double greatest = length(x.offset - y.offset);
  for (int i = 0; i < 3; ++i) greatest = std::max(greatest, length(x.linear[i] - y.linear[i]));
  return greatest;
}

/// In so many questions the library has the bodies elsewhere on their way than Toccata.
std::size_t other_ways(SweepLibrary& library, SweepLibrary& ours, const SweepWork& work) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < work.questions.size(); ++i) {
    double off = 0;
    for (const double time : {0.25, 0.5, 0.75, 1.0}) {
      const PosePair theirs = library.poses_at(i, time), own = ours.poses_at(i, time);
      off = std::max({off, difference(theirs.a, own.a), difference(theirs.b, own.b)});
    }
    count += off > 1e-6;
  }
  return count;
}

SweepJson row_of(const AnsweredSweeps& one, std::size_t elsewhere) {
  return {{"library", one.result.who.library},
          {"variant", one.result.who.variant},
          {"set", one.result.task},
          {"queries", one.result.queries},
          {"hits", std::ranges::count(one.answers, true, &SweepAnswer::hit)},
          {"missed", one.missed},
          {"false_alarms", one.false_alarms},
          {"late", one.late},
          {"early", one.early},
          {"undecided", one.undecided},
          {"other_ways", elsewhere},
          {"wrong", one.result.wrong},
          {"median_us", one.result.median_us},
          {"mean_us", one.result.mean_us},
          {"p99_us", one.result.p99_us}};
}

void add_set(const SweepWork& work, const MotionArguments& arguments, SweepJson& report) {
  const SweepOffer offer = sweep_libraries(arguments.peers, work);
  std::vector<AnsweredSweeps> all;
  for (const auto& library : offer.libraries) all.push_back(measured_sweeps(*library, work, arguments.rounds));
  judge(work, all);
  for (std::size_t i = 0; i < all.size(); ++i)
    report["results"].push_back(row_of(all[i], other_ways(*offer.libraries[i], *offer.libraries.front(), work)));
  for (const Unasked& one : offer.unasked)
    report["not_measured"].push_back(
        {{"library", one.who.library}, {"variant", one.who.variant}, {"set", work.set}, {"reason", one.reason}});
}

/// Measures, for the first that moves, `cast_shape` from where it overlaps the other, beside `overlap` there.
SweepJson cast_in_contact(const SweepWork& work, int rounds) {
  const SweepQuestion& question = work.questions.front();
  const auto model_of = [](const auto& shape) { return Model(shape); };
  const Model a = std::visit(model_of, work.pairs[0].a), b = std::visit(model_of, work.pairs[0].b);
  PairQuery at{question.a.start, question.b.start};
  at.pose_b.offset = 0.5 * at.pose_b.offset;
  Workspace workspace;
  const auto fastest = [&](const auto& ask) {
    double least = HUGE_VAL;
    for (int round = 0; round < 10 * rounds; ++round) least = std::min(least, 1e6 * seconds_of(ask, Clock::thread));
    return least;
  };
  bool overlaps = false, met_at_once = false;
  const double overlap_us = fastest([&] { overlaps = overlap(a, b, at, workspace); });
  const double cast_us = fastest([&] {
    const std::optional<ShapeHit> hit = cast_shape(a, {1, 0, 0}, b, at, workspace);
    met_at_once = hit && hit->upper == 0;
  });
  return {{"set", work.set},          {"overlaps", overlaps}, {"met_at_once", met_at_once},
          {"overlap_us", overlap_us}, {"cast_us", cast_us},   {"ratio", cast_us / overlap_us}};
}

/// With what power of the triangles the median of Toccata grows from the first of the rough spheres to the last.
double growth_of(const SweepJson& results, const std::vector<SweepWork>& sets) {
  std::vector<std::pair<double, double>> points;
  for (const SweepWork& work : sets) {
    if (!work.set.starts_with("rough spheres")) continue;
    const auto& mesh = std::get<std::shared_ptr<const TriangleMesh>>(work.pairs.front().a);
    for (const auto& row : results)
      if (row["library"] == "toccata" && row["set"] == work.set)
        points.emplace_back(std::log(mesh->triangle_count()), std::log(row["median_us"].get<double>()));
  }
  if (points.size() < 2) return 0;
  return (points.back().second - points.front().second) / (points.back().first - points.front().first);
}

void print_sweeps(const SweepJson& report) {
  fmt::print("{:<31}{:<9}{:<40}{:>8}{:>6}{:>7}{:>6}{:>6}{:>6}{:>10}{:>6}{:>6}{:>10}{:>10}{:>10}\n", "set", "library",
             "variant", "queries", "hits", "missed", "false", "late", "early", "undecided", "other", "wrong",
             "median us", "mean us", "p99 us");
  for (const auto& row : report["results"]) {
    fmt::print("{:<31}{:<9}{:<40}", row["set"].get<std::string>(), row["library"].get<std::string>(),
               row["variant"].get<std::string>());
    fmt::print("{:>8}{:>6}{:>7}{:>6}{:>6}{:>6}{:>10}{:>6}{:>6}", row["queries"].get<int>(), row["hits"].get<int>(),
               row["missed"].get<int>(), row["false_alarms"].get<int>(), row["late"].get<int>(),
               row["early"].get<int>(), row["undecided"].get<int>(), row["other_ways"].get<int>(),
               row["wrong"].get<int>());
    fmt::print("{:>10.2f}{:>10.2f}{:>10.2f}\n", row["median_us"].get<double>(), row["mean_us"].get<double>(),
               row["p99_us"].get<double>());
  }
  for (const auto& row : report["in_contact"])
    fmt::print("{}: a cast that starts in contact {:.1f} us, overlap there {:.1f} us\n", row["set"].get<std::string>(),
               row["cast_us"].get<double>(), row["overlap_us"].get<double>());
  if (report["growth"] != 0.0)
    fmt::print("the time of two that meet grows as the triangles to the {:.2f}\n", report["growth"].get<double>());
  for (const auto& row : report["not_measured"])
    fmt::print("{}: {} is not measured: {}\n", row["set"].get<std::string>(), row["library"].get<std::string>(),
               row["reason"].get<std::string>());
}

}  // namespace

int run_sweeps(const MotionArguments& arguments) {
  const bool of_meshes = arguments.task == "meshes";
  const std::vector<SweepWork> sets = of_meshes ? sweeps_of_meshes(arguments) : sweeps_of_bodies(arguments);
  SweepJson report = report_of(
      "motion",
      {{"task", arguments.task}, {"seed", arguments.seed}, {"count", arguments.count}, {"rounds", arguments.rounds}});
  for (const char* list : {"results", "in_contact", "not_measured"}) report[list] = SweepJson::array();
  for (const SweepWork& work : sets) {
    add_set(work, arguments, report);
    if (of_meshes) report["in_contact"].push_back(cast_in_contact(work, arguments.rounds));
  }
  report["growth"] = growth_of(report["results"], sets);
  if (arguments.json)
    fmt::print("{}\n", report.dump(2));
  else
    print_sweeps(report);
  std::size_t wrong = 0;
  for (const auto& row : report["results"])
    if (row["library"] == "toccata") wrong += row["wrong"].get<std::size_t>();
  for (const auto& row : report["in_contact"]) wrong += row["overlaps"] != row["met_at_once"];
  return wrong == 0 ? 0 : 1;
}

}  // namespace toccata::bench
