#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "broad_race.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array sides{0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 6.0, 8.0};

/// Milliseconds of the processor for a frame, the median.
double measured(const BroadArguments& arguments, double side) {
  PlainCrowd crowd(arguments);
  BroadPhase phase({BroadPhaseMethod::spatial_hash, 1, side});
  phase.add(crowd.boxes());
  phase.update();
  std::vector<double> times;
  for (int frame = 0; frame < arguments.frames; ++frame) {
    const std::span<const Index> moved = crowd.step();
    std::vector<Aabb> to;
    for (const Index number : moved) to.push_back(crowd.boxes()[number]);
    phase.move(moved, to);
    times.push_back(1e3 * seconds_of([&] { phase.update(); }, Clock::thread));
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

}  // namespace

int run_broad_cell_size(const BroadArguments& arguments) {
  Json results = Json::array();
  for (const NamedScene& scene : crowd_scenes())
    for (const double side : sides) {
      BroadArguments of_scene = arguments;
      of_scene.scene = scene.name;
      results.push_back({{"scene", scene.name}, {"side", side}, {"median_ms", measured(of_scene, side)}});
    }
  if (arguments.json) {
    Json report = report_of("broad", {{"task", "cell-size"}, {"count", arguments.count}, {"frames", arguments.frames}});
    report["results"] = std::move(results);
    fmt::print("{}\n", report.dump(2));
    return 0;
  }
  fmt::print("the spatial hash, {} boxes, ms a frame, by the side of its cells in usual boxes\n\n| scene |",
             arguments.count);
  for (const double side : sides) fmt::print(" {} |", side);
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (i % sides.size() == 0) fmt::print("\n| {} |", results[i]["scene"].get<std::string>());
    fmt::print(" {:.1f} |", results[i]["median_ms"].get<double>());
  }
  fmt::print("\n");
  return 0;
}

}  // namespace toccata::bench
