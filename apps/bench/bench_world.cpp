#include <fmt/format.h>

#include <algorithm>

#include "arguments.hpp"
#include "measure.hpp"
#include "pair_lists.hpp"
#include "report.hpp"
#include "toccata/generate/crowds.hpp"
#include "toccata/query/check_all.hpp"
#include "world.hpp"

namespace toccata::bench {
namespace {

using Json = nlohmann::ordered_json;
using Pairs = std::vector<IndexPair>;

struct WorldRow {
  Description who;
  int threads = 1;
  double median_ms = 0;
  double worst_ms = 0;
  std::size_t contacts = 0;  ///< of the last frame
  std::size_t missing = 0;   ///< contacts that it does not tell, over all frames
  std::size_t invented = 0;  ///< what it tells and is none
};

BodyCrowd crowd_of(const WorldArguments& arguments) {
  if (arguments.scene.empty() || arguments.scene == "fly")
    return BodyCrowd(arguments.count, arguments.contact, arguments.seed);
  return BodyCrowd(arguments.scene, arguments.count, arguments.seed);
}

/// The pairs in contact, frame by frame, by `check_all`, which knows nothing of worlds.
std::vector<Pairs> truth_of(const WorldArguments& arguments) {
  BodyCrowd crowd = crowd_of(arguments);
  std::vector<SceneInstance> bodies;
  for (const Shape& shape : crowd.shapes()) bodies.push_back({Model(shape)});
  std::vector<Pairs> truth;
  for (int frame = 0; frame < arguments.frames; ++frame) {
    crowd.step();
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].pose = crowd.poses()[i];
    Pairs& pairs = truth.emplace_back();
    for (const PairAnswer& pair : check_all(bodies).pairs) pairs.push_back({pair.a, pair.b});
  }
  return truth;
}

WorldRow measured(WorldLibrary& library, int threads, const WorldArguments& arguments,
                  const std::vector<Pairs>& truth) {
  BodyCrowd crowd = crowd_of(arguments);
  library.add(crowd.shapes(), crowd.poses());
  library.step(crowd.poses());  // all memory is new the first time
  WorldRow row{library.description(), threads};
  std::vector<double> times;
  for (const Pairs& contacts : truth) {
    crowd.step();
    const Clock clock = threads == 1 ? Clock::thread : Clock::wall;
    times.push_back(1e3 * seconds_of([&] { library.step(crowd.poses()); }, clock));
    Pairs told = library.contacts();
    std::sort(told.begin(), told.end());
    row.contacts = told.size();
    row.missing += count_without(contacts, told);
    row.invented += count_without(told, contacts);
  }
  std::sort(times.begin(), times.end());
  row.median_ms = times[times.size() / 2];
  row.worst_ms = times.back();
  return row;
}

std::vector<WorldRow> rows_of(const WorldArguments& arguments, const std::vector<Pairs>& truth) {
  std::vector<WorldRow> rows;
  for (const int threads : arguments.threads)
    for (const bool manifolds : {false, true})
      rows.push_back(measured(*toccata_world(threads, manifolds), threads, arguments, truth));
  for (const std::string& peer : arguments.peers)
    rows.push_back(measured(*(peer == "fcl" ? fcl_world() : bullet_world()), 1, arguments, truth));
  return rows;
}

Json json_of(const WorldRow& row, const WorldRow& first) {
  return {{"library", row.who.library},
          {"variant", row.who.variant},
          {"version", row.who.version},
          {"threads", row.threads},
          {"median_ms", row.median_ms},
          {"worst_ms", row.worst_ms},
          {"ratio", row.median_ms / first.median_ms},
          {"contacts", row.contacts},
          {"missing", row.missing},
          {"invented", row.invented}};
}

void print_table(const std::vector<WorldRow>& rows) {
  fmt::print("{:<9}{:<26}{:>8}{:>12}{:>12}{:>9}{:>10}{:>9}{:>10}\n", "library", "variant", "threads", "median ms",
             "worst ms", "ratio", "contacts", "missing", "invented");
  for (const WorldRow& row : rows)
    fmt::print("{:<9}{:<26}{:>8}{:>12.3f}{:>12.3f}{:>9.2f}{:>10}{:>9}{:>10}\n", row.who.library, row.who.variant,
               row.threads, row.median_ms, row.worst_ms, row.median_ms / rows.front().median_ms, row.contacts,
               row.missing, row.invented);
  for (const WorldRow& row : rows) fmt::print("  {} {}: {}\n", row.who.library, row.who.version, row.who.flags);
}

}  // namespace

int run_world(const WorldArguments& arguments) {
  const std::vector<Pairs> truth = truth_of(arguments);
  const std::vector<WorldRow> rows = rows_of(arguments, truth);
  if (arguments.json) {
    Json report = report_of("world", {{"scene", arguments.scene.empty() ? "fly" : arguments.scene},
                                      {"count", arguments.count},
                                      {"contact", arguments.contact},
                                      {"frames", arguments.frames},
                                      {"seed", arguments.seed}});
    report["results"] = Json::array();
    for (const WorldRow& row : rows) report["results"].push_back(json_of(row, rows.front()));
    fmt::print("{}\n", report.dump(2));
  } else {
    print_table(rows);
  }
  const auto is_wrong = [](const WorldRow& row) {
    return row.who.library == "toccata" && row.missing + row.invented > 0;
  };
  return std::any_of(rows.begin(), rows.end(), is_wrong) ? 1 : 0;
}

}  // namespace toccata::bench
