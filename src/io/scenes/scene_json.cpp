#include "io/scenes/scene_json.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "io/formats/utf8.hpp"
#include "io/scenes/solid_words.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata::io {
namespace {

/// JSON can say nothing else.
void check_texts(const Scene& scene) {
  for (const SceneObject& object : scene.objects)
    if (!is_utf8(object.name) || !is_utf8(object.group))
      throw Error(fmt::format("the {} of the object '{}' is not UTF-8 ({}); change it",
                              is_utf8(object.name) ? "group" : "name", as_utf8(object.name),
                              as_utf8(is_utf8(object.name) ? object.group : object.name)));
}

void check_names(const Scene& scene) {
  std::set<std::string> names;
  for (const SceneObject& object : scene.objects)
    if (object.name.empty() || !names.insert(object.name).second)
      throw Error(
          fmt::format("the scene has two objects named '{}' or one without a name; name each apart", object.name));
}

bool is_unit(const std::string& name) {
  try {
    return metres_per_unit(name) > 0;
  } catch (const Error&) {
    return false;
  }
}

/// "0.5 m" is the name of a unit of so many metres.
std::optional<double> metres_in(std::string_view name) {
  if (!name.ends_with(" m")) return std::nullopt;
  name.remove_suffix(2);
  double metres = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), metres);
  return error == std::errc() && end == name.data() + name.size() ? std::optional(metres) : std::nullopt;
}

}  // namespace

void require_writable(const Scene& scene) {
  check_texts(scene);
  check_names(scene);
}

Json scene_head(const Scene& scene) {
  Json json = {{"format", "toccata-scene"}, {"version", 1}};
  if (const auto metres = metres_in(scene.unit))
    json["unit"] = *metres;
  else if (is_unit(scene.unit) || scene.unit == "unit")
    json["unit"] = scene.unit;
  return json;
}

Json json_of(const SceneNode& node) {
  Json json = {{"name", as_utf8(node.name)}};
  if (node.parent) json["parent"] = *node.parent;
  if (!is_left_out(node.pose)) json["pose"] = node.pose.numbers();
  return json;
}

Json json_of(const SceneObject& object, const MeshWriting& write_mesh) {
  Json json = {{"name", object.name}};
  const Json shape = json_of(object.shape, write_mesh);
  if (shape.contains("type"))
    json["shape"] = shape;
  else
    json.update(shape);
  if (!is_left_out(object.pose)) json["pose"] = object.pose.numbers();
  if (object.solid != Solid::automatic) json["solid"] = word_of(object.solid);
  if (!object.group.empty()) json["group"] = object.group;
  return json;
}

}  // namespace toccata::io
