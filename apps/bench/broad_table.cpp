#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "broad_race.hpp"
#include "report.hpp"
#include "toccata/broad/broad_phase.hpp"

namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;

/// Something that is asked of the broad phase, and what was measured.
struct Claim {
  std::string what;
  double value;
  double asked;
  double aim;

  [[nodiscard]] std::string_view verdict() const { return value <= aim ? "aim" : value <= asked ? "held" : "missed"; }
};

/// The best mean of a frame of 100,000 boxes that was measured of any library or trial program, on another machine.
struct BestKnown {
  std::string_view scene;
  double milliseconds;
};
constexpr std::array best_known{BestKnown{"uniform", 7.6}, BestKnown{"clustered", 19.3}, BestKnown{"sizes", 9.2},
                                BestKnown{"static", 7.3},  BestKnown{"terrain", 6.2},    BestKnown{"fast", 7.7}};

/// For so many boxes, as if it grew with their number.
double best_known_of(std::string_view scene, std::size_t count) {
  const auto* known =
      std::find_if(best_known.begin(), best_known.end(), [&](const BestKnown& one) { return one.scene == scene; });
  return known == best_known.end() ? 0 : known->milliseconds * static_cast<double>(count) / 100'000;
}

/// What was measured of one scene.
struct SceneRows {
  std::string scene;
  std::vector<BroadRow> ours;   ///< `auto` first
  std::vector<BroadRow> peers;  ///< those that answered
  BroadRow small, large, large_on_two;

  [[nodiscard]] const BroadRow& automatic() const { return ours.front(); }
  [[nodiscard]] const BroadRow& best_single() const {
    return *std::min_element(ours.begin() + 1, ours.end(),
                             [](const BroadRow& a, const BroadRow& b) { return a.median_ms < b.median_ms; });
  }
  /// Null where none answered.
  [[nodiscard]] const BroadRow* best_peer() const {
    const BroadRow* best = nullptr;
    for (const BroadRow& peer : peers)
      if (peer.frames > 0 && (best == nullptr || peer.mean_ms < best->mean_ms)) best = &peer;
    return best;
  }
  [[nodiscard]] double exponent() const { return 0.5 * std::log10(large.median_ms / small.median_ms); }
};

BroadArguments with(BroadArguments arguments, const std::string& scene, std::size_t count, int frames, int threads) {
  arguments.scene = scene;
  arguments.count = std::max<std::size_t>(count, 1);
  arguments.frames = frames;
  arguments.threads = threads;
  return arguments;
}

BroadRow measured_auto(const BroadArguments& arguments, const BroadTruth& truth) {
  return measured(*toccata_broad_libraries({"auto"}, arguments.threads).front(), arguments, truth,
                  std::numeric_limits<double>::infinity());
}

SceneRows measured_scene(const BroadArguments& asked, const std::string& scene) {
  SceneRows rows;
  rows.scene = scene;
  const BroadArguments usual = with(asked, scene, asked.count, asked.frames, 1);
  BroadTruth truth = true_pairs(usual);
  rows.ours.push_back(measured_auto(usual, truth));
  for (const BroadPhaseMethod method : broad_phase_methods())
    if (method != BroadPhaseMethod::automatic && is_sensible(method, usual.count))
      rows.ours.push_back(
          measured(*toccata_broad_libraries({std::string(name_of(method))}, 1).front(), usual, truth, asked.seconds));
  for (auto& peer : peers_asked(usual)) {
    rows.peers.push_back(measured_apart(*peer, usual, truth, asked.seconds));
    peer.reset();
  }
  const BroadArguments small = with(asked, scene, asked.count / 10, 60, 1);
  rows.small = measured_auto(small, true_pairs(small));
  BroadArguments large = with(asked, scene, asked.count * 10, 9, 1);
  truth = true_pairs(large);
  rows.large = measured_auto(large, truth);
  large.threads = 2;
  rows.large_on_two = measured_auto(large, truth);
  return rows;
}

