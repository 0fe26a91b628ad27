#include "cost_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "toccata/core/error.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

template <class T, std::size_t count>
T value_of(const std::string& word, const std::array<T, count>& all, const char* kind) {
  std::vector<std::string> known;
  for (const T value : all) {
    if (name_of(value) == word) return value;
    known.emplace_back(name_of(value));
  }
  const std::string nearest = nearest_word(word, known);
  throw Error(fmt::format("there is no {} '{}'{} (known: {})", kind, word,
                          nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest), fmt::join(known, ", ")));
}

template <class T, std::size_t count>
void take(std::vector<T>& values, const std::vector<std::string>& words, const std::array<T, count>& all,
          const char* kind) {
  if (words.empty()) return;
  values.clear();
  for (const std::string& word : words) values.push_back(value_of(word, all, kind));
}

template <class T>
bool lacks(const std::vector<T>& named, const T& value) {
  return !named.empty() && std::find(named.begin(), named.end(), value) == named.end();
}

bool is_wide(CostVolume volume) { return volume == CostVolume::wide; }

std::string megabytes(std::size_t bytes) { return fmt::format("{:.3g} MB", static_cast<double>(bytes) / 1e6); }

}  // namespace

CostOptions cost_options_of(const CostWords& words) {
  CostOptions options;
  if (words.quick) {
    options.methods = {BvhMethod::heuristic, BvhMethod::median};
    options.arities = {2, 8};
    options.most_work = 1e6;
  }
  if (words.all) options.most_work = std::numeric_limits<double>::infinity();
  options.task = value_of(words.task, std::array{CostTask::overlap, CostTask::contacts, CostTask::distance}, "task");
  if (options.task == CostTask::distance) options.most_rigid = 2;  // walks are some hundred times as long
  take(options.volumes, words.volumes, all_cost_volumes, "volume");
  take(options.methods, words.builders, all_bvh_methods, "builder");
  take(options.workloads, words.workloads, all_cost_workloads, "workload");
  if (!words.arities.empty()) options.arities = words.arities;
  options.leaf_size = words.leaf_size;
  if (std::all_of(options.volumes.begin(), options.volumes.end(), is_wide) && !remark_on_wide(options).empty())
    throw Error(remark_on_wide(options) + "; leave these out, or name another volume as well");
  return options;
}

std::string remark_on_wide(const CostOptions& options) {
  const bool measured = std::any_of(options.volumes.begin(), options.volumes.end(), is_wide);
  if (!measured || !(lacks(options.methods, BvhMethod::heuristic) || lacks(options.arities, 8))) return "";
  return "wide, the library's own tree, has eight children a node and its own builder, by heuristic, whatever "
         "--arities "
         "and --builders say";
}

std::string meaning_of(CostWorkload workload) {
  switch (workload) {
    case CostWorkload::rigid:
      return "the meshes move as they are, and the volumes that are looked at with them";
    case CostWorkload::refit:
      return "every vertex has moved, and all volumes are put around the triangles again";
    case CostWorkload::rebuild:
      break;
  }
  return "every vertex has moved, and both hierarchies are built anew";
}

std::string volume_table(const std::vector<VolumeCost>& costs) {
  std::vector<std::vector<std::string>> rows{
      {"volume", "arity", "builder", "size", "surface", "filled", "nodes", "depth", "at best", "memory", "build"}};
  for (const VolumeCost& cost : costs)
    rows.push_back({std::string(name_of(cost.volume)), fmt::format("{}", cost.arity), std::string(name_of(cost.method)),
                    fmt::format("{:.4g}", cost.root_volume), fmt::format("{:.4g}", cost.root_surface),
                    fmt::format("{:.0f} %", 100 * cost.fill), grouped(cost.balance.nodes),
                    fmt::format("{} to {}", cost.balance.least_depth, cost.balance.greatest_depth),
                    fmt::format("{}", cost.balance.best_depth), megabytes(cost.bytes),
                    fmt::format("{:.3g} ms", cost.build_ns / 1e6)});
  return columns(rows, 4);
}

std::string partition_table(const std::vector<PartitionCost>& costs) {
  std::vector<std::vector<std::string>> rows{{"partition", "cells", "in each", "at most", "copies", "overlap", "memory",
                                              "build", "box", "candidates", "pairs of all", "candidates"}};
  for (const PartitionCost& cost : costs)
    rows.push_back({std::string(name_of(cost.kind)), grouped(cost.cells), fmt::format("{:.1f}", cost.items_per_cell),
                    grouped(cost.most_in_a_cell), fmt::format("{:.2f}", cost.copies_per_item),
                    fmt::format("{:.2f}", cost.cells_at_an_item), megabytes(cost.bytes),
                    fmt::format("{:.3g} ms", cost.build_ns / 1e6), fmt::format("{:.3g} µs", cost.question_ns / 1e3),
                    fmt::format("{:.1f}", cost.candidates), fmt::format("{:.3g} ms", cost.pairs_ns / 1e6),
                    grouped(cost.candidate_pairs)});
  return columns(rows, 4) + fmt::format("    a box meets {:.1f} triangles on average; {} of triangles meet{}\n",
                                        costs.front().answers, counted(costs.front().pairs, "pair"),
                                        costs.front().pairs == 1 ? "s" : "");
}

}  // namespace toccata::command
