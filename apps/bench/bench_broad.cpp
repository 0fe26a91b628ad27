#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "arguments.hpp"
#include "broad.hpp"
#include "crowd_frames.hpp"
#include "report.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;

struct Row {
  Description who;
  int threads = 1;
  double median_ms = 0;
  double worst_ms = 0;
  std::size_t pairs = 0;  ///< of the last frame
  double bytes_per_body = 0;
  std::size_t missing = 0;  ///< frames in which a pair is missing, or, of Toccata, one is too many
  std::string reason;
};

/// Many peers let boxes nearly touch: what they found is cleaned as their users would.
std::vector<IndexPair> cleaned(std::vector<IndexPair> pairs, std::span<const Aabb> boxes) {
  std::erase_if(pairs, [&](const IndexPair& pair) { return !overlap(boxes[pair.first], boxes[pair.second]); });
  return pairs;
}

/// The crowd with coordinates that are sums of few bits, so that a centre and a size tell them exactly too.
class PlainCrowd {
 public:
  explicit PlainCrowd(const BroadArguments& arguments) : crowd_(arguments.scene, arguments.count, arguments.seed) {
    for (const Aabb& box : crowd_.boxes()) boxes_.push_back(plain(box));
  }
  std::span<const Index> step() {
    const std::span<const Index> moved = crowd_.step();
    for (const Index number : moved) boxes_[number] = plain(crowd_.boxes()[number]);
    return moved;
  }
  [[nodiscard]] const std::vector<Aabb>& boxes() const { return boxes_; }

 private:
  static double plain(double value) { return std::round(value * 0x1p20) * 0x1p-20; }
  static Aabb plain(const Aabb& box) {
    return {{plain(box.lower.x), plain(box.lower.y), plain(box.lower.z)},
            {plain(box.upper.x), plain(box.upper.y), plain(box.upper.z)}};
  }
  Crowd crowd_;
  std::vector<Aabb> boxes_;
};

/// Of each frame, by a method that looks at all pairs while they are few enough.
std::vector<PairDigest> truth_of(const BroadArguments& arguments) {
  const auto method = arguments.count <= 20'000 ? BroadPhaseMethod::brute_force : BroadPhaseMethod::morton_tree;
  PlainCrowd crowd(arguments);
  const auto not_measured = [](std::span<const Index>) { return 0.0; };
  return run_frames(crowd, static_cast<std::size_t>(arguments.frames), not_measured,
                    [&] {
                      return digest_of(overlapping_pairs(crowd.boxes(), {method, 0}));
                    })
      .pairs;
}

Row measured(BroadLibrary& library, const BroadArguments& arguments, const std::vector<PairDigest>& truth) {
  PlainCrowd crowd(arguments);
  library.add(crowd.boxes());
  // All memory is new the first time; nothing moves.
  library.step({}, crowd.boxes());
  Row row;
  row.who = library.description();
  const bool is_peer = row.who.library != "toccata";
  // Peers use one thread.
  const Clock clock = arguments.threads == 1 || is_peer ? Clock::thread : Clock::wall;
  const CrowdFrames run = run_frames(
      crowd, truth.size(),
      [&](std::span<const Index> moved) {
        return 1e3 * seconds_of([&] { library.step(moved, crowd.boxes()); }, clock);
      },
      [&] { return digest_of(is_peer ? cleaned(library.pairs(), crowd.boxes()) : library.pairs()); });
  for (std::size_t frame = 0; frame < truth.size(); ++frame)
    if (run.pairs[frame] != truth[frame]) ++row.missing;
  row.pairs = run.pairs.back().count;
  row.median_ms = run.median_ms();
  row.worst_ms = run.worst_ms();
  row.bytes_per_body = static_cast<double>(library.bytes()) / static_cast<double>(arguments.count);
  row.reason = library.reason();
  return row;
}

BroadLibraries libraries_asked(const BroadArguments& arguments) {
  BroadLibraries libraries = toccata_broad_libraries(arguments.methods, arguments.threads);
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

Json json_of(const Row& row, const Row& first) {
  return {{"library", row.who.library},
          {"variant", row.who.variant},
          {"version", row.who.version},
          {"threads", row.threads},
          {"median_ms", row.median_ms},
          {"worst_ms", row.worst_ms},
          {"ratio", row.median_ms / first.median_ms},
          {"pairs", row.pairs},
          {"bytes_per_body", row.bytes_per_body},
          {"wrong_frames", row.missing},
          {"reason", row.reason}};
}

void print_table(const std::vector<Row>& rows) {
  fmt::print("{:<9}{:<25}{:>8}{:>12}{:>12}{:>8}{:>9}{:>11}{:>9}{:>13}\n", "library", "variant", "threads", "median ms",
             "worst ms", "worst/m", "ratio", "pairs", "B/body", "wrong frames");
  for (const Row& row : rows)
    fmt::print("{:<9}{:<25}{:>8}{:>12.3f}{:>12.3f}{:>8.2f}{:>9.2f}{:>11}{:>9.0f}{:>13}\n", row.who.library,
               row.who.variant, row.threads, row.median_ms, row.worst_ms, row.worst_ms / row.median_ms,
               row.median_ms / rows.front().median_ms, row.pairs, row.bytes_per_body, row.missing);
  for (const Row& row : rows)
    if (!row.reason.empty()) fmt::print("  {} {}: {}\n", row.who.library, row.who.variant, row.reason);
  for (const Row& row : rows) fmt::print("  {} {}: {}\n", row.who.library, row.who.version, row.who.flags);
}

}  // namespace

int run_broad(const BroadArguments& arguments) {
  const std::vector<PairDigest> truth = truth_of(arguments);
  BroadLibraries libraries = libraries_asked(arguments);
  std::vector<Row> rows;
  for (auto& library : libraries) {
    rows.push_back(measured(*library, arguments, truth));
    if (rows.back().who.library == "toccata") rows.back().threads = arguments.threads;
    library.reset();
  }
  if (arguments.json) {
    Json report = report_of("broad", {{"scene", arguments.scene},
                                      {"count", arguments.count},
                                      {"frames", arguments.frames},
                                      {"seed", arguments.seed}});
    report["results"] = Json::array();
    for (const Row& row : rows) report["results"].push_back(json_of(row, rows.front()));
    fmt::print("{}\n", report.dump(2));
  } else {
    print_table(rows);
  }
  return std::any_of(rows.begin(), rows.end(),
                     [](const Row& row) { return row.who.library == "toccata" && row.missing > 0; })
             ? 1
             : 0;
}

}  // namespace toccata::bench