std::vector<Claim> claims_of(const SceneRows& rows, std::size_t count) {
  const BroadRow& automatic = rows.automatic();
  std::vector<Claim> claims;
  if (const BroadRow* peer = rows.best_peer())
    claims.push_back({fmt::format("{} {}: mean ms; the best peer ({}) {:.3g}, {:.3g} times as long", count, rows.scene,
                                  peer->who.library, peer->mean_ms, peer->mean_ms / automatic.mean_ms),
                      automatic.mean_ms, peer->mean_ms / 4, best_known_of(rows.scene, count)});
  if (rows.scene == "uniform")
    claims.push_back({fmt::format("{} uniform, 1 thread: ms", 10 * count), rows.large.median_ms, 150, 80});
  claims.push_back(
      {fmt::format("{} {}, 2 threads: ms by the wall", 10 * count, rows.scene), rows.large_on_two.median_ms, 150, 60});
  claims.push_back({fmt::format("{}: exponent of growth from {} to {}", rows.scene, count / 10, 10 * count),
                    rows.exponent(), 1.25, 1.1});
  if (rows.scene == "static")
    claims.push_back({fmt::format("{} static: ms", count / 10), rows.small.median_ms, 0.4, 0.15});
  for (const auto& [row, boxes] : {std::pair(&rows.small, count / 10), {&automatic, count}, {&rows.large, 10 * count}})
    claims.push_back({fmt::format("{} {}: worst / median frame of {}", boxes, rows.scene, row->frames),
                      row->worst_ms / row->median_ms, 3, 1.5});
  const BroadRow& best = rows.best_single();
  claims.push_back({fmt::format("{}: auto / best single method ({})", rows.scene, best.who.variant),
                    automatic.median_ms / best.median_ms, 1.3, 1.1});
  claims.push_back({fmt::format("{}: bytes a body", rows.scene), automatic.bytes_per_body, 150, 80});
  return claims;
}

void print_scene(const SceneRows& rows) {
  fmt::print("{}\n", rows.scene);
  const auto print = [](const BroadRow& row) {
    if (row.frames == 0) return fmt::print("  {:<8} {:<34} {}\n", row.who.library, row.who.variant, row.reason);
    fmt::print(
        "  {:<8} {:<34} median {:>9.3f} ms, mean {:>9.3f}, worst {:>9.3f} of {:>2} frames, {:>5.0f} B, {} wrong{}{}\n",
        row.who.library, row.who.variant, row.median_ms, row.mean_ms, row.worst_ms, row.frames, row.bytes_per_body,
        row.wrong_frames, row.reason.empty() ? "" : ": ", row.reason);
  };
  for (const BroadRow& row : rows.ours) print(row);
  for (const BroadRow& row : rows.peers) print(row);
  std::fflush(stdout);
}

void print_claims(const std::vector<Claim>& claims) {
  fmt::print("\n| work | measured | asked | aim | |\n|---|---|---|---|---|\n");
  for (const Claim& claim : claims)
    fmt::print("| {} | {:.3g} | ≤ {:.3g} | {:.3g} | {} |\n", claim.what, claim.value, claim.asked, claim.aim,
               claim.verdict());
}

std::size_t wrong_frames(const SceneRows& rows) {
  std::size_t wrong = rows.small.wrong_frames + rows.large.wrong_frames + rows.large_on_two.wrong_frames;
  for (const BroadRow& row : rows.ours) wrong += row.wrong_frames;
  return wrong;
}

}  // namespace

int run_broad_table(const BroadArguments& arguments) {
  std::vector<Claim> claims;
  std::size_t wrong = 0;
  for (const NamedScene& scene : crowd_scenes()) {
    const SceneRows rows = measured_scene(arguments, scene.name);
    wrong += wrong_frames(rows);
    if (!arguments.json) print_scene(rows);
    for (Claim& claim : claims_of(rows, arguments.count)) claims.push_back(std::move(claim));
  }
  if (arguments.json) {
    Json report = report_of("broad", {{"task", "table"}, {"count", arguments.count}, {"frames", arguments.frames}});
    report["claims"] = Json::array();
    for (const Claim& claim : claims)
      report["claims"].push_back({{"what", claim.what},
                                  {"measured", claim.value},
                                  {"asked", claim.asked},
                                  {"aim", claim.aim},
                                  {"verdict", claim.verdict()}});
    report["wrong_frames"] = wrong;
    fmt::print("{}\n", report.dump(2));
  } else {
    print_claims(claims);
    fmt::print("\n{} wrong frames of Toccata's\n", wrong);
  }
  return wrong > 0 ? 1 : 0;
}

}  // namespace toccata::bench
