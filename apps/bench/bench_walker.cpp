#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>

#include "arguments.hpp"
#include "programs.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "temporary_folder.hpp"
#include "toccata/core/error.hpp"
#include "walks.hpp"

/// Between its call and its return valgrind counts; found by this name. Not inlined, for that.
[[gnu::noinline]] toccata::bench::Walked toccata_bench_counted_walk(toccata::bench::Walk walk,
                                                                    toccata::bench::Method method,
                                                                    const toccata::bench::BoxBvh& a,
                                                                    const toccata::bench::BoxBvh& b) {
  return toccata::bench::walked(walk, method, a, b);
}

namespace toccata::bench {
namespace {

struct NamedWalk {
  std::string name;
  Walk walk;
};

const std::vector<NamedWalk> walks{
    {"two trees", Walk::two_trees}, {"a tree with itself", Walk::self}, {"one tree", Walk::one_tree}};

std::string word_of(const NamedWalk& walk, Method method) {
  return walk.name + (method == Method::generic ? ", generic" : ", by hand");
}

struct Trees {
  BoxBvh a;
  BoxBvh b;
};

BoxBvh box_bvh_of(const std::string& file) {
  const auto mesh = single_mesh(file);
  std::vector<Aabb> boxes;
  for (const auto& corner : mesh->triangles())
    boxes.push_back(
        fit_aabb(std::array{mesh->vertices()[corner[0]], mesh->vertices()[corner[1]], mesh->vertices()[corner[2]]}));
  return BoxBvh(std::move(boxes));
}

/// The number behind "summary:" in what callgrind wrote.
std::optional<double> total_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("summary:")) return std::strtod(line.c_str() + 8, nullptr);
  return std::nullopt;
}

/// The instructions of one walk, counted by running this program again under valgrind; nothing without valgrind.
std::optional<double> instructions_of(const WalkerArguments& arguments, const std::string& walk) {
  const TemporaryFolder folder;
  const std::filesystem::path counts = folder.path() / "counts";
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const ProcessRun run =
      run_program({"valgrind", "--quiet", "--tool=callgrind", "--toggle-collect=toccata_bench_counted_walk*",
                   "--callgrind-out-file=" + counts.string(), self, "walker", "--mesh-a", arguments.mesh_a, "--mesh-b",
                   arguments.mesh_b, "--only", walk});
  return run.exit_code == 0 ? total_of(counts) : std::nullopt;
}

struct MeasuredSide {
  double median_us = 0;
  std::optional<double> instructions;
};

struct Comparison {
  std::string walk;
  WalkCounts counts;
  MeasuredSide generic;
  MeasuredSide by_hand;
  bool same = false;

  std::optional<double> instruction_ratio() const {
    if (!generic.instructions || !by_hand.instructions) return std::nullopt;
    return *generic.instructions / *by_hand.instructions;
  }
};

Comparison compared(const NamedWalk& walk, const WalkerArguments& arguments, const Trees& trees) {
  std::array<std::vector<double>, 2> times;
  std::array<Walked, 2> answers;
  for (int round = 0; round < arguments.rounds; ++round)
    for (const Method method : {Method::generic, Method::by_hand}) {
      const auto i = static_cast<std::size_t>(method);
      times[i].push_back(
          1e6 * seconds_of([&] { answers[i] = toccata_bench_counted_walk(walk.walk, method, trees.a, trees.b); }));
    }
  std::array<MeasuredSide, 2> sides;
  for (const Method method : {Method::generic, Method::by_hand}) {
    const auto i = static_cast<std::size_t>(method);
    std::nth_element(times[i].begin(), times[i].begin() + arguments.rounds / 2, times[i].end());
    sides[i] = {times[i][static_cast<std::size_t>(arguments.rounds / 2)],
                instructions_of(arguments, word_of(walk, method))};
  }
  return {walk.name, answers[0].counts, sides[0], sides[1], answers[0] == answers[1]};
}

nlohmann::ordered_json number_or_null(const std::optional<double>& number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json json_of(const Comparison& c) {
  return {{"library", "toccata"},
          {"variant", c.walk},
          {"task", "walker"},
          {"volume_tests", c.counts.volume_tests},
          {"items", c.counts.items},
          {"generic_instructions", number_or_null(c.generic.instructions)},
          {"by_hand_instructions", number_or_null(c.by_hand.instructions)},
          {"instruction_ratio", number_or_null(c.instruction_ratio())},
          {"generic_median_us", c.generic.median_us},
          {"by_hand_median_us", c.by_hand.median_us},
          {"time_ratio", c.generic.median_us / c.by_hand.median_us},
          {"same", c.same}};
}

void print_table(const std::vector<Comparison>& comparisons) {
  fmt::print("{:<20}{:>14}{:>12}{:>16}{:>16}{:>8}{:>12}{:>12}{:>8}  {}\n", "walk", "volume tests", "items",
             "generic instr.", "by hand instr.", "ratio", "generic us", "by hand us", "ratio", "same answers");
  const auto number = [](const std::optional<double>& value, int digits) {
    return value ? fmt::format("{:.{}f}", *value, digits) : std::string("-");
  };
  for (const Comparison& c : comparisons)
    fmt::print("{:<20}{:>14}{:>12}{:>16}{:>16}{:>8}{:>12.1f}{:>12.1f}{:>8.2f}  {}\n", c.walk, c.counts.volume_tests,
               c.counts.items, number(c.generic.instructions, 0), number(c.by_hand.instructions, 0),
               number(c.instruction_ratio(), 3), c.generic.median_us, c.by_hand.median_us,
               c.generic.median_us / c.by_hand.median_us, c.same ? "yes" : "NO");
  if (!comparisons[0].generic.instructions)
    fmt::print(
        "instructions are counted by valgrind, which is not there; `./toccata bench --with-peers` installs it\n");
}

void walk_once(const std::string& word, const Trees& trees) {
  for (const NamedWalk& walk : walks)
    for (const Method method : {Method::generic, Method::by_hand})
      if (word_of(walk, method) == word) {
        fmt::print("{}\n", toccata_bench_counted_walk(walk.walk, method, trees.a, trees.b).found.size());
        return;
      }
  throw Error(fmt::format("there is no walk '{}'", word));
}

}  // namespace

int run_walker(const WalkerArguments& arguments) {
  const Trees trees{box_bvh_of(arguments.mesh_a), box_bvh_of(arguments.mesh_b)};
  if (!arguments.only.empty()) {
    walk_once(arguments.only, trees);
    return 0;
  }
  std::vector<Comparison> comparisons;
  for (const NamedWalk& walk : walks) comparisons.push_back(compared(walk, arguments, trees));
  const bool same = std::all_of(comparisons.begin(), comparisons.end(), [](const auto& c) { return c.same; });
  if (!arguments.json) {
    print_table(comparisons);
    return same ? 0 : 1;
  }
  auto report = report_of("walker", {{"mesh_a", arguments.mesh_a}, {"mesh_b", arguments.mesh_b}});
  for (const char* list : {"results", "ratios"}) report[list] = nlohmann::ordered_json::array();
  for (const Comparison& comparison : comparisons) report["results"].push_back(json_of(comparison));
  fmt::print("{}\n", report.dump(2));
  return same ? 0 : 1;
}

}  // namespace toccata::bench
