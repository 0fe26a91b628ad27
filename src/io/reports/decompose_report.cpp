#include "toccata/io/report.hpp"

#include <fmt/format.h>

#include <vector>

#include "io/formats/utf8.hpp"
#include "io/reports/report_parts.hpp"

namespace toccata {

using io::Json;

namespace {

std::string name_of_part(const DecomposeReport& report, std::size_t part) {
  return fmt::format("{}-{:02}", report.name, part + 1);
}

void add(io::Json& json, const ConvexHull& hull) {
  io::Json &vertices = json["vertices"] = io::Json::array(), &faces = json["faces"] = io::Json::array();
  for (Index v = 0; v < hull.vertex_count(); ++v) vertices.push_back(io::json_of(hull.vertex(v)));
  const HullTopology topology = hull.topology();
  for (Index f = 0; f < topology.face_count(); ++f)
    faces.push_back(std::vector<Index>(topology.origin.begin() + topology.face_start[f],
                                       topology.origin.begin() + topology.face_start[f + 1]));
}

std::string line_of(const DecomposeReport& report, std::size_t i) {
  const ConvexPart& part = report.parts.parts[i];
  io::Json json = {{"name", io::as_utf8(name_of_part(report, i))},
                   {"volume", part.volume},
                   {"concavity", part.concavity},
                   {"concavity_found", part.concavity_found}};
  add(json, part.hull);
  json["source_faces"] = part.faces;
  return io::line_of(json);
}

}  // namespace

Scene parts_scene(const DecomposeReport& report, const std::string& unit) {
  Scene scene;
  scene.unit = unit;
  for (std::size_t i = 0; i < report.parts.parts.size(); ++i) {
    SceneObject object;
    object.name = name_of_part(report, i);
    object.shape = report.parts.parts[i].hull;
    object.pose = report.pose;
    object.group = report.name;
    object.source = "convex decomposition";
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

std::string decompose_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                  const DecomposeReport& report, std::span<const std::string> warnings) {
  const ConvexParts& parts = report.parts;
  io::Json json = io::report_head("toccata/decompose/1", scene, models, warnings);
  json["mesh_volume"] = parts.mesh_volume;
  json["hull_volume"] = parts.hull_volume;
  json["excess"] = parts.excess;
  json["concavity"] = parts.concavity;
  return io::with_list(io::document(json), "parts", parts.parts.size(),
                       [&](std::size_t i) { return line_of(report, i); });
}

}  // namespace toccata
