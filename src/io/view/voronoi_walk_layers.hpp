#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "io/view/view_data.hpp"
#include "io/view/view_meshes.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::io {

/// A layer for every pair of convex polytopes: the walk from a vertex of each through the Voronoi regions to the
/// nearest features, a step for each pair of features it visits: their edges, the way between them, and the way so far.
/// Throws Error naming an object that is none or has more than 2,000 vertices, and for more than 32 pairs or none.
[[nodiscard]] std::vector<nlohmann::ordered_json> voronoi_walk_layers(std::span<const Posed> models,
                                                                      const ViewMeshes& meshes, ViewData& data);

}  // namespace toccata::io
