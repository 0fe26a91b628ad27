#pragma once

#include <span>

#include "toccata/io/scene_question.hpp"

namespace toccata::io {

/// What is nearest to the points, and on which side of it they are.
[[nodiscard]] NearestReport ask_nearest(std::span<const SceneInstance> models, const NearestQuestion& question,
                                        const BatchOptions& batch);

}  // namespace toccata::io
