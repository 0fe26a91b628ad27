#include "reports/view/drawn_scene.hpp"

#include "reports/view/asked_poses.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::io {

DrawnScene drawn_scene(const Scene& scene, std::span<const SceneInstance> models, const SceneAnswer& answer) {
  if (const auto* parts = std::get_if<DecomposeReport>(&answer)) {
    Scene drawn = parts_scene(*parts, scene.unit);
    std::vector<SceneInstance> posed = scene_models(drawn, 1);
    return {std::move(drawn), std::move(posed)};
  }
  if (const auto* refined = std::get_if<SubdivideReport>(&answer); refined != nullptr && refined->mesh) {
    Scene drawn{.objects = {limit_object(*refined)}, .nodes = {}, .unit = scene.unit};
    std::vector<SceneInstance> posed = scene_models(drawn, 1);
    return {std::move(drawn), std::move(posed)};
  }
  DrawnScene drawn{scene, drawn_models(models, answer)};
  for (std::size_t i = 0; i < models.size(); ++i) drawn.scene.objects[i].pose = drawn.models[i].pose;
  const auto* sum = std::get_if<MinkowskiReport>(&answer);
  if (sum == nullptr) return drawn;
  Scene added;
  added.unit = scene.unit;
  added.objects.push_back(sum_object(*sum));
  drawn.models.push_back(scene_models(added, 1).front());
  drawn.scene.objects.push_back(std::move(added.objects.front()));
  return drawn;
}

}  // namespace toccata::io
