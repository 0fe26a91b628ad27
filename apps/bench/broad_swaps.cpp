#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "broad_race.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/error.hpp"

// What coherence is worth: how many neighbours an insertion sort of the ends would swap from one frame to the next, and
// what the incremental sweep, which sorts so until it gives up, and the spatial hash, which knows nothing of the frame
// before, take for it.
namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;

/// Pairs in the wrong order; the values are sorted. By merging, so that no number of them takes too long.
double inversions(std::vector<double>& values, std::size_t first, std::size_t last, std::vector<double>& scratch) {
  if (last - first < 2) return 0;
  const std::size_t middle = first + (last - first) / 2;
  double sum = inversions(values, first, middle, scratch) + inversions(values, middle, last, scratch);
  scratch.clear();
  std::size_t left = first, right = middle;
  while (left < middle || right < last) {
    const bool from_right = left == middle || (right < last && values[right] < values[left]);
    if (from_right) sum += static_cast<double>(middle - left);
    scratch.push_back(values[from_right ? right++ : left++]);
  }
  std::copy(scratch.begin(), scratch.end(), values.begin() + static_cast<std::ptrdiff_t>(first));
  return sum;
}

double end_of(const Aabb& box, int axis, std::size_t name) { return (name % 2 == 0 ? box.lower : box.upper)[axis]; }

/// Along all axes, of the ends in the order of one frame that are out of order in the next.
double swaps_between(const std::vector<Aabb>& before, const std::vector<Aabb>& after) {
  std::vector<std::size_t> order(2 * before.size());
  std::vector<double> values(order.size()), scratch;
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
      const double x = end_of(before[i / 2], axis, i), y = end_of(before[j / 2], axis, j);
      return x != y ? x < y : i < j;
    });
    for (std::size_t i = 0; i < order.size(); ++i) values[i] = end_of(after[order[i] / 2], axis, order[i]);
    sum += inversions(values, 0, values.size(), scratch);
  }
  return sum;
}

/// The cost of a frame of one crowd, in the mean.
struct FrameCost {
  double swaps = 0;
  double sweep_ms = 0;
  double hash_ms = 0;
};

double milliseconds_of(BroadPhase& phase, std::span<const Index> moved, const std::vector<Aabb>& boxes) {
  std::vector<Aabb> to;
  for (const Index number : moved) to.push_back(boxes[number]);
  phase.move(moved, to);
  return 1e3 * seconds_of([&] { phase.update(); }, Clock::thread);
}

FrameCost frame_cost(const BroadArguments& arguments) {
  PlainCrowd crowd(arguments);
  BroadPhase sweep({BroadPhaseMethod::incremental_sweep, 1}), hash({BroadPhaseMethod::spatial_hash, 1});
  for (BroadPhase* phase : {&sweep, &hash}) {
    phase->add(crowd.boxes());
    phase->update();
  }
  FrameCost sum;
  for (int frame = 0; frame < arguments.frames; ++frame) {
    const std::vector<Aabb> before = crowd.boxes();
    const std::span<const Index> moved = crowd.step();
    sum.swaps += swaps_between(before, crowd.boxes());
    sum.sweep_ms += milliseconds_of(sweep, moved, crowd.boxes());
    sum.hash_ms += milliseconds_of(hash, moved, crowd.boxes());
    if (sweep.pairs().size() != hash.pairs().size()) throw Error("the incremental sweep and the hash find other pairs");
  }
  const double share = 1.0 / arguments.frames;
  return {share * sum.swaps, share * sum.sweep_ms, share * sum.hash_ms};
}

/// x in n^x, from a quarter of the boxes to all.
double exponent(double of_few, double of_all) { return std::log2(of_all / of_few) / 2; }

}  // namespace

int run_broad_swaps(const BroadArguments& arguments) {
  Json results = Json::array();
  for (const NamedScene& scene : crowd_scenes()) {
    BroadArguments few = arguments;
    few.scene = scene.name;
    BroadArguments all = few;
    few.count = std::max<std::size_t>(1, arguments.count / 4);
    const FrameCost of_few = frame_cost(few), of_all = frame_cost(all);
    results.push_back({{"scene", scene.name},
                       {"swaps_per_box", of_all.swaps / static_cast<double>(arguments.count)},
                       {"swaps_exponent", exponent(of_few.swaps, of_all.swaps)},
                       {"sweep_ms", of_all.sweep_ms},
                       {"sweep_exponent", exponent(of_few.sweep_ms, of_all.sweep_ms)},
                       {"hash_ms", of_all.hash_ms},
                       {"hash_exponent", exponent(of_few.hash_ms, of_all.hash_ms)}});
  }
  if (arguments.json) {
    Json report = report_of("broad", {{"task", "swaps"}, {"count", arguments.count}, {"frames", arguments.frames}});
    report["results"] = std::move(results);
    fmt::print("{}\n", report.dump(2));
    return 0;
  }
  fmt::print("{} boxes, {} frames; exponents of growth from a quarter of the boxes\n\n", arguments.count,
             arguments.frames);
  fmt::print(
      "| scene | swaps a box and frame | exponent | incremental sweep ms | exponent | spatial hash ms | exponent |\n"
      "|---|---|---|---|---|---|---|\n");
  for (const Json& row : results)
    fmt::print("| `{}` | {:.3g} | {:.2f} | {:.3g} | {:.2f} | {:.3g} | {:.2f} |\n", row["scene"].get<std::string>(),
               row["swaps_per_box"].get<double>(), row["swaps_exponent"].get<double>(), row["sweep_ms"].get<double>(),
               row["sweep_exponent"].get<double>(), row["hash_ms"].get<double>(), row["hash_exponent"].get<double>());
  return 0;
}

}  // namespace toccata::bench
