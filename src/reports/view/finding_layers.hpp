#pragma once

#include <optional>
#include <vector>

#include "io/formats/json.hpp"
#include "reports/view/layer_writer.hpp"
#include "reports/view/view_data.hpp"
#include "reports/view/view_meshes.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata::io {

/// The layers of a page that show what was found (docs/reference/view-page.md): of pairs their faces, the curves in
/// which these meet, depths, distances and normals; of rays their ways; and so on. Findings are counted as the report
/// lists them, those of faces in a region by their objects.
[[nodiscard]] Json finding_layers(const SceneAnswer& answer, const ViewMeshes& meshes, ViewData& data);

// What several kinds of answers are drawn with.

/// What faces have in common; and besides, the faces themselves.
void add_contacts(LayerWriter& layers, const std::vector<ReportedFacePair>& pairs);
void add_intersecting_faces(LayerWriter& layers, Index a, Index b, const std::vector<ReportedFacePair>& pairs);
/// Nothing of those that do not overlap, or that meet.
void add_depth(LayerWriter& layers, const std::optional<Penetration>& depth);
void add_distance(LayerWriter& layers, const Distance& distance);
/// A normal of no length is left out.
void add_arrow(std::vector<Arrow>& arrows, const Vec3& point, const Vec3& normal);
void add_normals(LayerWriter& layers, const std::vector<ContactRegion>& regions,
                 const std::optional<Manifold>& manifold);

}  // namespace toccata::io
