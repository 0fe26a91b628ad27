#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "arguments.hpp"
#include "broad.hpp"
#include "report.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/random.hpp"
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

/// Pairs of boxes that overlap, in one number; it does not depend on their order.
struct Digest {
  std::size_t count = 0;
  std::uint64_t sum = 0;
  friend bool operator==(const Digest&, const Digest&) = default;
};

Digest digest_of(std::span<const IndexPair> pairs) {
  Digest digest;
  for (const IndexPair& pair : pairs) {
    Random mix(std::uint64_t{pair.first} << 32 | pair.second);
    digest.sum += mix.bits();
    ++digest.count;
  }
  return digest;
}

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
std::vector<Digest> truth_of(const BroadArguments& arguments) {
  const auto method = arguments.count <= 20'000 ? BroadPhaseMethod::brute_force : BroadPhaseMethod::morton_tree;
  PlainCrowd crowd(arguments);
  std::vector<Digest> truth;
  for (int frame = 0; frame < arguments.frames; ++frame) {
    crowd.step();
    truth.push_back(digest_of(overlapping_pairs(crowd.boxes(), {method, 0})));
  }
  return truth;
}

Row measured(BroadLibrary& library, const BroadArguments& arguments, const std::vector<Digest>& truth) {
  PlainCrowd crowd(arguments);
  library.add(crowd.boxes());
  // All memory is new the first time; nothing moves.
  library.step({}, crowd.boxes());
  Row row;
  row.who = library.description();
  // Peers use one thread.
  const Clock clock = arguments.threads == 1 || row.who.library != "toccata" ? Clock::thread : Clock::wall;
  std::vector<double> times;
  for (int frame = 0; frame < arguments.frames; ++frame) {
    const std::span<const Index> moved = crowd.step();
    times.push_back(1e3 * seconds_of([&] { library.step(moved, crowd.boxes()); }, clock));
    std::vector<IndexPair> pairs = library.pairs();
    if (row.who.library != "toccata") pairs = cleaned(std::move(pairs), crowd.boxes());
    const Digest digest = digest_of(pairs);
    if (digest != truth[static_cast<std::size_t>(frame)]) ++row.missing;
    row.pairs = digest.count;
  }
  std::sort(times.begin(), times.end());
  row.median_ms = times[times.size() / 2];
  row.worst_ms = times.back();
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
  const std::vector<Digest> truth = truth_of(arguments);
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
