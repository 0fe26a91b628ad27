#include "io/cases/ask_inspect.hpp"

namespace toccata::io {
namespace {

SceneObject object_of(const SceneInstance& posed) {
  SceneObject object;
  object.name = posed.name;
  object.shape = posed.model.shape();
  object.pose = posed.pose;
  object.solid = posed.solid;
  object.group = posed.group;
  return object;
}

}  // namespace

InspectReport ask_inspect(std::span<const SceneInstance> models, const InspectQuestion& question,
                          const Progress& progress) {
  CostOptions options;
  options.progress = progress;
  InspectReport report;
  for (const SceneInstance& posed : models) {
    InspectedObject& inspected = report.objects.emplace_back(inspect(object_of(posed)));
    const auto mesh = inspected.object.mesh();
    if (mesh && question.faults) inspected.faults = mesh_faults(*mesh);
    if (mesh && question.volumes) inspected.volumes = measure_volumes(*mesh, options);
    if (mesh && question.partitions)
      inspected.partitions = measure_partitions(PartitionItems(*mesh), {1000, 1, progress});
  }
  return report;
}

InspectReport with_sources(InspectReport report, const Scene& scene) {
  for (std::size_t i = 0; i < report.objects.size(); ++i) report.objects[i].object.source = scene.objects[i].source;
  return report;
}

}  // namespace toccata::io
