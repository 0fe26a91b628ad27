#include <fmt/format.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "io/formats/file_bytes.hpp"
#include "io/formats/file_error.hpp"
#include "io/formats/json_value.hpp"
#include "io/formats/number_rows.hpp"
#include "io/scenes/scene_parts.hpp"
#include "io/scenes/scene_shape.hpp"
#include "io/scenes/solid_words.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata::io {
namespace {

constexpr const char* format_name = "toccata-scene";
constexpr std::size_t scene_format_version = 1;

/// "unit" is what a scene is in whose files do not say.
double unit_of(const JsonValue& value) {
  if (value.is_string() && value.text() == "unit") return 1;
  if (!value.is_number()) return located(value, [&] { return metres_per_unit(value.text()); });
  if (!(value.number() > 0)) value.fail("a unit must be positive", "write the metres per unit, or \"mm\"");
  return value.number();
}

/// An entry of "frames" or "objects": what both have.
struct Entry {
  JsonValue value;
  std::string name;
  bool is_object;
};

std::vector<Entry> entries_of(const JsonValue& top) {
  std::vector<Entry> entries;
  std::map<std::string, bool> taken;
  for (const char* list : {"frames", "objects"})
    for (const JsonValue& value : top.elements(list)) {
      const bool is_object = std::string_view(list) == "objects";
      value.expect_keys(is_object ? std::vector<std::string>{"name", "file", "generate", "parameters", "shape", "mesh",
                                                             "parent", "node", "pose", "solid", "group", "unit",
                                                             "source", "comment"}
                                  : std::vector<std::string>{"name", "parent", "pose", "comment"});
      Entry entry{value, value.at("name").text(), is_object};
      if (entry.name.empty()) value.at("name").fail("the name is empty", "give it a name");
      if (!taken.emplace(entry.name, true).second)
        value.at("name").fail(fmt::format("the name '{}' is taken", entry.name), "give every frame and object its own");
      entries.push_back(std::move(entry));
    }
  return entries;
}

/// Puts the entries into the order in which parents come first, and makes nodes of them.
class NodeTree {
 public:
  explicit NodeTree(const std::vector<Entry>& entries) : entries_(entries), node_of_(entries.size()) {
    for (std::size_t i = 0; i < entries.size(); ++i) index_.emplace(entries[i].name, i);
    for (std::size_t i = 0; i < entries.size(); ++i) place(i);
  }

  [[nodiscard]] const std::vector<SceneNode>& nodes() const { return nodes_; }
  [[nodiscard]] Index node_of(std::size_t entry) const { return *node_of_[entry]; }
  /// In the world, composed from the root down.
  [[nodiscard]] const ScaledPose& world_of(std::size_t entry) const { return world_[*node_of_[entry]]; }

 private:
  /// Places the entry after all its ancestors. A loop, as chains may be long.
  void place(std::size_t entry) {
    std::vector<std::size_t> chain;
    for (std::optional<std::size_t> at = entry; at && !node_of_[*at]; at = parent_of(*at)) {
      chain.push_back(*at);
      if (chain.size() > entries_.size())
        entries_[entry].value.at("parent").fail("the parents go around in a circle", "remove one of them");
    }
    for (auto at = chain.rbegin(); at != chain.rend(); ++at) add_node(*at);
  }

  [[nodiscard]] std::optional<std::size_t> parent_of(std::size_t entry) const {
    const JsonValue& value = entries_[entry].value;
    if (!value.has("parent")) return std::nullopt;
    const std::string name = value.at("parent").text();
    const auto found = index_.find(name);
    if (found == index_.end()) {
      std::vector<std::string> known;
      for (const auto& [known_name, index] : index_) known.push_back(known_name);
      const std::string near = nearest_word(name, known);
      value.at("parent").fail(fmt::format("there is no frame or object named '{}'", name),
                              near.empty() ? "name one of this file" : fmt::format("did you mean '{}'?", near));
    }
    return found->second;
  }

  static ScaledPose composed(const ScaledPose& outer, const ScaledPose& inner) {
    return {outer.pose * inner.pose, outer.unscaled * inner.unscaled, outer.scale * inner.scale};
  }

