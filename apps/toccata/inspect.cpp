#include <fmt/format.h>

#include "arguments.hpp"
#include "cost_words.hpp"
#include "load.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "shape_text.hpp"
#include "toccata/io/inspect_report.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

std::string box_text(const Aabb& box) { return point_text(box.lower) + " to " + point_text(box.upper); }

std::string closed_text(const MeshHealth& h) {
  if (h.closed) return h.signed_volume < 0 ? "yes, inside out (the normals point inward)" : "yes: may be a solid";
  return fmt::format("no: {} ({} boundary, {} flipped, {} non-manifold); taken as a surface",
                     counted(h.unbalanced_edges, "unbalanced edge"), grouped(h.boundary_edges),
                     grouped(h.flipped_edges), grouped(h.non_manifold_edges));
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
      {"closed", closed_text(h)}};
  rows.insert(rows.end(), described.begin(), described.end());
  if (h.closed) rows.push_back({"volume", fmt::format("{:.6g} in file units cubed", h.signed_volume)});
  add_finding(rows, h.closed ? h.non_manifold_edges : 0, "non-manifold edges", "used by more than two triangles");
  add_finding(rows, h.degenerate_triangles, "degenerate triangles", "without area; kept, and answered exactly");
  add_finding(rows, h.duplicate_triangles, "duplicate triangles", "the same three vertices as an earlier one; kept");
  add_finding(rows, h.unused_vertices, "unused vertices", "in no triangle; ignored");
}

std::string place_text(const InspectedObject& object, const std::string& unit) {
  if (!object.refusal.empty()) return printable(object.refusal);
  return object.world_box ? box_text(*object.world_box) + " " + unit : "without end";
}

Rows rows_of(const InspectedObject& inspected, const std::string& unit) {
  const SceneObject& object = inspected.object;
  Rows rows = {{"from", printable(object.source)}};
  if (!std::holds_alternative<std::shared_ptr<const TriangleMesh>>(object.shape)) {
    rows.push_back({"shape", shape_text(object.shape)});
    rows.push_back({"taken as", inspected.solid ? "a solid" : "a surface"});
  }
  if (inspected.health) add_mesh_rows(rows, inspected);
  if (!inspected.health || !(object.pose == Pose{})) rows.push_back({"in the world", place_text(inspected, unit)});
  return rows;
}

std::string inspect_table(const std::vector<InspectedObject>& objects, const std::string& unit) {
  std::string text;
  for (const InspectedObject& inspected : objects)
    text += printable(inspected.object.name) + "\n" + columns(rows_of(inspected, unit), 2) +
            (inspected.volumes.empty() ? "" : volume_table(inspected.volumes)) +
            (inspected.partitions.empty() ? "" : partition_table(inspected.partitions));
  return text;
}

/// What is measured of meshes alone is asked about these too.
void warn_of_other_shapes(LoadedScene& loaded, const std::string& option) {
  for (const SceneObject& object : loaded.scene.objects)
    if (!object.mesh())
      loaded.warnings.push_back(fmt::format("{} is no mesh: {} is about meshes", object.name, option));
}

}  // namespace

int run_inspect(const InspectArguments& arguments) {
  LoadedScene loaded = load(arguments.input);
  if (arguments.volumes) warn_of_other_shapes(loaded, "--volumes");
  if (arguments.partitions) warn_of_other_shapes(loaded, "--partitions");
  std::vector<InspectedObject> objects;
  ProgressBar bar("measuring");
  CostOptions options;
  options.progress = bar.callback();
  for (const SceneObject& object : loaded.scene.objects) {
    objects.push_back(inspect(object));
    if (const auto mesh = object.mesh(); mesh && arguments.volumes)
      objects.back().volumes = measure_volumes(*mesh, options);
    if (const auto mesh = object.mesh(); mesh && arguments.partitions)
      objects.back().partitions = measure_partitions(PartitionItems(*mesh), {1000, 1, bar.callback()});
  }
  const std::string text = arguments.format == Format::json
                               ? inspect_report_json(objects, loaded.scene.unit, loaded.warnings)
                               : inspect_table(objects, loaded.scene.unit);
  print_warnings(loaded.warnings);
  print_answer(text);
  return 0;
}

}  // namespace toccata::command
