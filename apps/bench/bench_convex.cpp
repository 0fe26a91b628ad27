#include <fmt/format.h>

#include <algorithm>

#include "arguments.hpp"
#include "convex_judge.hpp"
#include "convex_questions.hpp"
#include "report.hpp"
#include "toccata/core/error.hpp"

namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;

ConvexResult measured(ConvexLibrary& library, const ConvexWork& work, int rounds) {
  library.prepare(work);
  ConvexResult result;
  result.bytes_per_vertex = library.bytes_per_vertex();
  result.answers.resize(work.questions.size());
  const auto ask = [&](std::size_t first, auto answers) { library.answer(first, answers); };
  Result in_microseconds;
  summarise(fastest_of_blocks(std::span(result.answers), convex_block, rounds, Clock::wall, ask), in_microseconds);
  result.who = library.description();  // which may tell how much work it was
  result.median_ns = 1e3 * in_microseconds.median_us;
  result.mean_ns = 1e3 * in_microseconds.mean_us;
  result.p99_ns = 1e3 * in_microseconds.p99_us;
  return result;
}

Json json_of(const ConvexResult& r, const std::string& task, std::size_t queries) {
  return {{"library", r.who.library},
          {"variant", r.who.variant},
          {"task", task},
          {"queries", queries},
          {"median_ns", r.median_ns},
          {"mean_ns", r.mean_ns},
          {"p99_ns", r.p99_ns},
          {"bytes_per_vertex", r.bytes_per_vertex},
          {"disagreements", r.disagreements},
          {"wrong", r.wrong},
          {"worst_error", std::isfinite(r.worst_error) ? Json(r.worst_error) : Json(nullptr)}};
}

bool is_best_peer(const ConvexResult& r, const std::vector<ConvexResult>& results) {
  return r.who.library != "toccata" && std::ranges::none_of(results, [&](const ConvexResult& other) {
           return other.who.library != "toccata" && other.mean_ns < r.mean_ns;
         });
}

Json with_results(Json report, const ConvexArguments& arguments, const std::vector<ConvexResult>& results,
                  const std::vector<Unasked>& unasked) {
  for (const char* list : {"libraries", "results", "ratios", "not_measured"}) report[list] = Json::array();
  const ConvexResult& ours = results.front();
  const auto add_library = [&](const Description& who) {
    report["libraries"].push_back(
        {{"library", who.library}, {"variant", who.variant}, {"version", who.version}, {"flags", who.flags}});
  };
  for (const ConvexResult& r : results) {
    add_library(r.who);
    report["results"].push_back(json_of(r, arguments.task, r.answers.size()));
    if (&r == &ours) continue;
    report["ratios"].push_back({{"library", r.who.library},
                                {"variant", r.who.variant},
                                {"task", arguments.task},
                                {"median", r.median_ns / ours.median_ns},
                                {"mean", r.mean_ns / ours.mean_ns},
                                {"p99", r.p99_ns / ours.p99_ns},
                                {"best", is_best_peer(r, results)}});
  }
  for (const Unasked& one : unasked) {
    add_library(one.who);
    report["not_measured"].push_back(
        {{"library", one.who.library}, {"variant", one.who.variant}, {"task", arguments.task}, {"reason", one.reason}});
  }
  return report;
}

void print_table(const ConvexArguments& arguments, const std::vector<ConvexResult>& results,
                 const std::vector<Unasked>& unasked) {
  fmt::print("{:<9}{:<32}{:>11}{:>11}{:>11}{:>9}{:>9}{:>10}{:>8}{:>8}{:>13}\n", "library", "variant", "median ns",
             "mean ns", "p99 ns", "ratio", "(mean)", "B/vertex", "differ", "wrong", "worst error");
  const ConvexResult& ours = results.front();
  for (const ConvexResult& r : results)
    fmt::print("{:<9}{:<32}{:>11.1f}{:>11.1f}{:>11.1f}{:>9.2f}{:>9.2f}{:>10.0f}{:>8}{:>8}{:>13.2g}{}\n", r.who.library,
               r.who.variant, r.median_ns, r.mean_ns, r.p99_ns, r.median_ns / ours.median_ns, r.mean_ns / ours.mean_ns,
               r.bytes_per_vertex, r.disagreements, r.wrong, r.worst_error, is_best_peer(r, results) ? " *" : "");
  for (const Unasked& one : unasked)
    fmt::print("{:<9}{:<32} not measured: {}\n", one.who.library, one.who.variant, one.reason);
  fmt::print("{} questions of {}, {}, {}; ratio: how many times as long as toccata; *: the best peer\n",
             ours.answers.size(), arguments.task, arguments.pair, arguments.regime);
  for (const ConvexResult& r : results)
    fmt::print("  {} {} ({}): {}\n", r.who.library, r.who.version, r.who.variant, r.who.flags);
}

int exit_code_of(const std::vector<ConvexResult>& results) {
  std::size_t wrong = 0;
  for (const ConvexResult& result : results)
    if (result.who.library == "toccata") wrong += result.wrong;
  if (wrong > 0) fmt::print(stderr, "toccata-bench: {} answers of Toccata are wrong\n", wrong);
  return wrong > 0 ? 1 : 0;
}

}  // namespace

int run_convex(const ConvexArguments& arguments) {
  if (arguments.pair == "sphere-triangle" && arguments.task == "penetration")
    throw Error("penetration is defined for two solids, and a triangle is a surface");
  const ConvexWork work = convex_work(arguments);
  const ConvexOffer offer = convex_libraries(arguments.peers, work);
  std::vector<ConvexResult> results;
  for (const auto& library : offer.libraries) results.push_back(measured(*library, work, arguments.rounds));
  judge(work, arguments.verify ? Judged::all : Judged::differing, results);
  const auto overlapping = std::ranges::count(results.front().answers, true, &ConvexAnswer::overlap);
  if (arguments.json) {
    Json report =
        report_of("convex", {{"pair", arguments.pair},
                             {"vertices", arguments.pair == "hull" ? Json(arguments.vertices) : Json(nullptr)},
                             {"regime", arguments.regime},
                             {"gap", arguments.regime == "near" ? Json(arguments.gap) : Json(nullptr)},
                             {"seed", arguments.seed},
                             {"block", convex_block},
                             {"rounds", arguments.rounds},
                             {"overlapping", overlapping}});
    fmt::print("{}\n", with_results(std::move(report), arguments, results, offer.unasked).dump(2));
  } else {
    print_table(arguments, results, offer.unasked);
  }
  return exit_code_of(results);
}

}  // namespace toccata::bench
