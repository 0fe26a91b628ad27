#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "cost_words.hpp"
#include "option_kinds.hpp"
#include "shape_text.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/report.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct InspectArguments : PosedArguments {
  bool volumes = false;     ///< every bounding volume and hierarchy of meshes, too
  bool partitions = false;  ///< every partition of space over the triangles of meshes, too
  bool faults = false;      ///< where the faults of meshes are, too
  bool hierarchy = false;   ///< the tree of nodes instead of the objects
};

std::string box_text(const Aabb& box) { return point_text(box.lower) + " to " + point_text(box.upper); }

std::string closed_text(const MeshHealth& h) {
  if (h.closed) return h.signed_volume < 0 ? "yes, inside out (the normals point inward)" : "yes: may be a solid";
  return fmt::format("no: {} boundary, {} flipped and {} non-manifold edges; taken as a surface",
                     grouped(h.boundary_edges), grouped(h.flipped_edges), grouped(h.non_manifold_edges));
}

/// How far an open mesh is from closed.
std::string open_text(const InspectedObject& object) {
  if (std::string winding = only_winding_text(*object.health); !winding.empty()) return winding;
  const std::string holes = counted(object.boundaries, "hole or rim", "holes or rims");
  if (!object.closing_gap)
    return fmt::format(
        "{}, and none of the gaps up to a fiftieth of its size closes it (--close): faces are missing, "
        "or it is meant to be a surface",
        holes);
  return fmt::format("{}; gaps of {} in file units closed, it is watertight (--close)", holes,
                     upper_bound_text(*object.closing_gap, 2));
}

/// Only what is there is worth a line.
void add_finding(std::vector<std::vector<std::string>>& rows, std::size_t count, const std::string& name,
                 const std::string& meaning) {
  if (count > 0) rows.push_back({name, fmt::format("{}: {}", grouped(count), meaning)});
}

using Rows = std::vector<std::vector<std::string>>;

void add_mesh_rows(Rows& rows, const InspectedObject& object) {
  const MeshHealth& h = *object.health;
  const Rows described = {
      {"triangles", grouped(h.triangles) + (h.faces == h.triangles ? "" : " of " + counted(h.faces, "face"))},
      {"vertices", fmt::format("{} ({} distinct)", grouped(h.vertices), grouped(h.distinct_vertices))},
      {"parts", grouped(h.components)},
      {"box", box_text({h.lower, h.upper}) + " in file units"},
      {"watertight", closed_text(h)}};
  rows.insert(rows.end(), described.begin(), described.end());
  if (object.boundaries > 0) rows.push_back({"open", open_text(object)});
  if (h.flipped_edges > 0)
    rows.push_back({"winding", fmt::format("inconsistent: {} run through in one direction by both their triangles",
                                           counted(h.flipped_edges, "edge"))});
  if (object.self_intersections.value_or(0) > 0)
    rows.push_back(
        {"self-intersections", fmt::format("{} of triangles meet otherwise than neighbours do (check --self)",
                                           counted(*object.self_intersections, "pair"))});
  if (h.closed) rows.push_back({"volume", fmt::format("{:.6g} in file units cubed", h.signed_volume)});
  add_finding(rows, h.closed ? h.non_manifold_edges : 0, "non-manifold edges", "used by more than two triangles");
  add_finding(rows, h.degenerate_triangles, "degenerate triangles", "without area; kept, and answered exactly");
  add_finding(rows, h.duplicate_triangles, "duplicate faces", "the same three vertices as an earlier one; kept");
  add_finding(rows, h.unused_vertices, "unused vertices", "in no triangle; ignored");
}

std::string place_text(const InspectedObject& object, const std::string& unit) {
  if (!object.refusal.empty()) return printable(object.refusal);
  return object.world_box ? box_text(*object.world_box) + " " + unit : "without end";
}

/// Edges by their two vertices, triangles and vertices by their numbers; at most so many.
std::vector<std::string> elements_of(const MeshFault& fault, std::size_t most) {
  std::vector<std::string> elements;
  for (const auto& [from, to] : fault.edges) {
    if (elements.size() == most) return elements;
    elements.push_back(fmt::format("{}–{}", from, to));
  }
  for (const std::vector<Index>* numbers : {&fault.triangles, &fault.vertices})
    for (const Index number : *numbers) {
      if (elements.size() == most) return elements;
      elements.push_back(fmt::format("{}", number));
    }
  return elements;
}

/// Where faults are: the first few, each by its first few elements.
void add_faults(Rows& rows, const InspectedObject& inspected) {
  constexpr std::size_t shown = 10;
  const std::vector<MeshFault>& faults = inspected.faults;
  for (std::size_t i = 0; i < std::min(shown, faults.size()); ++i) {
    std::string kind = name_of(faults[i].kind), list;
    std::replace(kind.begin(), kind.end(), '_', ' ');
    const std::vector<std::string> elements = elements_of(faults[i], shown);
    for (const std::string& element : elements) list += " " + element;
    rows.push_back({kind, fmt::format("{} together:{}{}", grouped(faults[i].count()), list,
                                      faults[i].count() > elements.size() ? " …" : "")});
  }
  if (faults.size() > shown)
    rows.push_back({"…", counted(faults.size() - shown, "more place") + " (--json lists all)"});
}

