#include "toccata/io/model_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

#include "io/formats/file_bytes.hpp"
#include "io/formats/file_error.hpp"
#include "io/formats/tree_bytes.hpp"
#include "query/scenes/scene_models.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata {

Model load_model(const std::string& path) {
  if (!is_generator_specification(path)) return Model(read_mesh(path), all_threads);
  const GeneratorSpecification specification = parse_generator(path);
  return Model(generate_mesh(specification.name, specification.parameters), all_threads);
}

std::string tree_path(const TriangleMesh& mesh, const std::string& folder) {
  return (std::filesystem::path(folder) / fmt::format("{:016x}.tree", io::digest_of(mesh))).string();
}

namespace {

/// Smaller trees are built in less time than it takes to look for them.
constexpr std::size_t fewest_triangles_to_keep = 1000;

using SharedMesh = std::shared_ptr<const TriangleMesh>;

/// What becomes of the trees of a scene's meshes, by their paths: in an order that no timing decides.
struct CacheUse {
  std::map<std::string, Model> built;
  std::map<std::string, std::string> warnings;
  std::mutex mutex;
};

/// Nothing where there is no tree, or none that can be taken.
std::optional<Model> loaded(const SharedMesh& mesh, const std::string& path, CacheUse& use) {
  std::error_code code;
  if (!std::filesystem::exists(path, code)) return std::nullopt;
  try {
    return load_model(mesh, path);
  } catch (const Error& error) {
    const std::lock_guard lock(use.mutex);
    use.warnings[path] = fmt::format("{}: the tree is built anew", error.what());
    return std::nullopt;
  }
}

Model cached_model(const Shape& shape, const std::string& folder, int threads, CacheUse& use) {
  const auto* mesh = std::get_if<SharedMesh>(&shape);
  if (mesh == nullptr || (*mesh)->triangle_count() < fewest_triangles_to_keep) return Model(shape, threads);
  const std::string path = tree_path(**mesh, folder);
  if (std::optional<Model> found = loaded(*mesh, path, use)) return *std::move(found);
  Model built(*mesh, threads);
  const std::lock_guard lock(use.mutex);
  use.built.insert_or_assign(path, built);
  return built;
}

}  // namespace

std::vector<SceneInstance> TreeCache::models(const Scene& scene, int threads) {
  CacheUse use;
  std::vector<SceneInstance> models = scene_models_by(
      scene, threads, [&](const Shape& shape, int of_each) { return cached_model(shape, folder_, of_each, use); });
  for (auto& [path, model] : use.built) built_.push_back(std::move(model));
  for (auto& [path, warning] : use.warnings) warnings_.push_back(std::move(warning));
  return models;
}

void TreeCache::save() {
  try {
    if (built_.empty()) return;
    std::error_code code;
    std::filesystem::create_directories(folder_, code);
    if (code) io::fail_in_file(folder_, {"the folder cannot be made: " + code.message(), "name another"});
    // Whatever has such a name there gives way, also what is no tree any more.
    for (const Model& model : built_)
      io::write_file(tree_path(model.mesh(), folder_), io::tree_bytes(model.wide_bvh(), model.mesh()));
  } catch (const Error& error) {
    warnings_.push_back(fmt::format("trees were not kept: {}", error.what()));
  }
  built_.clear();
}

}  // namespace toccata
