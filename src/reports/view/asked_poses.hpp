#pragma once

#include <span>
#include <vector>

#include "toccata/reports/scene_question.hpp"

namespace toccata::io {

/// Where the first two objects are in what was found, besides where the scene has them; none of other answers.
[[nodiscard]] std::span<const PairQuery> queries_of(const SceneAnswer& answer);

/// The models as they are drawn: of costs the first two where the first of the queries has them.
[[nodiscard]] std::vector<SceneInstance> drawn_models(std::span<const SceneInstance> models, const SceneAnswer& answer);

}  // namespace toccata::io