Rows rows_of(const InspectedObject& inspected, const SceneObject& object, const std::string& unit) {
  Rows rows = {{"from", printable(object.source)}};
  if (!std::holds_alternative<std::shared_ptr<const TriangleMesh>>(object.shape)) {
    rows.push_back({"shape", shape_text(object.shape)});
    rows.push_back({"taken as", inspected.solid ? "a solid" : "a surface"});
  }
  if (inspected.health) add_mesh_rows(rows, inspected);
  add_faults(rows, inspected);
  if (!inspected.health || !(object.pose == Pose{})) rows.push_back({"in the world", place_text(inspected, unit)});
  return rows;
}

/// What is measured of meshes alone is asked about these too.
void warn_of_other_shapes(LoadedScene& loaded, const std::string& option) {
  for (const SceneObject& object : loaded.scene.objects)
    if (!object.mesh())
      loaded.warnings.push_back(fmt::format("{} is no mesh: {} is about meshes", object.name, option));
}

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

int run_inspect_hierarchy(const InspectArguments& arguments) {
  if (arguments.faults)
    throw Error("--faults is about meshes, and --hierarchy about the tree of nodes: ask one of them");
  const CaseUse use{.asks = "hierarchy", .asks_itself = changes_objects(arguments), .command = "inspect --hierarchy"};
  if (const auto code = answered_case(arguments, use)) return *code;
  require_view(arguments);
  const CheckInput input = read_check_input(arguments);
  (void)answer_to(HierarchyQuestion{}, input, arguments, "walking");
  return 0;
}

int run_inspect(const InspectArguments& arguments) {
  const bool asks_itself = arguments.volumes || arguments.partitions || arguments.faults || changes_objects(arguments);
  if (const auto code = answered_case(arguments, {"inspect", asks_itself})) return *code;
  require_view(arguments);
  CheckInput input = read_check_input(arguments);
  if (arguments.volumes) warn_of_other_shapes(input.loaded, "--volumes");
  if (arguments.partitions) warn_of_other_shapes(input.loaded, "--partitions");
  const InspectQuestion question{arguments.volumes, arguments.partitions, arguments.faults};
  (void)answer_to(question, input, arguments, "measuring");
  return 0;
}

}  // namespace

std::string table_of(const CheckInput& input, const InspectReport& report) {
  std::string text;
  const Scene& scene = input.loaded.scene;
  for (std::size_t i = 0; i < report.objects.size(); ++i) {
    const InspectedObject& inspected = report.objects[i];
    text += printable(scene.objects[i].name) + "\n" + columns(rows_of(inspected, scene.objects[i], scene.unit), 2) +
            (inspected.volumes.empty() ? "" : volume_table(inspected.volumes)) +
            (inspected.partitions.empty() ? "" : partition_table(inspected.partitions));
  }
  return text;
}

Summary summary_of(const InspectReport& report) {
  std::size_t faults = 0;
  for (const InspectedObject& object : report.objects) faults += object.faults.size();
  return {counted(faults, "fault")};
}

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

Subcommand add_inspect(CLI::App& app) {
  const auto arguments = std::make_shared<InspectArguments>();
  CLI::App* inspect = app.add_subcommand("inspect", "what meshes and shapes are: watertight? degenerate? how large?");
  add_input(*inspect, arguments->input, "mesh or scene files");
  add_close(*inspect, arguments->input);
  CLI::Option* volumes =
      inspect->add_flag("--volumes", arguments->volumes,
                        "every bounding volume and hierarchy of each mesh: size, tightness, memory, time to build");
  CLI::Option* partitions = inspect->add_flag(
      "--partitions", arguments->partitions,
      "every partition of space over each mesh: cells, copies, overlap, memory, time to build and ask");
  inspect
      ->add_flag("--hierarchy", arguments->hierarchy,
                 "how good the tree of nodes is as a hierarchy, and what rebalancing it gains")
      ->excludes(volumes)
      ->excludes(partitions);
  inspect->add_flag("--faults", arguments->faults, "where the edges, triangles and vertices are that are out of order");
  add_json(*inspect, arguments->format, "write JSON (docs/reference/inspect-report.md)");
  add_threads(*inspect, arguments->threads, "answer");
  add_pages(*inspect, *arguments);
  add_glb(*inspect, *arguments);
  add_save_case(*inspect, arguments->save_case);
  inspect->footer(
      with_name("Nothing is repaired unless --close says so; everything is counted exactly. Where a mesh intersects "
                "itself is told by `{0} check FILE --self --faces`.\n\nExample:\n  {0} inspect part.stl\n"
                "  {0} inspect machine.glb --hierarchy"));
  return {inspect,
          [arguments] { return arguments->hierarchy ? run_inspect_hierarchy(*arguments) : run_inspect(*arguments); }};
}

}  // namespace toccata::command
