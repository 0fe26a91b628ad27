#include "broad_race.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>

#include "apart.hpp"
#include "measure.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata::bench {
namespace {

using Pairs = std::vector<IndexPair>;

/// Many peers let boxes nearly touch: what they found is cleaned as their users would.
Pairs cleaned(Pairs pairs, std::span<const Aabb> boxes) {
  std::erase_if(pairs, [&](const IndexPair& pair) { return !overlap(boxes[pair.first], boxes[pair.second]); });
  return pairs;
}

double plain(double value) { return std::round(value * 0x1p20) * 0x1p-20; }
Aabb plain(const Aabb& box) {
  return {{plain(box.lower.x), plain(box.lower.y), plain(box.lower.z)},
          {plain(box.upper.x), plain(box.upper.y), plain(box.upper.z)}};
}

/// Which pairs were missing, and whether these boxes have only their sides in common.
std::string words_of_difference(Pairs found, std::span<const Aabb> boxes) {
  const Pairs all = true_pairs_of(boxes, 1);
  std::sort(found.begin(), found.end());
  Pairs missing;
  std::set_difference(all.begin(), all.end(), found.begin(), found.end(), std::back_inserter(missing));
  const auto touches = [&](const IndexPair& pair) {
    const Aabb &a = boxes[pair.first], &b = boxes[pair.second];
    const Vec3 low{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y), std::max(a.lower.z, b.lower.z)};
    const Vec3 high{std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y), std::min(a.upper.z, b.upper.z)};
    return low.x == high.x || low.y == high.y || low.z == high.z;
  };
  return fmt::format("{} pairs missing in a frame, {} of which touch without overlapping further; {} twice or too many",
                     missing.size(), std::count_if(missing.begin(), missing.end(), touches),
                     found.size() + missing.size() - all.size());
}

void summarise(std::vector<double> times, BroadRow& row) {
  row.frames = times.size();
  if (times.empty()) return;
  row.mean_ms = std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
  std::sort(times.begin(), times.end());
  row.median_ms = times[times.size() / 2];
  row.worst_ms = times.back();
}

nlohmann::json json_of(const BroadRow& row) {
  return {row.frames, row.median_ms, row.mean_ms, row.worst_ms, row.pairs, row.wrong_frames, row.reason};
}
BroadRow row_of(const nlohmann::json& json, const Description& who) {
  return {who, 1, json[0], json[1], json[2], json[3], json[4], 0, json[5], json[6]};
}

}  // namespace

PlainCrowd::PlainCrowd(const BroadArguments& arguments) : crowd_(arguments.scene, arguments.count, arguments.seed) {
  for (const Aabb& box : crowd_.boxes()) boxes_.push_back(plain(box));
}

std::span<const Index> PlainCrowd::step() {
  const std::span<const Index> moved = crowd_.step();
  for (const Index number : moved) boxes_[number] = plain(crowd_.boxes()[number]);
  return moved;
}

BroadRow measured(BroadLibrary& library, const BroadArguments& arguments, const BroadTruth& truth, double seconds) {
  PlainCrowd crowd(arguments);
  library.add(crowd.boxes());
  // All memory is new the first time; nothing moves.
  library.step({}, crowd.boxes());
  BroadRow row;
  row.who = library.description();
  const bool is_ours = row.who.library == "toccata";
  row.threads = is_ours ? arguments.threads : 1;
  const Clock clock = row.threads == 1 ? Clock::thread : Clock::wall;
  std::vector<double> times;
  double sum = 0;
  std::size_t bytes = library.bytes();
  for (int frame = 0; frame < arguments.frames && (frame < 2 || sum < 1e3 * seconds); ++frame) {
    const std::span<const Index> moved = crowd.step();
    times.push_back(1e3 * seconds_of([&] { library.step(moved, crowd.boxes()); }, clock));
    sum += times.back();
    Pairs pairs = library.pairs();
    if (!is_ours) pairs = cleaned(std::move(pairs), crowd.boxes());
    const PairDigest digest = digest_of(pairs);
    if (digest != truth.frames[static_cast<std::size_t>(frame)] && row.wrong_frames++ == 0)
      row.reason = words_of_difference(std::move(pairs), crowd.boxes());
    row.pairs = digest.count;
    bytes = std::max(bytes, library.bytes());
  }
  summarise(std::move(times), row);
  row.bytes_per_body = static_cast<double>(bytes) / static_cast<double>(arguments.count);
  if (row.wrong_frames == 0) row.reason = library.reason();
  return row;
}

BroadRow measured_apart(BroadLibrary& library, const BroadArguments& arguments, const BroadTruth& truth,
                        double seconds) {
  const double patience = 20 + 8 * seconds;
  const auto text =
      result_apart([&] { return json_of(measured(library, arguments, truth, seconds)).dump(); }, patience);
  if (text) return row_of(nlohmann::json::parse(*text), library.description());
  BroadRow row;
  row.who = library.description();
  row.reason = fmt::format("no answer: ended after {:g} seconds of the processor, or died", patience);
  return row;
}

BroadLibraries peers_asked(const BroadArguments& arguments) {
  BroadLibraries libraries;
  const auto take = [&](BroadLibraries more) {
    for (auto& library : more) libraries.push_back(std::move(library));
  };
  const PlainCrowd crowd(arguments);
  for (const std::string& peer : arguments.peers) {
    if (peer == "bullet") take(bullet_broad_libraries(crowd.boxes()));
    if (peer == "fcl") take(fcl_broad_libraries());
    if (peer == "cgal") take(cgal_broad_libraries());
    if (peer == "ode") take(ode_broad_libraries());
  }
  return libraries;
}

bool is_sensible(BroadPhaseMethod method, std::size_t count) {
  switch (method) {
    case BroadPhaseMethod::interval_sweeps:
    case BroadPhaseMethod::rectangle_sweeps:
      return count <= 10'000;
    case BroadPhaseMethod::brute_force:
      return count <= 20'000;
    case BroadPhaseMethod::incremental_sweep:
      return count <= 50'000;
    case BroadPhaseMethod::sort_and_sweep:
      return count <= 200'000;
    default:
      return true;
  }
}

}  // namespace toccata::bench
