#include "toccata/reports/pages.hpp"

#include "reports/glb/glb_scene.hpp"
#include "reports/view/asked_poses.hpp"
#include "reports/view/drawn_scene.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/output_file.hpp"

namespace toccata {
namespace {

/// The models as they are drawn; those that move through poses are at their own places, as their nodes move.
std::vector<SceneInstance> models_of(const Scene& scene, std::span<const SceneInstance> models,
                                     const SceneAnswer& answer) {
  std::vector<SceneInstance> drawn = io::drawn_scene(scene, models, answer).models;
  if (!io::queries_of(answer).empty())
    for (SceneInstance& posed : drawn) posed.pose = {};
  return drawn;
}

}  // namespace

std::string scene_glb(const Scene& scene, std::span<const SceneInstance> models, const SceneAnswer& answer,
                      const ViewOptions& options) {
  if (const auto* crowd = std::get_if<CrowdReport>(&answer))
    return recording_glb(record_crowd(crowd->question), options);
  if (const auto* crowd = std::get_if<CrowdWorldReport>(&answer))
    return recording_glb(record_crowd_world(crowd->question), options);
  if (const auto* sweep = std::get_if<SweepReport>(&answer))
    return recording_glb(record_sweep(models, *sweep), options);
  if (const auto* walk = std::get_if<WalkReport>(&answer)) return recording_glb(record_walk(models, *walk), options);
  const bool is_about_rest = options.hierarchy || options.partition || options.voronoi || options.voronoi_walk;
  if (is_about_rest && !io::queries_of(answer).empty())
    throw Error(
        "hierarchies, partitions, Voronoi regions and walks through them, of objects that move, are not in a GLB file; "
        "a page shows them: view_page, or -o FILE.html");
  const std::vector<SceneInstance> drawn = models_of(scene, models, answer);
  const io::ViewMeshes meshes(drawn, io::places_of(io::queries_of(answer)));
  io::GlbScene glb(drawn, meshes);
  io::add_objects(glb, answer);
  io::add_findings(glb, answer);
  if (const auto* trees = std::get_if<RebalanceReport>(&answer)) io::add_trees(glb, scene, *trees);
  if (options.hierarchy) io::add_hierarchies(glb, *options.hierarchy);
  if (options.partition) io::add_partitions(glb, *options.partition);
  if (options.voronoi) io::add_voronoi(glb);
  if (options.voronoi_walk) io::add_voronoi_walks(glb);
  return glb.file(options, scene.unit);
}

void write_glb(const std::string& glb, const std::filesystem::path& path) { write_output(glb, path, OutputKind::glb); }

}  // namespace toccata
