#include "toccata/io/view_page.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/formats/utf8.hpp"
#include "io/view/filled_page.hpp"
#include "io/view/finding_layers.hpp"
#include "io/view/finding_words.hpp"
#include "io/view/hierarchy_layers.hpp"
#include "io/view/partition_layers.hpp"
#include "io/view/view_data.hpp"
#include "io/view/view_meshes.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/output_file.hpp"

namespace toccata {
namespace {

using Json = nlohmann::ordered_json;

/// The report as the subcommand writes it with --json, without the faces, which are in the layers.
std::string report_of(const Scene& scene, std::span<const Posed> models, SceneAnswer answer,
                      std::span<const std::string> warnings) {
  if (auto* check = std::get_if<CheckReport>(&answer)) check->has_faces = false;
  if (auto* self = std::get_if<SelfReport>(&answer)) self->has_faces = false;
  if (auto* faces = std::get_if<FacesReport>(&answer)) faces->found.clear();
  if (auto* inspected = std::get_if<InspectReport>(&answer))
    for (InspectedObject& object : inspected->objects) object.faults.clear();
  return report_json(scene, models, answer, warnings);
}

/// Where the objects are in what was found, besides where the scene has them.
std::span<const PairQuery> queries_of(const SceneAnswer& answer) {
  if (const auto* poses = std::get_if<PosesReport>(&answer)) return poses->queries;
  if (const auto* poses = std::get_if<DistancePosesReport>(&answer)) return poses->queries;
  return {};
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

}  // namespace

std::string view_page(const Scene& scene, std::span<const Posed> models, const SceneAnswer& answer,
                      const ViewOptions& options, std::span<const std::string> warnings) {
  const io::ViewMeshes meshes(models, queries_of(answer));
  io::ViewData data;
  Json header = {
      {"format", "toccata/view/2"}, {"title", io::as_utf8(options.title)}, {"up", options.up == UpAxis::y ? "y" : "z"}};
  meshes.write(header, data);
  io::add_words(header, models, answer);
  add_nodes(header, scene);
  header["layers"] = io::finding_layers(answer, meshes, data);
  if (options.hierarchy)
    for (Json& layer : io::hierarchy_layers(models, *options.hierarchy, data))
      header["layers"].push_back(std::move(layer));
  if (options.partition)
    for (Json& layer : io::partition_layers(models, *options.partition, data))
      header["layers"].push_back(std::move(layer));
  return io::filled_page(header, report_of(scene, models, answer, warnings), data);
}

void write_view_page(const std::string& page, const std::filesystem::path& path) {
  write_output(page, path, OutputKind::page);
}

}  // namespace toccata
