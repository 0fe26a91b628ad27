#include <fmt/format.h>

#include <map>

#include "io/formats/json.hpp"
#include "io/formats/tree_bytes.hpp"
#include "io/scenes/scene_json.hpp"
#include "reports/report_parts.hpp"
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

/// Objects as digests know them: with the digest of each mesh, which is made once.
class ContentWriter {
 public:
  Json operator()(const SceneObject& object) {
    return io::json_of(object, [this](const std::shared_ptr<const TriangleMesh>& mesh) {
      const auto [found, is_new] = known_.try_emplace(mesh.get());
      if (is_new) found->second = digest_of_mesh(*mesh);
      return Json{{"mesh", found->second}};
    });
  }

 private:
  std::map<const TriangleMesh*, std::string> known_;
};

/// `content_of` tells an object by its number.
template <class ContentOf>
std::string digest_of(std::size_t count, const std::string& unit, const ContentOf& content_of) {
  std::string text = unit + "\n";
  for (std::size_t i = 0; i < count; ++i) text += io::line_of(content_of(i)) + "\n";
  return fmt::format("{:016x}", io::checksum_of(text));
}

}  // namespace

std::string content_digest(std::span<const SceneObject> objects, const std::string& unit) {
  ContentWriter write;
  return digest_of(objects.size(), unit, [&](std::size_t i) { return write(objects[i]); });
}

std::string content_digest(const Scene& scene) {
  std::string text = content_digest(scene.objects, scene.unit) + "\n";
  for (const SceneNode& node : scene.nodes) text += io::line_of(io::json_of(node)) + "\n";
  for (const SceneObject& object : scene.objects) text += object.node ? fmt::format("{}\n", *object.node) : "none\n";
  return fmt::format("{:016x}", io::checksum_of(text));
}

std::vector<std::string> object_summaries(const Scene& scene, std::span<const SceneInstance> models) {
  ContentWriter write;
  std::vector<std::string> summaries;
  for (std::size_t i = 0; i < models.size(); ++i)
    summaries.push_back(io::line_of({{"object", io::json_of(scene.objects[i], models[i])},
                                     {"box", io::box_json(models[i])},
                                     {"content", write(scene.objects[i])}}));
  return summaries;
}

std::string content_digest(std::span<const SceneObject> objects, std::span<const std::string> summaries,
                           const std::string& unit) {
  return digest_of(objects.size(), unit, [&](std::size_t i) {
    Json content = Json::parse(summaries[i])["content"];
    content["name"] = objects[i].name;
    return content;
  });
}

}  // namespace toccata
