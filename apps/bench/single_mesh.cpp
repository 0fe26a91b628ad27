#include "single_mesh.hpp"

#include <fmt/format.h>

#include "toccata/core/error.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata::bench {

std::shared_ptr<const TriangleMesh> single_mesh(const std::string& file) {
  const Scene scene = read_scene(file);
  if (scene.objects.size() != 1)
    throw Error(fmt::format("{}: holds {} objects; a mesh to measure is one", file, scene.objects.size()));
  std::shared_ptr<const TriangleMesh> mesh = scene.objects.front().mesh();
  if (mesh == nullptr) throw Error(fmt::format("{}: holds another shape; a mesh is to be measured", file));
  return mesh;
}

}  // namespace toccata::bench
