#include "three_mf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string_view>
#include <utility>

#include "toccata/core/error.hpp"
#include "words.hpp"
#include "zip_file.hpp"

namespace toccata::command {
namespace {

/// The part of a name in XML that stands behind its prefix.
std::string_view local_name(const char* name) {
  const std::string_view whole(name);
  const std::size_t colon = whole.find(':');
  return colon == std::string_view::npos ? whole : whole.substr(colon + 1);
}

std::string attribute(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_attribute& one : node.attributes())
    if (local_name(one.name()) == name) return one.value();
  return {};
}

pugi::xml_node child(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_node& one : node.children())
    if (local_name(one.name()) == name) return one;
  return {};
}

/// What the attribute `unit` of a model says, as scenes call it.
std::optional<std::string> unit_named(const std::string& name) {
  static const std::map<std::string, std::string> known = {
      {"", "mm"},     {"millimeter", "mm"}, {"micron", "1e-06 m"}, {"centimeter", "cm"},
      {"inch", "in"}, {"foot", "ft"},       {"meter", "m"}};
  const auto found = known.find(name);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

class ThreeMfReader {
 public:
  explicit ThreeMfReader(const std::string& path) : path_(path), zip_(path) {}

  ConvertedScene read() {
    const std::string root = root_part();
    const pugi::xml_node model = model_of(root);
    const std::optional<std::string> unit = unit_named(attribute(model, "unit"));
    if (!unit) fail(fmt::format("the unit '{}' is not known", printable(attribute(model, "unit"))));
    made_.scene.unit = *unit;
    for (const pugi::xml_node& item : child(model, "build").children())
      if (local_name(item.name()) == "item") add_item(item, root);
    if (made_.scene.objects.empty()) fail("its build has no mesh");
    if (left_out_ > 0)
      made_.notes.push_back(fmt::format("{}: {} left out, which {} no part of what is built", path_,
                                        counted(left_out_, "support"), left_out_ == 1 ? "is" : "are"));
    return std::move(made_);
  }

 private:
  /// An object of a part of the file, by its id.
  using Key = std::pair<std::string, std::string>;

  struct Place {
    Pose world;
    std::optional<Index> parent;
  };

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(fmt::format("{}: {}; export it again", path_, what));
  }

  [[nodiscard]] std::string where(const Key& key) const {
    return fmt::format("object {} of {}", printable(key.second), printable(key.first));
  }

  /// The part that the relationships name as the model.
  std::string root_part() {
    if (zip_.has("_rels/.rels")) {
      const pugi::xml_document& relations = parsed("_rels/.rels");
      for (const pugi::xml_node& one : relations.first_child().children())
        if (attribute(one, "Type").ends_with("/3dmodel")) return part_name(attribute(one, "Target"));
    }
    if (!zip_.has("3D/3dmodel.model")) fail("there is no 3D model in it: it is a zip, and no 3MF file");
    return "3D/3dmodel.model";
  }

  static std::string part_name(std::string target) {
    if (target.starts_with('/')) target.erase(0, 1);
    return target;
  }

  const pugi::xml_document& parsed(const std::string& part) {
    std::unique_ptr<pugi::xml_document>& document = documents_[part];
    if (document) return *document;
    document = std::make_unique<pugi::xml_document>();
    const std::string text = zip_.bytes_of(part);
    const pugi::xml_parse_result result = document->load_buffer(text.data(), text.size(), pugi::parse_default);
    if (!result) fail(fmt::format("{} is no XML: {} at byte {}", printable(part), result.description(), result.offset));
    return *document;
  }

  pugi::xml_node model_of(const std::string& part) {
    const pugi::xml_node model = child(parsed(part), "model");
    if (!model) fail(printable(part) + " has no model in it");
    return model;
  }

  pugi::xml_node object_of(const Key& key) {
    auto [objects, is_new] = objects_.try_emplace(key.first);
    if (is_new)
      for (const pugi::xml_node& one : child(model_of(key.first), "resources").children())
        if (local_name(one.name()) == "object") objects->second.emplace(attribute(one, "id"), one);
    const auto found = objects->second.find(key.second);
    if (found == objects->second.end()) fail("there is no " + where(key));
    return found->second;
  }

  double number(std::string_view text, const Key& key) const {
    const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
      fail(fmt::format("{} has '{}' where a number has to be", where(key), printable(std::string(text))));
    return value;
  }

  /// Twelve numbers, of which a point times them as a row gives where it is.
  Pose pose_of(const pugi::xml_node& node, const Key& key) const {
    const std::string text = attribute(node, "transform");
    if (text.empty()) return {};
    std::vector<double> m;
    for (std::size_t first = text.find_first_not_of(" \t\r\n"); first != std::string::npos;) {
      const std::size_t end = std::min(text.find_first_of(" \t\r\n", first), text.size());
      m.push_back(number(std::string_view(text).substr(first, end - first), key));
      first = text.find_first_not_of(" \t\r\n", end);
    }
    if (m.size() != 12) fail(fmt::format("{} has a transform of {} numbers, and not of 12", where(key), m.size()));
    return Pose::from_numbers({m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8], m[9], m[10], m[11]});
  }

  Key key_in(const pugi::xml_node& reference, const std::string& part) const {
    const std::string path = attribute(reference, "path");
    return {path.empty() ? part : part_name(path), attribute(reference, "objectid")};
  }

  void add_item(const pugi::xml_node& item, const std::string& part) {
    const Key key = key_in(item, part);
    add(key, pose_of(item, key), {});
  }

  /// The object under a node of its own.
  void add(const Key& key, const Pose& pose, const Place& above) {
    constexpr std::size_t most_objects = 1'000'000, deepest = 200;
    if (std::find(open_.begin(), open_.end(), key) != open_.end()) fail(where(key) + " contains itself");
    if (open_.size() > deepest || made_.scene.nodes.size() > most_objects)
      fail("its components are nested so often that they become a million objects");
    const pugi::xml_node object = object_of(key);
    const std::string type = attribute(object, "type");
    if (type == "support" || type == "solidsupport") {
      ++left_out_;
      return;
    }
    const std::string given = attribute(object, "name"), name = given.empty() ? "object " + key.second : given;
    const Place place{above.world * pose, static_cast<Index>(made_.scene.nodes.size())};
    made_.scene.nodes.push_back({name, above.parent, pose});
    if (const pugi::xml_node mesh = child(object, "mesh")) add_mesh(key, mesh, name, place);
    open_.push_back(key);
    for (const pugi::xml_node& component : child(object, "components").children())
      if (local_name(component.name()) == "component") {
        const Key inner = key_in(component, key.first);
        add(inner, pose_of(component, inner), place);
      }
    open_.pop_back();
  }

  void add_mesh(const Key& key, const pugi::xml_node& mesh, const std::string& name, const Place& place) {
    std::shared_ptr<const TriangleMesh>& shape = meshes_[key];
    if (!shape) shape = mesh_of(key, mesh);
    SceneObject object;
    object.name = free_name(name);
    object.shape = shape;
    object.pose = place.world;
    object.node = place.parent;
    object.source = path_;
    if (!is_finite(object.pose)) fail(where(key) + " is placed beyond the doubles");
    made_.scene.objects.push_back(std::move(object));
  }

  std::string free_name(const std::string& name) {
    std::string free = name;
    while (uses_[free]++ > 0) free = fmt::format("{} #{}", name, ++numbers_[name] + 1);
    return free;
  }

  std::shared_ptr<const TriangleMesh> mesh_of(const Key& key, const pugi::xml_node& mesh) const {
    std::vector<Vec3> vertices;
    for (const pugi::xml_node& vertex : child(mesh, "vertices").children())
      vertices.push_back({number(vertex.attribute("x").value(), key), number(vertex.attribute("y").value(), key),
                          number(vertex.attribute("z").value(), key)});
    std::vector<std::array<Index, 3>> triangles;
    for (const pugi::xml_node& triangle : child(mesh, "triangles").children())
      triangles.push_back({corner(triangle, "v1", vertices.size(), key), corner(triangle, "v2", vertices.size(), key),
                           corner(triangle, "v3", vertices.size(), key)});
    if (triangles.empty()) fail(where(key) + " has a mesh without triangles");
    return std::make_shared<const TriangleMesh>(std::move(vertices), std::move(triangles));
  }

  Index corner(const pugi::xml_node& triangle, const char* name, std::size_t vertices, const Key& key) const {
    const std::string_view text = triangle.attribute(name).value();
    Index index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (error != std::errc() || end != text.data() + text.size() || index >= vertices)
      fail(fmt::format("{} has a triangle at vertex '{}', and has {}", where(key), printable(std::string(text)),
                       counted(vertices, "vertex", "vertices")));
    return index;
  }

  std::string path_;
  ZipFile zip_;
  ConvertedScene made_;
  std::map<std::string, std::unique_ptr<pugi::xml_document>> documents_;
  std::map<std::string, std::map<std::string, pugi::xml_node>> objects_;
  std::map<Key, std::shared_ptr<const TriangleMesh>> meshes_;
  std::map<std::string, int> uses_, numbers_;
  std::vector<Key> open_;  ///< from the item down
  std::size_t left_out_ = 0;
};

}  // namespace

ConvertedScene read_three_mf(const std::string& path) { return ThreeMfReader(path).read(); }

}  // namespace toccata::command
