#include "reports/report_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "io/formats/utf8.hpp"
#include "io/scenes/scene_shape.hpp"
#include "reports/pair_motion.hpp"
#include "toccata/core/version.hpp"

namespace toccata::io {
namespace {

Json json_of_feature(const ConvexFeature& feature) {
  constexpr std::array<const char*, 3> names = {"vertex", "edge", "face"};
  return {{"kind", names[static_cast<std::size_t>(feature.kind)]}, {"index", feature.index}};
}

}  // namespace

Json json_of_length(double length) { return std::isinf(length) ? Json("all") : Json(length); }

Json json_of(const Aabb& box) { return {{"lower", json_of(box.lower)}, {"upper", json_of(box.upper)}}; }

Json json_of(const SceneObject& object, const SceneInstance& posed) {
  const auto mesh = object.mesh();
  return {{"name", as_utf8(object.name)},
          {"source", as_utf8(object.source)},
          {"shape", type_of(object.shape)},
          {"triangles", mesh ? mesh->triangle_count() : 0},
          {"faces", mesh ? mesh->face_count() : 0},
          {"closed", mesh && posed.model.closed()},
          {"solid", taken_as_solid(posed.model, object.solid)},
          {"group", object.group},
          {"pose", object.pose.numbers()}};
}

Json json_of(const ReportedFacePair& pair) {
  Json intersections = Json::array();
  for (const ReportedIntersection& intersection : pair.intersections) {
    Json points = Json::array();
    for (const Vec3& point : intersection.points) points.push_back(json_of(point));
    intersections.push_back({{"kind", name_of(intersection.kind)}, {"points", std::move(points)}});
  }
  return {{"face_a", pair.face_a},
          {"face_b", pair.face_b},
          {"crossing", pair.crossing},
          {"intersections", std::move(intersections)}};
}

Json json_of(const Penetration& penetration) {
  return {{"lower", penetration.lower},
          {"upper", penetration.upper},
          {"direction", json_of(penetration.direction)},
          {"on_a", json_of(penetration.on_a)},
          {"on_b", json_of(penetration.on_b)},
          {"status", name_of(penetration.status)}};
}

Json json_of(const Penetration& penetration, DepthEnd end) {
  Json json = json_of(penetration);
  if (end != DepthEnd::precise) json["ended"] = name_of(end);
  return json;
}

void add_depth_options(Json& json, const DepthOptions& depth) {
  json["precision"] = depth.precision;
  if (depth.time_limit < std::numeric_limits<double>::infinity()) json["time_per_depth"] = depth.time_limit;
}

DepthOptions depth_options_of(const JsonValue& question) {
  return depth_options_of(question, question.flag_or("penetration", false));
}

DepthOptions depth_options_of(const JsonValue& question, bool is_asked) {
  DepthOptions depth;
  const auto take = [&](const char* key, double& number, const char* advice) {
    if (!question.has(key)) return;
    if (!is_asked)
      question.at(key).fail("this is about depths, which are not asked for",
                            "add \"penetration\": true, or leave it out");
    number = question.at(key).number();
    if (!(number > 0)) question.at(key).fail("this is not above 0", advice);
  };
  take("precision", depth.precision, "0.1 asks for a bracket that is 10 % wide");
  take("time_per_depth", depth.time_limit, "give seconds, or leave it out for no limit");
  return depth;
}

Json json_of(const Manifold& manifold) {
  Json points = Json::array();
  for (int i = 0; i < manifold.count; ++i) {
    const ManifoldPoint& point = manifold.points[static_cast<std::size_t>(i)];
    points.push_back({{"position", json_of(point.position)},
                      {"depth", point.depth},
                      {"on_a", json_of_feature(point.on_a)},
                      {"on_b", json_of_feature(point.on_b)}});
  }
  return {{"normal", json_of(manifold.normal)}, {"points", std::move(points)}};
}

Json json_of(const std::vector<ContactManifold>& manifolds) {
  Json list = Json::array();
  for (const ContactManifold& one : manifolds) {
    Json entry = {{"element_a", one.contact.element_a},
                  {"element_b", one.contact.element_b},
                  {"face_a", one.contact.face_a},
                  {"face_b", one.contact.face_b}};
    entry.update(json_of(one.manifold));
    list.push_back(std::move(entry));
  }
  return list;
}

Json json_of(const ContactRegion& region) {
  return {{"triangle_pairs", region.triangle_pairs},
          {"face_pairs", region.face_pairs},
          {"points", region.point_count},
          {"lower", json_of(region.box.lower)},
          {"upper", json_of(region.box.upper)},
          {"closed", region.closed},
          {"curves", region.curve_count},
          {"area", region.area},
          {"normal", json_of(region.normal)},
          {"depth", region.depth ? Json(region.depth->lower) : Json()},
          {"depth_upper", region.depth ? Json(region.depth->upper) : Json()},
          {"deepest", json_of(region.deepest)}};
}

Json json_of(const std::vector<ContactRegion>& regions) {
  Json list = Json::array();
  for (const ContactRegion& region : regions) list.push_back(json_of(region));
  return list;
}

std::string csv_penetration_head(bool told) {
  return told ? ",depth_lower,depth_upper,direction_x,direction_y,direction_z,depth_ended\n" : "\n";
}

std::string csv_of(const std::optional<Penetration>& penetration, DepthEnd end) {
  if (!penetration) return ",,,,,,";
  const Vec3& direction = penetration->direction;
  return fmt::format(",{},{},{},{},{},{}", penetration->lower, penetration->upper, direction.x, direction.y,
                     direction.z, end == DepthEnd::precise ? "" : name_of(end));
}

void add(Json& line, const Distance& d) {
  line["lower"] = d.lower;
  line["upper"] = d.upper;
  line["on_a"] = json_of(d.on_a);
  line["on_b"] = json_of(d.on_b);
  line["face_a"] = d.face_a;
  line["face_b"] = d.face_b;
  line["status"] = name_of(d.status);
}

std::string csv_of(const Distance& d) {
  return fmt::format(",{},{},{},{},{},{},{},{},{},{},{}", d.lower, d.upper, d.on_a.x, d.on_a.y, d.on_a.z, d.on_b.x,
                     d.on_b.y, d.on_b.z, d.face_a, d.face_b, name_of(d.status));
}

std::string document(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string with_list(std::string document, const std::string& name, std::size_t count,
                      const std::function<std::string(std::size_t)>& item) {
  document.resize(document.size() - std::string_view("\n}\n").size());
  document += ",\n  \"" + name + "\": [";
  for (std::size_t i = 0; i < count; ++i) document += (i == 0 ? "\n    " : ",\n    ") + item(i);
  return document + (count == 0 ? "]\n}\n" : "\n  ]\n}\n");
}

Json objects_json(const Scene& scene, std::span<const SceneInstance> models) {
  Json objects = Json::array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) objects.push_back(json_of(scene.objects[i], models[i]));
  return objects;
}

Json objects_json(const Scene& scene, std::span<const std::string> summaries) {
  Json objects = Json::array();
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    objects.push_back(Json::parse(summaries[i])["object"]);
    objects.back()["name"] = as_utf8(scene.objects[i].name);
  }
  return objects;
}

Json box_json(const SceneInstance& model) {
  const std::optional<Aabb> box = placed(model).box;
  return box ? json_of(*box) : Json();
}

Json report_head(const std::string& schema, const Scene& scene, Json objects, std::span<const std::string> warnings) {
  Json json = {{"schema", schema}, {"version", version}, {"unit", scene.unit}, {"warnings", warnings}};
  json["objects"] = std::move(objects);
  return json;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace toccata::io

namespace toccata {

std::string joined_reports_json(std::span<const NamedReport> reports) {
  std::string text = "{";
  for (std::size_t i = 0; i < reports.size(); ++i) {
    std::string_view json = reports[i].json;
    if (json.ends_with('\n')) json.remove_suffix(1);
    text += (i == 0 ? "\n" : ",\n") + io::line_of(io::as_utf8(reports[i].name)) + ": " + std::string(json);
  }
  return text + "\n}\n";
}

}  // namespace toccata
