#include "toccata/io/glb_file.hpp"

#include "io/glb/glb_scene.hpp"
#include "toccata/io/output_file.hpp"

namespace toccata {

std::string scene_glb(const Scene& scene, std::span<const Posed> models, const SceneAnswer& answer,
                      const ViewOptions& options) {
  const io::ViewMeshes meshes(models);
  io::GlbScene glb(models, meshes);
  io::add_objects(glb, answer);
  io::add_findings(glb, answer);
  if (options.hierarchy) io::add_hierarchies(glb, *options.hierarchy);
  return glb.file(options, scene.unit);
}

void write_glb(const std::string& glb, const std::filesystem::path& path) { write_output(glb, path, OutputKind::glb); }

}  // namespace toccata
