#include <fmt/format.h>

#include <algorithm>

#include "answer.hpp"
#include "arguments.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/report.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string share_text(std::size_t part, std::size_t whole) {
  return fmt::format("{} of {}", grouped(part), grouped(whole));
}

std::vector<std::string> row_of(const std::string& name, const HierarchyReport& report) {
  return {name,
          grouped(report.nodes),
          fmt::format("{}", report.levels.empty() ? 0 : report.levels.size() - 1),
          fmt::format("{:.1f}", report.mean_depth),
          grouped(report.most_children),
          share_text(report.overlapping_sibling_pairs, report.sibling_pairs),
          grouped(report.counts.volume_tests),
          grouped(report.counts.items),
          fmt::format("{:.0f}", report.cost())};
}

std::string level_table(const HierarchyReport& report) {
  Rows rows = {{"level", "nodes", "leaves", "most children", "siblings that overlap"}};
  // A chain has a level for each object.
  constexpr std::size_t most_shown = 20;
  for (std::size_t depth = 0; depth < std::min(report.levels.size(), most_shown); ++depth) {
    const HierarchyLevel& level = report.levels[depth];
    rows.push_back({fmt::format("{}", depth), grouped(level.nodes), grouped(level.leaves), grouped(level.most_children),
                    share_text(level.overlapping_sibling_pairs, level.sibling_pairs)});
  }
  std::string text = columns(rows, 2);
  if (report.levels.size() > most_shown)
    text += fmt::format("  and {} (--json lists all)\n", counted(report.levels.size() - most_shown, "more level"));
  return text;
}

double gain(const HierarchyReport& from, const HierarchyReport& to) {
  return to.cost() > 0 ? from.cost() / to.cost() : 1;
}

}  // namespace

std::string table_of(const CheckInput&, const RebalanceReport& report) {
  const Rows rows = {{"", "nodes", "depth", "mean", "most children", "siblings that overlap", "N_bv", "N_p", "F"},
                     row_of("as it is", report.as_is),
                     row_of("cured", report.cured),
                     row_of("rebuilt", report.rebuilt)};
  std::string text = "The scene's nodes as a hierarchy over " + counted(report.as_is.leaves, "object") + "\n" +
                     level_table(report.as_is) + "Finding all pairs of overlapping boxes by it, and by better ones\n" +
                     columns(rows, 2);
  text += fmt::format("Cured {:.2f} times cheaper, with {} of {} named nodes kept; rebuilt {:.2f} times.\n",
                      gain(report.as_is, report.cured), grouped(report.kept_nodes), grouped(report.named_nodes),
                      gain(report.as_is, report.rebuilt));
  if (report.unbounded > 0) text += fmt::format("{} without end left out.\n", counted(report.unbounded, "object"));
  return text;
}

Summary summary_of(const RebalanceReport& report) {
  return {counted(report.as_is.levels.size(), "level") + " of nodes"};
}

int run_inspect_hierarchy(const InspectArguments& arguments) {
  if (arguments.faults)
    throw Error("--faults is about meshes, and --hierarchy about the tree of nodes: ask one of them");
  if (const auto code = answered_case(arguments, {"hierarchy", changes_objects(arguments)})) return *code;
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  (void)answer_to(HierarchyQuestion{}, input, arguments, "walking");
  return 0;
}

}  // namespace toccata::command
