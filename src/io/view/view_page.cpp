#include "toccata/io/view_page.hpp"

#include <nlohmann/json.hpp>

#include "io/formats/utf8.hpp"
#include "io/view/hierarchy_layers.hpp"
#include "io/view/view_data.hpp"
#include "io/view/view_layers.hpp"
#include "io/view/view_meshes.hpp"
#include "io/view/view_template.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/output_file.hpp"
#include "toccata/io/relation_words.hpp"
#include "toccata/query/pairs.hpp"

namespace toccata {
namespace {

using Json = nlohmann::ordered_json;

/// Where the data goes in the template.
constexpr std::string_view data_place = "<!--toccata-data-->";

/// JSON that no HTML parser takes for the end of the element it stands in.
std::string without_tags(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json)
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

/// The report as `check --json` writes it, without the faces, which are in the layers.
std::string report_of(const Scene& scene, std::span<const Posed> models, const CheckReport& report,
                      std::span<const std::string> warnings) {
  CheckReport without_faces = report;
  without_faces.has_faces = false;
  return check_report_json(scene, models, without_faces, warnings);
}

/// How each thing that is known of a pair was found, by the table of pairs.
class Methods {
 public:
  explicit Methods(std::span<const Posed> models) : models_(models) {}

  Json of(const ReportedPair& pair) {
    Json methods = {{"relation", number_of(ShapeQuestion::relation, pair)}};
    if (pair.penetration) methods["penetration"] = number_of(ShapeQuestion::penetration, pair);
    if (pair.distance) methods["distance"] = number_of(ShapeQuestion::distance, pair);
    return methods;
  }

  [[nodiscard]] const Json& texts() const { return texts_; }

 private:
  std::size_t number_of(ShapeQuestion question, const ReportedPair& pair) {
    const PairCell cell =
        pair_cell(question, kind_of(models_[pair.a].model.shape()), kind_of(models_[pair.b].model.shape()));
    const Json text = cell.text == pair_cells::by_parts.text ? "what holds for their parts" : std::string(cell.text);
    const auto found = std::find(texts_.begin(), texts_.end(), text);
    if (found != texts_.end()) return static_cast<std::size_t>(found - texts_.begin());
    texts_.push_back(text);
    return texts_.size() - 1;
  }

  std::span<const Posed> models_;
  Json texts_ = Json::array();
};

void add_words(Json& header, const CheckReport& report, std::span<const Posed> models) {
  Methods methods(models);
  Json& words = header["words"] = Json::array();
  for (const ReportedPair& pair : report.pairs) {
    const bool is_near = pair.relation.kind == RelationKind::apart;
    Json entry = {{"verb", is_near ? "is near" : verb_of(pair.relation)}, {"remark", remark_on(pair.relation)}};
    if (report.has_faces) entry["face_pairs"] = pair.face_pairs.size();
    entry["methods"] = methods.of(pair);
    words.push_back(std::move(entry));
  }
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

std::string script(const char* id, const char* type, const std::string& text) {
  return std::string("<script id=\"") + id + "\" type=\"" + type + "\">" + text + "</script>\n";
}

}  // namespace

std::string view_page(const Scene& scene, std::span<const Posed> models, const CheckReport& report,
                      const ViewOptions& options, std::span<const std::string> warnings) {
  const io::ViewMeshes meshes(models);
  io::ViewData data;
  Json header = {
      {"format", "toccata/view/1"}, {"title", io::as_utf8(options.title)}, {"up", options.up == UpAxis::y ? "y" : "z"}};
  meshes.write(header, data);
  add_words(header, report, models);
  add_nodes(header, scene);
  header["layers"] = io::pair_layers(report, meshes, data);
  if (options.hierarchy)
    for (Json& layer : io::hierarchy_layers(models, *options.hierarchy, data))
      header["layers"].push_back(std::move(layer));
  std::string page;
  for (const std::string_view piece : io::view_template()) page += piece;
  const std::size_t place = page.find(data_place);
  if (place == std::string::npos) throw Error("the template of the page is damaged: build apps/viewer again");
  const std::string scripts =
      script("toccata-header", "application/json",
             without_tags(header.dump(-1, ' ', false, Json::error_handler_t::replace))) +
      script("toccata-report", "application/json", without_tags(report_of(scene, models, report, warnings))) +
      script("toccata-data", "application/octet-stream", data.base64());
  return page.replace(place, data_place.size(), scripts);
}

void write_view_page(const std::string& page, const std::filesystem::path& path) {
  write_output(page, path, OutputKind::page);
}

}  // namespace toccata
