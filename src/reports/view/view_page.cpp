#include "toccata/reports/pages.hpp"

#include <algorithm>

#include "io/formats/json.hpp"
#include "io/formats/utf8.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/view/asked_poses.hpp"
#include "reports/view/drawn_scene.hpp"
#include "reports/view/filled_page.hpp"
#include "reports/view/finding_layers.hpp"
#include "reports/view/hierarchy_layers.hpp"
#include "reports/view/pair_methods.hpp"
#include "reports/view/partition_layers.hpp"
#include "reports/view/scene_tree.hpp"
#include "reports/view/view_data.hpp"
#include "reports/view/view_meshes.hpp"
#include "reports/view/voronoi_layers.hpp"
#include "reports/view/voronoi_walk_layers.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/output_file.hpp"

namespace toccata {

using io::Json;

namespace {

/// The report as the subcommand writes it with --json, without what is in the layers.
std::string report_of(const Scene& scene, std::span<const SceneInstance> models, SceneAnswer answer,
                      std::span<const std::string> warnings) {
  const io::QuestionKind& kind = io::question_kind_of(answer);
  if (kind.leave_out_drawn != nullptr) kind.leave_out_drawn(answer);
  return report_json(scene, models, answer, warnings);
}

/// What a page says of each finding, and the methods that this names (docs/reference/view-page.md).
void add_words(Json& header, std::span<const SceneInstance> models, const SceneAnswer& answer) {
  const io::QuestionKind& kind = io::question_kind_of(answer);
  io::PairMethods methods(models);
  header["words"] = kind.words == nullptr ? Json::array() : kind.words(answer, methods);
  header["methods"] = methods.texts();
}

/// The tree of the scene, where it is one: nodes without parents are the objects themselves.
void add_nodes(Json& header, const Scene& scene) {
  const auto has_parent = [](const SceneNode& node) { return node.parent.has_value(); };
  if (std::none_of(scene.nodes.begin(), scene.nodes.end(), has_parent)) return;
  Json& nodes = header["nodes"] = Json::array();
  for (const SceneNode& node : scene.nodes) {
    nodes.push_back({{"name", io::as_utf8(node.name)}});
    if (node.parent) nodes.back()["parent"] = *node.parent;
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].node) header["objects"][i]["node"] = *scene.objects[i].node;
}

/// The volumes that are cheapest in a table of costs: each once.
std::vector<CostVolume> cheapest_volumes(const CostTable& table) {
  std::vector<CostVolume> cheapest;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const bool is_first = i == 0 || table.rows[i].workload != table.rows[i - 1].workload;
    if (is_first && std::find(cheapest.begin(), cheapest.end(), table.rows[i].volume) == cheapest.end())
      cheapest.push_back(table.rows[i].volume);
  }
  return cheapest;
}

/// Those that are asked for, and of a table of costs the cheapest.
std::vector<CostVolume> hierarchies_of(const SceneAnswer& answer, const ViewOptions& options) {
  if (options.hierarchy) return {*options.hierarchy};
  const auto* cost = std::get_if<CostReport>(&answer);
  return cost == nullptr ? std::vector<CostVolume>() : cheapest_volumes(cost->table);
}

void append(Json& layers, std::vector<Json> more) {
  for (Json& layer : more) layers.push_back(std::move(layer));
}

std::string page_of(const Scene& scene, std::span<const SceneInstance> models, const SceneAnswer& answer,
                    const ViewOptions& options, std::span<const std::string> warnings) {
  const io::ViewMeshes meshes(models, io::places_of(io::queries_of(answer)));
  io::ViewData data;
  Json header = {
      {"format", "toccata/view/4"}, {"title", io::as_utf8(options.title)}, {"up", options.up == UpAxis::y ? "y" : "z"}};
  meshes.write(header, data);
  add_words(header, models, answer);
  add_nodes(header, scene);
  Json& layers = header["layers"] = io::finding_layers(answer, meshes, data);
  if (const auto* trees = std::get_if<RebalanceReport>(&answer))
    append(layers, io::scene_tree_layers(scene, *trees, meshes.frame(), data));
  for (const CostVolume volume : hierarchies_of(answer, options))
    append(layers, io::hierarchy_layers(models, volume, data));
  if (options.partition) append(layers, io::partition_layers(models, *options.partition, data));
  if (options.voronoi) append(layers, io::voronoi_layers(models, meshes, data));
  if (options.voronoi_walk) append(layers, io::voronoi_walk_layers(models, meshes, data));
  return io::filled_page(header, report_of(scene, models, answer, warnings), data);
}

}  // namespace

std::string view_page(const Scene& scene, std::span<const SceneInstance> models, const SceneAnswer& answer,
                      const ViewOptions& options, std::span<const std::string> warnings) {
  if (const auto* crowd = std::get_if<CrowdReport>(&answer)) return crowd_page(record_crowd(crowd->question), options);
  if (const auto* crowd = std::get_if<CrowdWorldReport>(&answer))
    return world_page(record_crowd_world(crowd->question), options);
  if (const auto* sweep = std::get_if<SweepReport>(&answer)) return world_page(record_sweep(models, *sweep), options);
  if (const auto* walk = std::get_if<WalkReport>(&answer)) return world_page(record_walk(models, *walk), options);
  const io::DrawnScene drawn = io::drawn_scene(scene, models, answer);
  return page_of(drawn.scene, drawn.models, answer, options, warnings);
}

void write_view_page(const std::string& page, const std::filesystem::path& path) {
  write_output(page, path, OutputKind::page);
}

}  // namespace toccata