  void add_node(std::size_t entry) {
    const JsonValue& value = entries_[entry].value;
    const ScaledPose own = value.has("pose") ? pose_of(value.at("pose")) : ScaledPose{};
    SceneNode node{entries_[entry].name, std::nullopt, own.pose};
    if (const auto parent = parent_of(entry)) node.parent = *node_of_[*parent];
    world_.push_back(node.parent ? composed(world_[*node.parent], own) : own);
    node_of_[entry] = static_cast<Index>(nodes_.size());
    nodes_.push_back(std::move(node));
  }

  const std::vector<Entry>& entries_;
  std::map<std::string, std::size_t> index_;
  std::vector<std::optional<Index>> node_of_;
  std::vector<SceneNode> nodes_;
  std::vector<ScaledPose> world_;
};

/// A mesh that the file itself holds.
std::shared_ptr<const TriangleMesh> inline_mesh(const JsonValue& value) {
  value.expect_keys({"vertices", "triangles", "faces", "comment"});
  const std::vector<double> numbers = rows_of_numbers(value.at("vertices"), 3, "vertex");
  const std::vector<std::uint32_t> corners = rows_of_whole_numbers(value.at("triangles"), 3, "triangle");
  std::vector<Index> faces;
  if (value.has("faces")) faces = rows_of_whole_numbers(value.at("faces"), 1, "face");
  std::vector<Vec3> vertices;
  for (std::size_t i = 0; i < numbers.size(); i += 3) vertices.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t i = 0; i < corners.size(); i += 3) triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  return located(value, [&] {
    return std::make_shared<const TriangleMesh>(std::move(vertices), std::move(triangles), std::move(faces));
  });
}

/// Reads every file and every mesh of the scene file once, and makes every generated mesh once.
class ShapeSource {
 public:
  ShapeSource(std::filesystem::path folder, const JsonValue& top) : folder_(std::move(folder)), top_(top) {
    if (top.has("meshes") && !top.at("meshes").is_object())
      top.at("meshes").fail("this is not an object", "write {\"<name>\": {\"vertices\": …}, …}");
  }

  const Scene& shapes_of(const JsonValue& object) {
    if (object.has("file") + object.has("generate") + object.has("shape") + object.has("mesh") != 1)
      object.fail("an object needs one shape", "write one of \"file\", \"generate\", \"shape\" and \"mesh\"");
    if (object.has("generate")) return generated(object);
    if (object.has("parameters"))
      object.at("parameters")
          .fail(object.has("file") ? "a file takes no parameters" : "a shape takes no parameters",
                "remove them, or write \"generate\"");
    if (object.has("mesh")) return from_scene(object.at("mesh"));
    return object.has("shape") ? written(object.at("shape")) : from_file(object.at("file"));
  }

 private:
  const Scene& from_file(const JsonValue& file) {
    const std::filesystem::path path = (folder_ / file.text()).lexically_normal();
    if (lower_case_extension(path) == ".json") file.fail("a scene cannot hold another", "name meshes or glTF files");
    const auto [found, is_new] = known_.try_emplace(path.string());
    if (is_new) found->second = located(file, [&] { return read_shapes(path); });
    return found->second;
  }

  const Scene& written(const JsonValue& shape) {
    written_.unit = "unit";
    written_.objects.assign(1, {});
    written_.objects[0].shape = shape_of(shape, [this](const JsonValue& holder) {
      return holder.has("mesh") ? from_scene(holder.at("mesh")).objects[0].mesh() : mesh_from(holder.at("file"));
    });
    written_.objects[0].source = "written: " + type_of(written_.objects[0].shape);
    return written_;
  }

  /// One of the "meshes".
  const Scene& from_scene(const JsonValue& mesh) {
    const std::string name = mesh.text();
    if (!top_.has("meshes") || !top_.at("meshes").has(name.c_str()))
      mesh.fail(fmt::format("there is no mesh named {}", in_quotes(name)), "name one of the \"meshes\" of this file");
    const auto [found, is_new] = in_scene_.try_emplace(name);
    if (!is_new) return found->second;
    SceneObject object;
    object.shape = inline_mesh(top_.at("meshes").at(name));
    object.source = "written: mesh";
    found->second.unit = "unit";
    found->second.objects.push_back(std::move(object));
    return found->second;
  }

