#include <fmt/format.h>

#include <string>
#include <vector>

#include "arguments.hpp"
#include "ask.hpp"
#include "check_input.hpp"
#include "crowd_view.hpp"
#include "saved.hpp"
#include "toccata/broad/broad_phase.hpp"
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

CrowdQuestion question_of(const CrowdArguments& arguments) {
  return {arguments.scene,
          arguments.count,
          arguments.frames,
          arguments.compare ? methods_for(arguments.count) : std::vector{broad_phase_method(arguments.method)},
          arguments.seed,
          arguments.threads};
}

}  // namespace

std::string table_of(const CheckInput&, const CrowdReport& report) {
  const CrowdQuestion& question = report.question;
  std::string text =
      fmt::format("{}, {}, {}\n{:<20}{:>13}{:>11}{:>11}{:>10}{:>10}{:>9}\n", counted(question.count, "box", "boxes"),
                  question.scene, counted(question.frames, "frame"), "method", "ms per frame", "worst", "pairs",
                  "begun", "ended", "B/body");
  for (const CrowdRun& run : report.runs)
    text +=
        fmt::format("{:<20}{:>13.3f}{:>11.3f}{:>11}{:>10}{:>10}{:>9.0f}\n", name_of(run.method), run.frames.median_ms(),
                    run.frames.worst_ms(), run.pairs(), run.begun, run.ended, run.bytes_per_body);
  for (const CrowdRun& run : report.runs)
    if (!run.reason.empty()) text += fmt::format("{}: {}\n", name_of(run.method), run.reason);
  return text;
}

int run_crowd(const CrowdArguments& arguments) {
  const CrowdQuestion question = question_of(arguments);
  const CrowdView view(arguments, question);
  const CheckInput input = about_no_file();
  const SceneAnswer answer = ask_for(input, question, arguments, {"frames"});
  const std::string written = view.write();
  print_answer(input, question, answer, arguments,
               [&](const SceneAnswer& found) { return table_of(input, std::get<CrowdReport>(found)) + written; });
  return 0;
}

}  // namespace toccata::command
