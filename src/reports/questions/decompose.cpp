#include <fmt/format.h>

#include <memory>
#include <vector>

#include "io/formats/utf8.hpp"
#include "reports/questions/asked_of.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
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

/// The model as the pose places it: what is asked and answered about it is in the world.
Model model_in_world(const SceneInstance& posed) {
  if (!posed.model.has_mesh() || posed.pose == Pose{}) return posed.model;
  const TriangleMesh& mesh = posed.model.mesh();
  return Model(std::make_shared<const TriangleMesh>(mesh.with_vertices(transform(posed.pose, mesh.vertices()))));
}

struct DecomposeKind {
  using Question = DecomposeQuestion;
  using Report = DecomposeReport;
  static constexpr const char* name = "decompose";

  static io::Json write(const DecomposeQuestion& q) {
    return {{"parts", q.max_parts}, {"concavity", io::json_of_length(q.concavity)}};
  }

  static DecomposeQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "parts", "concavity"});
    DecomposeQuestion q;
    q.max_parts = value.whole_or("parts", std::numeric_limits<Index>::max(), q.max_parts);
    if (value.has("concavity")) q.concavity = io::length_of(value.at("concavity"));
    return q;
  }

  static DecomposeReport ask(const DecomposeQuestion& question, const io::Asking& asking) {
    if (asking.models.size() != 1)
      throw Error(
          fmt::format("one closed mesh is cut into convex parts; here {} {} objects: name one file, of one mesh",
                      asking.models.size() == 1 ? "is" : "are", asking.models.size()));
    const SceneInstance& posed = asking.models[0];
    return io::asked_of(posed.name, [&] {
      return DecomposeReport{posed.name, Pose{},
                             decompose(model_in_world(posed), {.max_parts = question.max_parts,
                                                               .concavity = question.concavity,
                                                               .threads = asking.options.threads,
                                                               .progress = asking.options.progress})};
    });
  }

  static std::string json(const DecomposeReport& report, const io::Reporting& reporting) {
    const ConvexParts& parts = report.parts;
    io::Json json = reporting.head("toccata/decompose/1");
    json["mesh_volume"] = parts.mesh_volume;
    json["hull_volume"] = parts.hull_volume;
    json["excess"] = parts.excess;
    json["concavity"] = parts.concavity;
    return io::with_list(io::document(json), "parts", parts.parts.size(),
                         [&](std::size_t i) { return line_of(report, i); });
  }
};

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

constinit const io::QuestionKind DecomposeQuestion::kind = io::question_kind<DecomposeKind>();

}  // namespace toccata
