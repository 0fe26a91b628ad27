#pragma once

#include <span>

#include "io/formats/json.hpp"
#include "reports/view/view_data.hpp"
#include "toccata/methods/cost.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::io {

/// A layer for every mesh or height field: the levels of a hierarchy of these volumes. Throws Error when there are too
/// many meshes to be looked at.
[[nodiscard]] std::vector<Json> hierarchy_layers(std::span<const SceneInstance> models, CostVolume volume,
                                                 ViewData& data);

}  // namespace toccata::io
