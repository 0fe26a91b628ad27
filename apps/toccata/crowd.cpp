#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "crowd_frames.hpp"
#include "crowd_view.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/version.hpp"
#include "toccata/generate/crowds.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

using Json = nlohmann::ordered_json;

/// A method's way through all frames.
struct Run {
  BroadPhaseMethod method{};
  CrowdFrames frames;
  std::size_t begun = 0;  ///< in all frames together
  std::size_t ended = 0;
  double bytes_per_body = 0;
  std::string reason;

  [[nodiscard]] std::size_t pairs() const { return frames.pairs.back().count; }  ///< in the last frame
};

/// Takes over what moved and finds all pairs. Gives the milliseconds.
double timed_update(BroadPhase& phase, std::span<const Index> moved, const std::vector<Aabb>& boxes) {
  using Clock = std::chrono::steady_clock;
  std::vector<Aabb> to;
  to.reserve(moved.size());
  for (const Index number : moved) to.push_back(boxes[number]);
  const auto start = Clock::now();
  phase.move(moved, to);
  phase.update();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Run run_method(BroadPhaseMethod method, const CrowdArguments& arguments, const Progress& progress, std::size_t done,
               std::size_t total) {
  Crowd crowd(arguments.scene, arguments.count, arguments.seed);
  BroadPhase phase({method, arguments.threads});
  phase.add(crowd.boxes());
  phase.update();
  Run run;
  run.method = method;
  run.frames = run_frames(
      crowd, arguments.frames, [&](std::span<const Index> moved) { return timed_update(phase, moved, crowd.boxes()); },
      [&] {
        const PairChanges changes = phase.changes();
        run.begun += changes.begun.size();
        run.ended += changes.ended.size();
        if (progress) progress(++done, total);
        return digest_of(phase.pairs());
      });
  run.bytes_per_body = static_cast<double>(phase.bytes()) / static_cast<double>(arguments.count);
  run.reason = phase.reason();
  return run;
}

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

/// The methods check each other, frame by frame.
void require_same(const std::vector<Run>& runs) {
  const Run& first = runs.front();
  for (const Run& run : runs) {
    const auto differ = std::mismatch(run.frames.pairs.begin(), run.frames.pairs.end(), first.frames.pairs.begin());
    if (differ.first != run.frames.pairs.end())
      throw Error(fmt::format("{} and {} found different pairs in frame {}: this is a defect of Toccata",
                              name_of(run.method), name_of(first.method), differ.first - run.frames.pairs.begin() + 1));
    if (run.begun != first.begun || run.ended != first.ended)
      throw Error(fmt::format("of {} and {} other pairs began or ended: this is a defect of Toccata",
                              name_of(run.method), name_of(first.method)));
  }
}

Json json_of(const CrowdArguments& arguments, const std::vector<Run>& runs) {
  Json json = {{"schema", "toccata/crowd/1"},  {"version", version},         {"scene", arguments.scene},
               {"count", arguments.count},     {"frames", arguments.frames}, {"seed", arguments.seed},
               {"threads", arguments.threads}, {"methods", Json::array()}};
  for (const Run& run : runs)
    json["methods"].push_back({{"method", name_of(run.method)},
                               {"median_ms", run.frames.median_ms()},
                               {"worst_ms", run.frames.worst_ms()},
                               {"pairs", run.pairs()},
                               {"begun", run.begun},
                               {"ended", run.ended},
                               {"bytes_per_body", run.bytes_per_body},
                               {"reason", run.reason}});
  return json;
}

std::string table_of(const CrowdArguments& arguments, const std::vector<Run>& runs) {
  std::string text =
      fmt::format("{}, {}, {}\n{:<20}{:>13}{:>11}{:>11}{:>10}{:>10}{:>9}\n", counted(arguments.count, "box", "boxes"),
                  arguments.scene, counted(arguments.frames, "frame"), "method", "ms per frame", "worst", "pairs",
                  "begun", "ended", "B/body");
  for (const Run& run : runs)
    text +=
        fmt::format("{:<20}{:>13.3f}{:>11.3f}{:>11}{:>10}{:>10}{:>9.0f}\n", name_of(run.method), run.frames.median_ms(),
                    run.frames.worst_ms(), run.pairs(), run.begun, run.ended, run.bytes_per_body);
  for (const Run& run : runs)
    if (!run.reason.empty()) text += fmt::format("{}: {}\n", name_of(run.method), run.reason);
  return text;
}

}  // namespace

int run_crowd(const CrowdArguments& arguments) {
  const CrowdView view(arguments);
  const std::vector<BroadPhaseMethod> methods =
      arguments.compare ? methods_for(arguments.count) : std::vector{broad_phase_method(arguments.method)};
  std::vector<Run> runs;
  {
    ProgressBar bar("frames");
    const Progress progress = bar.callback();
    for (std::size_t i = 0; i < methods.size(); ++i)
      runs.push_back(
          run_method(methods[i], arguments, progress, i * arguments.frames, methods.size() * arguments.frames));
  }
  require_same(runs);
  const std::string written = view.write();
  print_answer(arguments.format == Format::json ? json_of(arguments, runs).dump(1) + "\n"
                                                : table_of(arguments, runs) + written);
  return 0;
}

}  // namespace toccata::command
