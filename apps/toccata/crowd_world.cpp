// `crowd --world`: bodies of many shapes in a World, step by step.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "arguments.hpp"
#include "crowd_view.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/version.hpp"
#include "toccata/generate/body_crowd.hpp"
#include "toccata/io/world_page.hpp"
#include "toccata/world/world.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

using Json = nlohmann::ordered_json;

struct WorldRun {
  std::vector<double> ms;  ///< of each step
  std::size_t begun = 0;   ///< in all steps together
  std::size_t ended = 0;
  std::size_t pairs = 0;  ///< in the last step
  BroadPhaseMethod method{};

  [[nodiscard]] double median_ms() const {
    std::vector<double> sorted = ms;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
  [[nodiscard]] double worst_ms() const { return *std::max_element(ms.begin(), ms.end()); }
};

std::vector<Body> bodies_of(const BodyCrowd& crowd) {
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < crowd.shapes().size(); ++i)
    bodies.push_back({Model(crowd.shapes()[i]), crowd.poses()[i]});
  return bodies;
}

/// Step 0 is that before anything moves; it is not timed.
WorldRun run_world(const CrowdArguments& arguments, WorldRecording* recording) {
  using Clock = std::chrono::steady_clock;
  ProgressBar bar("steps");
  const Progress progress = bar.callback();
  BodyCrowd crowd(arguments.count, 0.05, arguments.seed);
  World world({.relation = recording != nullptr,
               .manifold = recording != nullptr,
               .penetration = recording != nullptr,
               .broad_phase = broad_phase_method(arguments.method),
               .threads = arguments.threads});
  const std::vector<BodyId> ids = world.add(bodies_of(crowd));
  world.step();
  if (recording != nullptr) recording->add(world);
  WorldRun run;
  for (std::size_t frame = 0; frame < arguments.frames; ++frame) {
    crowd.step();
    const auto start = Clock::now();
    world.move(ids, crowd.poses());
    const WorldStep& step = world.step();
    run.ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    run.begun += step.begun.size();
    run.ended += step.ended.size();
    if (recording != nullptr) recording->add(world);
    if (progress) progress(frame + 1, arguments.frames);
  }
  run.pairs = world.pairs().size();
  run.method = world.broad_phase().method();
  return run;
}

Json json_of(const CrowdArguments& arguments, const WorldRun& run) {
  return {{"schema", "toccata/crowd-world/1"},
          {"version", version},
          {"count", arguments.count},
          {"frames", arguments.frames},
          {"seed", arguments.seed},
          {"threads", arguments.threads},
          {"method", name_of(run.method)},
          {"median_ms", run.median_ms()},
          {"worst_ms", run.worst_ms()},
          {"pairs", run.pairs},
          {"begun", run.begun},
          {"ended", run.ended}};
}

std::string title_of(const CrowdArguments& arguments) {
  return counted(arguments.count, "body", "bodies") + (arguments.count == 1 ? " that flies" : " that fly");
}

std::string table_of(const CrowdArguments& arguments, const WorldRun& run) {
  return fmt::format("{}, {}\n{:<20}{:>12}{:>11}{:>11}{:>10}{:>9}\n{:<20}{:>12.3f}{:>11.3f}{:>11}{:>10}{:>9}\n",
                     title_of(arguments), counted(arguments.frames, "frame"), "broad phase", "ms per step", "worst",
                     "in contact", "begun", "ended", name_of(run.method), run.median_ms(), run.worst_ms(), run.pairs,
                     run.begun, run.ended);
}

}  // namespace

int run_crowd_world(const CrowdArguments& arguments) {
  if (!arguments.save_case.empty()) throw Error("--save-case is about boxes: leave it out, or --world");
  const CrowdView view(arguments, {});
  const WorldRun run = run_world(arguments, nullptr);
  std::string written;
  if (view.draws()) {
    WorldRecording recording;
    run_world(arguments, &recording);
    written =
        view.write(world_page(recording, {.title = title_of(arguments)}), counted(recording.frames().size(), "step"));
  }
  print_answer(arguments.format == Format::json ? json_of(arguments, run).dump(1) + "\n"
                                                : table_of(arguments, run) + written);
  return 0;
}

}  // namespace toccata::command
