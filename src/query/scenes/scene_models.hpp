#pragma once

#include <vector>

#include "toccata/core/function_ref.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata {

/// The same as `scene_models`, with models that `make` makes of the scene's shapes, on as many threads as it is given.
/// It is called from several threads at once, for each mesh once.
[[nodiscard]] std::vector<SceneInstance> scene_models_by(const Scene& scene, int threads,
                                                         FunctionRef<Model(const Shape& shape, int threads)> make);

}  // namespace toccata
