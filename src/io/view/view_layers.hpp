#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "io/view/view_data.hpp"
#include "io/view/view_meshes.hpp"
#include "toccata/io/report.hpp"

namespace toccata::io {

/// The layers of a page that show what was found of pairs: their faces, the curves in which these meet, depths,
/// distances and normals (docs/reference/view-page.md).
[[nodiscard]] nlohmann::ordered_json pair_layers(const CheckReport& report, const ViewMeshes& meshes, ViewData& data);

}  // namespace toccata::io
