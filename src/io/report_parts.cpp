#include "io/report_parts.hpp"

#include "io/utf8.hpp"
#include "toccata/core/version.hpp"

namespace toccata::io {

Json json_of(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json json_of(const SceneObject& object, const Posed& posed) {
  return {{"name", as_utf8(object.name)},
          {"source", as_utf8(object.source)},
          {"triangles", object.mesh->triangle_count()},
          {"faces", object.mesh->face_count()},
          {"closed", posed.model.closed()},
          {"solid", taken_as_solid(posed.model, object.solid)},
          {"group", object.group},
          {"pose", object.pose.numbers()}};
}

std::string document(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json report_head(const std::string& schema, const Scene& scene, std::span<const Posed> models,
                 std::span<const std::string> warnings) {
  Json json = {{"schema", schema}, {"version", version}, {"unit", scene.unit}, {"warnings", warnings}};
  Json& objects = json["objects"] = Json::array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) objects.push_back(json_of(scene.objects[i], models[i]));
  return json;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace toccata::io
