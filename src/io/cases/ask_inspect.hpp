#pragma once

#include "toccata/io/scene_question.hpp"

namespace toccata::io {

/// What each of them is, by itself.
[[nodiscard]] InspectReport ask_inspect(std::span<const SceneInstance> models, const InspectQuestion& question,
                                        const Progress& progress);

/// The same, with the sources of the scene's objects, which posed models do not know.
[[nodiscard]] InspectReport with_sources(InspectReport report, const Scene& scene);

}  // namespace toccata::io
