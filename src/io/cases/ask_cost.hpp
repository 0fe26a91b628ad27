#pragma once

#include "toccata/io/scene_question.hpp"

namespace toccata::io {

/// What a question about the two of them, which have to be meshes, costs.
[[nodiscard]] CostReport ask_cost(std::span<const SceneInstance> models, const CostQuestion& question,
                                  const Progress& progress);

}  // namespace toccata::io
