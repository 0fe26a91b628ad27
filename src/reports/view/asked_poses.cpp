#include "reports/view/asked_poses.hpp"

namespace toccata::io {

std::span<const PairQuery> queries_of(const SceneAnswer& answer) {
  if (const auto* poses = std::get_if<PosesReport>(&answer)) return poses->queries;
  if (const auto* poses = std::get_if<DistancePosesReport>(&answer)) return poses->queries;
  return {};
}

std::vector<SceneInstance> drawn_models(std::span<const SceneInstance> models, const SceneAnswer& answer) {
  std::vector<SceneInstance> drawn(models.begin(), models.end());
  const auto* cost = std::get_if<CostReport>(&answer);
  if (cost == nullptr || cost->question.queries.empty() || drawn.size() != 2) return drawn;
  drawn[0].pose = cost->question.queries.front().pose_a;
  drawn[1].pose = cost->question.queries.front().pose_b;
  return drawn;
}

}  // namespace toccata::io