  std::shared_ptr<const TriangleMesh> mesh_from(const JsonValue& file) {
    const Scene& shapes = from_file(file);
    if (shapes.objects.size() != 1 || !(shapes.objects[0].pose == Pose{}))
      file.fail("a shape is made of one mesh, and the file holds posed objects", "name a mesh file");
    return shapes.objects[0].mesh();
  }

  const Scene& generated(const JsonValue& object) {
    const std::string name = object.at("generate").text();
    GeneratorParameters parameters;
    std::string key = "gen:" + name;
    if (object.has("parameters")) {
      const JsonValue given = object.at("parameters");
      if (!given.is_object()) given.fail("this is not an object", "write {\"<parameter>\": <number>, …}");
      for (const std::string& parameter : given.keys()) {
        parameters[parameter] = given.at(parameter).number();
        key += fmt::format("{}{}={}", key.find('?') == std::string::npos ? '?' : '&', parameter, parameters[parameter]);
      }
    }
    const auto [found, is_new] = known_.try_emplace(key);
    if (!is_new) return found->second;
    SceneObject made;
    made.shape = located(object, [&] { return std::make_shared<const TriangleMesh>(generate_mesh(name, parameters)); });
    made.source = "generated: " + key;
    found->second.unit = "unit";
    found->second.objects.push_back(std::move(made));
    return found->second;
  }

  std::filesystem::path folder_;
  JsonValue top_;
  std::map<std::string, Scene> known_;
  std::map<std::string, Scene> in_scene_;  ///< of the scene file's own meshes
  Scene written_;                          ///< the shape that the file itself wrote last
};

/// World units per unit of the object's shape.
double unit_factor(const JsonValue& object, const Scene& shapes, double scene_metres) {
  if (!object.has("unit") && shapes.unit != "m") return 1;  // glTF is in metres; other files are in the scene's unit
  const double metres = object.has("unit") ? unit_of(object.at("unit")) : 1;
  const double factor = metres / scene_metres;
  if (!is_scale(factor))
    object.fail(fmt::format("its \"unit\" of {} m over the \"unit\" of the scene, {} m, is {}, which leaves no shape",
                            metres, scene_metres, factor),
                "change one of the two");
  return factor;
}

/// Where an object is, and how many times as large its shape: by its unit, and by the uniform scales above it.
struct Place {
  ScaledPose world;
  double unit_factor = 1;
};

/// Puts the shape at its place. What a pose may not deform takes the unit and the uniform scales into its own numbers,
/// everything else into the nine numbers of R.
void put(SceneObject& object, const SceneObject& part, const Place& place, const Entry& entry) {
  const Pose& world = place.world.pose;
  if (keeps_its_form(part.shape)) {
    object.shape =
        located(entry.value, [&] { return scaled_in_itself(part.shape, place.world.scale * place.unit_factor); });
    object.pose = {place.world.unscaled, world.offset};
    return;
  }
  const Pose pose = scaled(world, place.unit_factor);
  if (is_collapsed(world, pose))
    entry.value.fail("the scale of its pose times its unit leaves no shape", "change \"pose\" or \"unit\"");
  object.shape = part.shape;
  object.pose = is_left_out(part.pose) ? pose : pose * part.pose;  // which would take the sign from a zero
}

void add_objects_of_entry(Scene& scene, const Entry& entry, const Scene& shapes, const SceneObject& common,
                          const Place& place) {
  for (const SceneObject& part : shapes.objects) {
    SceneObject object = common;
    object.name = shapes.objects.size() == 1 ? entry.name : entry.name + "/" + part.name;
    object.source = entry.value.text_or("source", part.source);
    put(object, part, place, entry);
    if (!is_finite(object.pose))
      entry.value.fail(fmt::format("the pose of '{}' is not finite once its parents and unit are applied", object.name),
                       "use smaller numbers");
    scene.objects.push_back(std::move(object));
  }
}

