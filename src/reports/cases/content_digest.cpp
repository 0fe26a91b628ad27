#include <fmt/format.h>

#include <map>

#include "io/formats/json.hpp"
#include "io/formats/tree_bytes.hpp"
#include "io/scenes/scene_json.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata {

using io::Json;

namespace {

/// Meshes may have the same triangles and other faces of the file.
std::string digest_of_mesh(const TriangleMesh& mesh) {
  std::vector<Index> faces;
  for (Index i = 0; i < mesh.triangle_count(); ++i) faces.push_back(mesh.face_of(i));
  const auto* bytes = reinterpret_cast<const char*>(faces.data());
  return fmt::format("{:016x} {:016x}", io::digest_of(mesh), io::checksum_of({bytes, faces.size() * sizeof(Index)}));
}

}  // namespace

std::string content_digest(std::span<const SceneObject> objects, const std::string& unit) {
  std::map<const TriangleMesh*, std::string> known;
  const auto write_mesh = [&](const std::shared_ptr<const TriangleMesh>& mesh) {
    const auto [found, is_new] = known.try_emplace(mesh.get());
    if (is_new) found->second = digest_of_mesh(*mesh);
    return Json{{"mesh", found->second}};
  };
  std::string text = unit + "\n";
  for (const SceneObject& object : objects)
    text += io::json_of(object, write_mesh).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  return fmt::format("{:016x}", io::checksum_of(text));
}

std::string content_digest(const Scene& scene) {
  std::string text = content_digest(scene.objects, scene.unit) + "\n";
  for (const SceneNode& node : scene.nodes)
    text += io::json_of(node).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  for (const SceneObject& object : scene.objects) text += object.node ? fmt::format("{}\n", *object.node) : "none\n";
  return fmt::format("{:016x}", io::checksum_of(text));
}

}  // namespace toccata
