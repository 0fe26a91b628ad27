#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "arguments.hpp"
#include "check_input.hpp"
#include "look.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/version.hpp"
#include "toccata/query/convex_parts.hpp"
#include "toccata/query/scene_models.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Vec3& v) { return {v.x, v.y, v.z}; }

Json json_of(const ConvexHull& hull) {
  Json vertices = Json::array(), faces = Json::array();
  for (Index v = 0; v < hull.vertex_count(); ++v) vertices.push_back(json_of(hull.vertex(v)));
  const HullTopology topology = hull.topology();
  for (Index f = 0; f < topology.face_count(); ++f) {
    const auto corners =
        topology.origin.subspan(topology.face_start[f], topology.face_start[f + 1] - topology.face_start[f]);
    faces.push_back(std::vector<Index>(corners.begin(), corners.end()));
  }
  return {{"vertices", std::move(vertices)}, {"faces", std::move(faces)}};
}

std::string report_json(const ConvexParts& parts, const Scene& pieces, const std::string& file) {
  Json json = {{"schema", "toccata/decompose/1"},
               {"version", version},
               {"file", file},
               {"mesh_volume", parts.mesh_volume},
               {"hull_volume", parts.hull_volume},
               {"excess", parts.excess},
               {"concavity", parts.concavity},
               {"parts", Json::array()}};
  for (std::size_t i = 0; i < parts.parts.size(); ++i) {
    const ConvexPart& part = parts.parts[i];
    Json entry = {{"name", pieces.objects[i].name},
                  {"volume", part.volume},
                  {"concavity", part.concavity},
                  {"concavity_found", part.concavity_found}};
    entry.update(json_of(part.hull));
    entry["source_faces"] = part.faces;
    json["parts"].push_back(std::move(entry));
  }
  return json.dump(1) + "\n";
}

std::string percent_text(const ConvexParts& parts) {
  if (parts.mesh_volume == 0) return "";
  return fmt::format(" ({:.2f} % more)", 100 * parts.excess / parts.mesh_volume);
}

std::string table_of(const ConvexParts& parts, const Scene& pieces) {
  constexpr std::size_t shown = 12;
  std::vector<std::vector<std::string>> rows{{"part", "volume", "vertices", "faces of the mesh", "from the solid"}};
  for (std::size_t i = 0; i < std::min(shown, parts.parts.size()); ++i) {
    const ConvexPart& part = parts.parts[i];
    rows.push_back({printable(pieces.objects[i].name), fmt::format("{:.4g}", part.volume),
                    grouped(part.hull.vertex_count()), grouped(part.faces.size()),
                    part.concavity == 0 ? "nowhere" : fmt::format("at most {:.3g}", part.concavity)});
  }
  std::string text = columns(rows, 0);
  if (parts.parts.size() > shown) text += fmt::format("… and {} more (all with --json)\n", parts.parts.size() - shown);
  return text +
         fmt::format(
             "{} with {:.6g} in all around a solid of {:.6g}{}; no point of them is farther from it than {:.3g}.\n",
             counted(parts.parts.size(), "convex part"), parts.hull_volume, parts.mesh_volume, percent_text(parts),
             parts.concavity);
}

const SceneObject& only_object(const Scene& scene, const DecomposeArguments& arguments) {
  if (scene.objects.size() != 1)
    throw Error(fmt::format("{} holds {}; name a file with one mesh", arguments.input.files[0],
                            counted(scene.objects.size(), "object")));
  return scene.objects[0];
}

ConvexParts parts_of(const SceneObject& object, const DecomposeArguments& arguments) {
  ProgressBar bar("cutting");
  try {
    return decompose(Model(object.shape, arguments.threads), {.max_parts = arguments.parts,
                                                              .concavity = arguments.concavity,
                                                              .threads = arguments.threads,
                                                              .progress = bar.callback()});
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", object.name, error.what()));
  }
}

/// The parts as objects that are not checked against each other.
Scene scene_of(const ConvexParts& parts, const SceneObject& object, const std::string& unit) {
  Scene scene;
  scene.unit = unit;
  for (std::size_t i = 0; i < parts.parts.size(); ++i)
    scene.objects.push_back({fmt::format("{}-{:02}", object.name, i + 1),
                             parts.parts[i].hull,
                             object.pose,
                             Solid::automatic,
                             object.name,
                             {},
                             "convex decomposition"});
  return scene;
}

ViewTarget drawn_target(const DecomposeArguments& arguments) {
  ViewTarget target = target_of(arguments);
  if (!target.picture) {
    if (arguments.size.empty() && arguments.look.empty()) return target;
    throw Error("--size and --look are of a picture: say where it shall be written with --png FILE.png");
  }
  require_known_keys(arguments.look);
  target.picture->look = arguments.look;
  if (!arguments.size.empty()) set_size(*target.picture, arguments.size);
  return target;
}

}  // namespace

int run_decompose(const DecomposeArguments& arguments) {
  const ViewTarget target = drawn_target(arguments);
  require_view(target, arguments);
  CheckInput input{load(arguments.input), {}};
  const SceneObject object = only_object(input.loaded.scene, arguments);
  const ConvexParts parts = parts_of(object, arguments);
  input.loaded.scene = scene_of(parts, object, input.loaded.scene.unit);
  input.models = scene_models(input.loaded.scene, arguments.threads);
  if (draws_something(target)) write_view(target, input, CheckReport{});
  print_warnings(input.loaded.warnings);
  print_answer(arguments.format == Format::json ? report_json(parts, input.loaded.scene, arguments.input.files[0])
                                                : table_of(parts, input.loaded.scene));
  return 0;
}

}  // namespace toccata::command
