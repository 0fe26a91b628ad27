#include <fmt/format.h>

#include "arguments.hpp"
#include "load.hpp"
#include "output.hpp"
#include "toccata/core/error.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

std::string box_text(const Vec3& lower, const Vec3& upper) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g})", lower.x, lower.y, lower.z, upper.x,
                     upper.y, upper.z);
}

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

std::vector<std::vector<std::string>> rows_of(const InspectedObject& object, const std::string& unit) {
  if (!object.health) return {{"from", printable(object.source)}, {"shape", object.shape}};
  const MeshHealth& h = *object.health;
  std::vector<std::vector<std::string>> rows = {
      {"from", printable(object.source)},
      {"triangles", grouped(h.triangles) + (h.faces == h.triangles ? "" : " of " + counted(h.faces, "face"))},
      {"vertices", fmt::format("{} ({} distinct)", grouped(h.vertices), grouped(h.distinct_vertices))},
      {"parts", grouped(h.components)},
      {"box", box_text(h.lower, h.upper) + " in file units"},
      {"closed", closed_text(h)}};
  if (!(object.pose == Pose{}))
    rows.push_back({"in the world", box_text(object.world_box.lower, object.world_box.upper) + " " + unit});
  if (h.closed) rows.push_back({"volume", fmt::format("{:.6g} in file units cubed", h.signed_volume)});
  add_finding(rows, h.closed ? h.non_manifold_edges : 0, "non-manifold edges", "used by more than two triangles");
  add_finding(rows, h.degenerate_triangles, "degenerate triangles", "without area; kept, and answered exactly");
  add_finding(rows, h.duplicate_triangles, "duplicate triangles", "the same three vertices as an earlier one; kept");
  add_finding(rows, h.unused_vertices, "unused vertices", "in no triangle; ignored");
  return rows;
}

std::string inspect_table(const std::vector<InspectedObject>& objects, const std::string& unit) {
  std::string text;
  for (const InspectedObject& object : objects)
    text += printable(object.name) + "\n" + columns(rows_of(object, unit), 2);
  return text;
}

}  // namespace

int run_inspect(const InspectArguments& arguments) {
  const LoadedScene loaded = load(arguments.input);
  std::vector<InspectedObject> objects;
  for (const SceneObject& object : loaded.scene.objects) objects.push_back(inspect(object));
  const std::string text = arguments.format == Format::json
                               ? inspect_report_json(objects, loaded.scene.unit, loaded.warnings)
                               : inspect_table(objects, loaded.scene.unit);
  print_warnings(loaded.warnings);
  print_answer(text);
  return 0;
}

}  // namespace toccata::command
