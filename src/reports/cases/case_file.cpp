#include "toccata/reports/case_file.hpp"

#include <fmt/format.h>

#include <cctype>
#include <map>

#include "io/formats/file_bytes.hpp"
#include "io/formats/json.hpp"
#include "io/formats/number_rows.hpp"
#include "io/formats/utf8.hpp"
#include "io/scenes/scene_json.hpp"
#include "io/scenes/scene_parts.hpp"
#include "reports/cases/first_difference.hpp"
#include "reports/questions/question_kinds.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/reports/output_file.hpp"

namespace toccata {

using io::Json;

namespace {

namespace fs = std::filesystem;

Json json_of(const TriangleMesh& mesh) {
  std::vector<double> numbers;
  for (const Vec3& v : mesh.vertices()) numbers.insert(numbers.end(), {v.x, v.y, v.z});
  std::vector<std::uint32_t> corners, faces;
  bool one_each = mesh.face_count() == mesh.triangle_count();
  for (Index i = 0; i < mesh.triangle_count(); ++i) {
    const auto& triangle = mesh.triangles()[i];
    corners.insert(corners.end(), triangle.begin(), triangle.end());
    faces.push_back(mesh.face_of(i));
    one_each = one_each && faces.back() == i;
  }
  Json json = {{"vertices", io::json_of_rows(numbers, 3)}, {"triangles", io::json_of_rows(corners, 3)}};
  if (!one_each) json["faces"] = io::json_of_rows(faces, 1);
  return json;
}

/// The meshes of a scene, each once, named after the first object that has it.
class InlineMeshes {
 public:
  Json named(const std::shared_ptr<const TriangleMesh>& mesh, const std::string& owner) {
    const auto [found, is_new] = name_of_.try_emplace(mesh.get());
    if (is_new) {
      found->second = names_.make(owner);
      text_ += (text_.empty() ? "\n  " : ",\n  ") + Json(found->second).dump() + ": " + json_of(*mesh).dump();
    }
    return {{"mesh", found->second}};
  }

  /// The members of "meshes", a line each; empty where there is none.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::map<const TriangleMesh*, std::string> name_of_;
  io::UniqueNames names_;
  std::string text_;
};

/// A line each.
std::string nodes_text(const std::vector<SceneNode>& nodes) {
  std::string text;
  for (const SceneNode& node : nodes) text += (text.empty() ? "\n  " : ",\n  ") + io::json_of(node).dump();
  return text;
}

std::string text_of(const Case& content) {
  const bool has_nodes = content.question && std::holds_alternative<HierarchyQuestion>(*content.question);
  InlineMeshes meshes;
  std::string objects;
  for (const SceneObject& object : content.scene.objects) {
    Json json = io::json_of(object, [&](const auto& mesh) { return meshes.named(mesh, object.name); });
    json["source"] = io::as_utf8(object.source);  // also where it is empty: a report repeats it
    if (has_nodes && object.node) json["node"] = *object.node;
    objects += (objects.empty() ? "\n  " : ",\n  ") + json.dump();
  }
  Json head = {{"comment", "Case of Toccata: `toccata replay FILE` asks it again"}};
  head.update(io::scene_head(content.scene));
  std::string text = head.dump(1);
  text.resize(text.size() - 2);  // the end of the object
  if (!meshes.text().empty()) text += ",\n \"meshes\": {" + meshes.text() + "\n }";
  if (has_nodes) text += ",\n \"nodes\": [" + nodes_text(content.scene.nodes) + "\n ]";
  text += ",\n \"objects\": [" + objects + "\n ]";
  if (content.question) text += ",\n \"query\": " + io::json_of(*content.question).dump();
  if (!content.answer.empty()) text += ",\n \"answer\": " + content.answer;
  while (std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
  return text + "\n}\n";
}

std::string name_for(const SceneInstance& posed, std::size_t place) {
  if (!posed.name.empty()) return io::as_utf8(posed.name);
  return place < 26 ? std::string(1, static_cast<char>('a' + place)) : fmt::format("object {}", place);
}

std::string answer_or_error(const Case& content, const AskOptions& options) {
  try {
    const std::vector<SceneInstance> models = scene_models(content.scene, options.threads);
    return report_json(content.scene, models, ask(content.scene, models, *content.question, options));
  } catch (const Error& error) {
    return error_json(error.what());
  }
}

}  // namespace

Scene scene_of(std::span<const SceneInstance> models, const std::string& unit) {
  Scene scene;
  scene.unit = unit;
  io::UniqueNames names;
  for (const SceneInstance& posed : models) {
    SceneObject object;
    object.name = names.make(name_for(posed, scene.objects.size()));
    object.shape = posed.model.shape();
    object.pose = posed.pose;
    object.solid = posed.solid;
    object.group = io::as_utf8(posed.group);
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

Case read_case(const fs::path& path) {
  const io::FileBytes bytes = io::read_file(path);
  const std::string file = path.string();
  const nlohmann::json document = io::parse_json(bytes.span(), file, io::RepeatedKeys::refused);
  const io::JsonValue top(document, file);
  Case content{io::scene_of(top, path.parent_path()), {}, {}};
  if (top.has("query")) content.question = io::question_of(top.at("query"));
  if (!top.has("answer")) return content;
  if (!content.question) top.at("answer").fail("this answers no \"query\"", "write the query, or remove the answer");
  content.answer = document.at("answer").dump();
  return content;
}

void write_case(const Case& content, const fs::path& path) {
  io::require_writable(content.scene);
  const bool is_crowd = content.question && is_of_crowd(*content.question);
  if (content.scene.objects.empty() && !is_crowd) throw Error("the scene has no objects; a case is about at least one");
  if (!content.answer.empty() && !nlohmann::json::accept(content.answer))
    throw Error("the answer of the case is not JSON; write what report_json or error_json gives");
  write_output(text_of(content), path, OutputKind::case_file);
}

std::string error_json(const std::string& message) { return Json{{"error", io::as_utf8(message)}}.dump(); }

std::string answer_difference(const std::string& recorded, const std::string& now) {
  return io::first_difference(recorded, now);
}

Replay replay(const Case& content, const AskOptions& options) {
  if (!content.question) throw Error("this scene holds no question; one is written by --save-case, or by write_case");
  Replay result{answer_or_error(content, options), {}};
  if (!content.answer.empty()) result.difference = io::first_difference(content.answer, result.answer);
  return result;
}

}  // namespace toccata
