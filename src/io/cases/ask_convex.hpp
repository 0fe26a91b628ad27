#pragma once

#include "toccata/io/scene_question.hpp"

namespace toccata::io {

/// Throws Error where there is not one object, and as `decompose` does.
[[nodiscard]] DecomposeReport ask_decompose(std::span<const SceneInstance> models, const DecomposeQuestion& question,
                                            const AskOptions& options);

/// Throws Error where there are not two objects, for one that is not convex and bounded, and as `minkowski_sum` does.
[[nodiscard]] MinkowskiReport ask_minkowski(std::span<const SceneInstance> models, const MinkowskiQuestion& question);

}  // namespace toccata::io
