#pragma once

#include <span>

#include "io/formats/json.hpp"
#include "io/view/view_data.hpp"
#include "io/view/view_meshes.hpp"
#include "toccata/io/scene_question.hpp"

namespace toccata::io {

/// The layers of a page that show what was found (docs/reference/view-page.md): of pairs their faces, the curves in
/// which these meet, depths, distances and normals; of rays their ways; and so on. Findings are counted as the report
/// lists them, those of faces in a region by their objects.
[[nodiscard]] Json finding_layers(const SceneAnswer& answer, const ViewMeshes& meshes, ViewData& data);

}  // namespace toccata::io
