#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "crowd_view.hpp"
#include "saved.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/crowd_report.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// Those that go through so many boxes in bearable time.
std::vector<BroadPhaseMethod> methods_for(std::size_t count) {
  std::vector<BroadPhaseMethod> methods;
  for (const BroadPhaseMethod method : broad_phase_methods()) {
    const bool is_for_few = method == BroadPhaseMethod::interval_sweeps || method == BroadPhaseMethod::rectangle_sweeps;
    if (is_for_few && count > 10'000) continue;
    if (method == BroadPhaseMethod::brute_force && count > 20'000) continue;
    if (method == BroadPhaseMethod::sort_and_sweep && count > 300'000) continue;
    methods.push_back(method);
  }
  return methods;
}

/// `arguments.bounds` is one of their names.
CrowdBounds bounds_of(const CrowdArguments& arguments) {
  const auto is_named = [&](CrowdBounds bounds) { return name_of(bounds) == arguments.bounds; };
  return *std::find_if(all_crowd_bounds.begin(), all_crowd_bounds.end(), is_named);
}

SceneQuestion question_of(const CrowdArguments& arguments) {
  if (arguments.world)
    return CrowdWorldQuestion{arguments.count, arguments.frames, broad_phase_method(arguments.method), arguments.seed,
                              arguments.threads};
  return CrowdQuestion{
      arguments.scene,
      arguments.count,
      arguments.frames,
      arguments.compare ? methods_for(arguments.count) : std::vector{broad_phase_method(arguments.method)},
      arguments.seed,
      arguments.threads,
      bounds_of(arguments)};
}

/// All that is asked is in the case.
int run_case(const CrowdArguments& arguments) {
  const CaseUse use{.asks = "crowd", .needs_options = true};
  if (const auto code = answered_case(arguments, use)) return *code;
  throw Error(
      fmt::format("{} is no case of a crowd: crowds are made from a seed, and no other file is read. Leave it out",
                  arguments.input.files.front()));
}

}  // namespace

std::string crowd_words(const CrowdQuestion& question) {
  if (question.bounds == CrowdBounds::balls) return counted(question.count, "ball");
  if (question.bounds == CrowdBounds::oriented) return counted(question.count, "oriented box", "oriented boxes");
  return counted(question.count, "box", "boxes");
}

std::string crowd_words(const CrowdWorldQuestion& question) {
  return counted(question.count, "body", "bodies") + (question.count == 1 ? " that flies" : " that fly");
}

std::string table_of(const CheckInput&, const CrowdReport& report) {
  const CrowdQuestion& question = report.question;
  std::string text = fmt::format("{}, {}, {}\n{:<20}{:>13}{:>11}{:>11}{:>10}{:>10}{:>9}\n", crowd_words(question),
                                 question.scene, counted(question.frames, "frame"), "method", "ms per frame", "worst",
                                 "pairs", "begin", "end", "B/body");
  for (const CrowdRun& run : report.runs)
    text +=
        fmt::format("{:<20}{:>13.3f}{:>11.3f}{:>11}{:>10}{:>10}{:>9.0f}\n", name_of(run.method), run.frames.median_ms(),
                    run.frames.worst_ms(), run.pairs(), run.begin, run.end, run.bytes_per_body);
  for (const CrowdRun& run : report.runs)
    if (!run.reason.empty()) text += fmt::format("{}: {}\n", name_of(run.method), run.reason);
  return text;
}

std::string table_of(const CheckInput&, const CrowdWorldReport& report) {
  const CrowdWorldQuestion& question = report.question;
  return fmt::format("{}, {}\n{:<20}{:>12}{:>11}{:>11}{:>10}{:>9}\n{:<20}{:>12.3f}{:>11.3f}{:>11}{:>10}{:>9}\n",
                     crowd_words(question), counted(question.frames, "frame"), "broad phase", "ms per step", "worst",
                     "in contact", "begin", "end", name_of(report.used), report.frames.median_ms(),
                     report.frames.worst_ms(), report.pairs(), report.begin, report.end);
}

int run_crowd(const CrowdArguments& arguments) {
  if (!arguments.input.files.empty()) return run_case(arguments);
  const SceneQuestion question = question_of(arguments);
  const CrowdView view(arguments, question);
  const CheckInput input = about_no_file();
  const SceneAnswer answer = ask_for(input, question, arguments, {arguments.world ? "steps" : "frames"});
  const std::string written = view.write();
  print_answer(input, question, answer, arguments, [&](const SceneAnswer& found) {
    return std::visit([&](const auto& report) { return table_of(input, report); }, found) + written;
  });
  return 0;
}

}  // namespace toccata::command
