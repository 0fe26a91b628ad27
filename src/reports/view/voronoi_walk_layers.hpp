#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/formats/json.hpp"
#include "reports/view/view_data.hpp"
#include "reports/view/view_meshes.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::io {

/// A pair of features that a walk visits, as it is drawn.
struct DrawnVisit {
  std::vector<Vec3> ends;  ///< of segments in the world: the way between the nearest points, edges, the way so far
  std::string label;       ///< "2 of 5"
  std::string note;        ///< which features, and how far apart they are
  double distance = 0;
};

/// The walk of a pair of objects, of these names.
struct DrawnWalk {
  std::string a, b;
  std::vector<DrawnVisit> visits;  ///< none where it is seen at once that the shapes meet
};

/// The drawn walks of every pair of objects. Throws Error as voronoi_walk_layers does.
[[nodiscard]] std::vector<DrawnWalk> drawn_voronoi_walks(std::span<const SceneInstance> models);

/// A layer for every pair of convex polytopes: the walk from a vertex of each through the Voronoi regions to the
/// nearest features, a step for each pair of features it visits: their edges, the way between them, and the way so far.
/// Throws Error naming an object that is none or has more than 2,000 vertices, and for more than 32 pairs or none.
[[nodiscard]] std::vector<Json> voronoi_walk_layers(std::span<const SceneInstance> models, const ViewMeshes& meshes,
                                                    ViewData& data);

}  // namespace toccata::io
