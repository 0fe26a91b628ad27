#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/formats/json.hpp"
#include "reports/view/view_data.hpp"
#include "reports/view/view_meshes.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/shapes/convex_hull.hpp"

namespace toccata::io {

/// A convex polytope at its place: the hull of its vertices in the world. Throws Error naming an object that is none,
/// or has more than 2,000 vertices.
[[nodiscard]] ConvexHull world_polytope(const SceneInstance& posed);

/// The regions of a convex polytope as closed cells in the world, up to some distance: three corners of each triangle.
struct DrawnVoronoi {
  struct Kind {
    const char* label;  ///< "nearest to a face"
    std::vector<Vec3> corners;
  };
  std::string object;  ///< its name
  std::vector<Kind> kinds;
};

/// The drawn regions of every object. Throws Error as voronoi_layers does.
[[nodiscard]] std::vector<DrawnVoronoi> drawn_voronoi(std::span<const SceneInstance> models);

/// A layer for every convex polytope: its Voronoi regions as closed cells up to some distance, a step for each kind of
/// feature. Throws Error as `world_polytope`.
[[nodiscard]] std::vector<Json> voronoi_layers(std::span<const SceneInstance> models, const ViewMeshes& meshes,
                                               ViewData& data);

}  // namespace toccata::io