void refuse_report(const JsonValue& top) {
  if (!top.is_object() || !top.has("schema") || !top.at("schema").is_string()) return;
  if (top.at("schema").text().starts_with("toccata/"))
    top.fail("this is a report of Toccata, not a scene", "name it alone to view");
}

void check_format(const JsonValue& top) {
  refuse_report(top);
  top.expect_keys({"format", "version", "unit", "frames", "nodes", "meshes", "objects", "query", "answer", "comment"});
  if (top.at("format").text() != format_name)
    top.at("format").fail("this is not a scene of Toccata", fmt::format("write \"{}\"", format_name));
  if (top.at("version").whole(1000000) != scene_format_version)
    top.at("version").fail("this version is not known",
                           fmt::format("write {}, or use a newer Toccata", scene_format_version));
}

std::string unit_name(const JsonValue& top) {
  if (!top.has("unit")) return "m";
  const JsonValue unit = top.at("unit");
  return unit.is_number() ? fmt::format("{} m", unit.number()) : unit.text();
}

/// A tree of nodes that is told beside objects which are where they are: as cases about it have one.
std::vector<SceneNode> nodes_of(const JsonValue& top) {
  if (top.has("frames")) top.at("nodes").fail("there are \"frames\" too", "write one of the two");
  std::vector<SceneNode> nodes;
  for (const JsonValue& value : top.elements("nodes")) {
    value.expect_keys({"name", "parent", "pose"});
    SceneNode node{value.at("name").text(), std::nullopt, {}};
    if (value.has("parent")) {
      if (nodes.empty()) value.at("parent").fail("the first node has no parent", "remove it");
      node.parent = static_cast<Index>(value.at("parent").whole(nodes.size() - 1));
    }
    if (value.has("pose")) node.pose = pose_of(value.at("pose")).pose;
    nodes.push_back(std::move(node));
  }
  return nodes;
}

std::optional<Index> node_of(const JsonValue& object, std::size_t nodes) {
  if (!object.has("node")) return std::nullopt;
  if (nodes == 0) object.at("node").fail("there are no \"nodes\"", "remove it");
  return static_cast<Index>(object.at("node").whole(nodes - 1));
}

/// A crowd is made from its seed.
bool is_about_no_scene(const JsonValue& top) {
  if (!top.has("query")) return false;
  const std::string question = top.at("query").text_or("question", "");
  return question == "crowd" || question == "crowd-world";
}

}  // namespace

Scene parse_scene_file(const SceneBytes& bytes) {
  const nlohmann::json document = parse_json(bytes.bytes, bytes.file, RepeatedKeys::refused);
  return scene_of(JsonValue(document, bytes.file), bytes.folder);
}

Scene scene_of(const JsonValue& top, const std::filesystem::path& folder) {
  check_format(top);
  const double metres = top.has("unit") ? unit_of(top.at("unit")) : 1;
  const std::vector<Entry> entries = entries_of(top);
  const NodeTree tree(entries);
  ShapeSource source(folder, top);
  Scene scene;
  scene.unit = unit_name(top);
  const bool has_nodes = top.has("nodes");
  scene.nodes = has_nodes ? nodes_of(top) : tree.nodes();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const JsonValue& value = entries[i].value;
    if (!entries[i].is_object) continue;
    const Scene& shapes = source.shapes_of(value);
    SceneObject common;
    common.solid = value.has("solid") ? solid_of(value.at("solid")) : Solid::automatic;
    common.group = value.text_or("group", "");
    common.node = has_nodes ? node_of(value, scene.nodes.size()) : std::optional(tree.node_of(i));
    add_objects_of_entry(scene, entries[i], shapes, common, {tree.world_of(i), unit_factor(value, shapes, metres)});
  }
  if (scene.objects.empty() && !is_about_no_scene(top)) top.fail("the scene has no objects", "add one to \"objects\"");
  return scene;
}

}  // namespace toccata::io
